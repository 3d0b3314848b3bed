// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names are used here without qualification (docs/architecture.md).
namespace dmp::simd {}

namespace dmp::models {

using namespace simd;

}  // namespace dmp::models
