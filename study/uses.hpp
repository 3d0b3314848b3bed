// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The modules whose names this one uses without qualification (docs/architecture.md).
namespace dmp::models {}
namespace dmp::scene {}

namespace dmp::study {

using namespace models;
using namespace scene;

}  // namespace dmp::study
