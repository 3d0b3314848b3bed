// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/version.hpp"

namespace dmp::cli {

BuildFacts build_facts() {
    return {DMP_VERSION, DMP_BUILD_TYPE, DMP_COMPILER, DMP_SANITIZERS, workstation_libraries()};
}

}  // namespace dmp::cli
