// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names this one uses without qualification (docs/architecture.md).
namespace dmp::geometry {}
namespace dmp::models {}
namespace dmp::particles {}
namespace dmp::scene {}

namespace dmp::mesher {

using namespace geometry;
using namespace models;
using namespace particles;
using namespace scene;

}  // namespace dmp::mesher
