// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tests of every module name its things without qualification.
namespace dmp::geometry {}
namespace dmp::mesher {}
namespace dmp::particles {}
namespace dmp::postproc {}
namespace dmp::scene {}
namespace dmp::solver {}

namespace dmp::tests {

using namespace geometry;
using namespace mesher;
using namespace particles;
using namespace postproc;
using namespace scene;
using namespace solver;

}  // namespace dmp::tests
