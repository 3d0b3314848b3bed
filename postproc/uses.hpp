// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names are used here without qualification (docs/architecture.md).
namespace dmp::solver {}
namespace dmp::particles {}
namespace dmp::scene {}

namespace dmp::postproc {

using namespace solver;
using namespace particles;
using namespace scene;

}  // namespace dmp::postproc
