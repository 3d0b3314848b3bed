// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names this one uses without qualification (docs/architecture.md).
namespace dmp::geometry {}
namespace dmp::mesher {}
namespace dmp::models {}
namespace dmp::particles {}
namespace dmp::scene {}
namespace dmp::simd {}
namespace dmp::solver {}

namespace dmp::bench {

using namespace geometry;
using namespace mesher;
using namespace models;
using namespace particles;
using namespace scene;
using namespace simd;
using namespace solver;

}  // namespace dmp::bench
