// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Modules whose names this one uses without qualification (docs/architecture.md).
namespace dmp::particles {}
namespace dmp::scene {}

namespace dmp::solver {

using namespace particles;
using namespace scene;

}  // namespace dmp::solver
