// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Modules whose names this one uses without qualification (docs/architecture.md).
namespace dmp::geometry {}
namespace dmp::mesher {}
namespace dmp::particles {}
namespace dmp::scene {}
namespace dmp::solver {}

namespace dmp::bench {

using namespace geometry;
using namespace mesher;
using namespace particles;
using namespace scene;
using namespace solver;

}  // namespace dmp::bench
