// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names this one uses without qualification (docs/architecture.md).
namespace dmp::geometry {}
namespace dmp::mesher {}
namespace dmp::models {}
namespace dmp::particles {}
namespace dmp::postproc {}
namespace dmp::report {}
namespace dmp::scene {}
namespace dmp::solver {}

namespace dmp::cli {

using namespace geometry;
using namespace mesher;
using namespace models;
using namespace particles;
using namespace postproc;
using namespace report;
using namespace scene;
using namespace solver;

}  // namespace dmp::cli
