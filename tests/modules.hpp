// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tests name the things of every module without qualification.
namespace dmp::geometry {}
namespace dmp::mesher {}
namespace dmp::models {}
namespace dmp::particles {}
namespace dmp::postproc {}
namespace dmp::report {}
namespace dmp::scene {}
namespace dmp::simd {}
namespace dmp::solver {}
namespace dmp::study {}

namespace dmp::tests {

using namespace geometry;
using namespace mesher;
using namespace models;
using namespace particles;
using namespace postproc;
using namespace report;
using namespace scene;
using namespace simd;
using namespace solver;
using namespace study;

}  // namespace dmp::tests
