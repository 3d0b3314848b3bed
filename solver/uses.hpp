// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names this one uses without qualification (docs/architecture.md).
namespace dmp::models {}
namespace dmp::particles {}
namespace dmp::scene {}
namespace dmp::simd {}

namespace dmp::solver {

using namespace models;
using namespace particles;
using namespace scene;
using namespace simd;

}  // namespace dmp::solver
