// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names are used here without qualification (docs/architecture.md).
namespace dmp::postproc {}
namespace dmp::solver {}

namespace dmp::report {

using namespace postproc;
using namespace solver;

}  // namespace dmp::report
