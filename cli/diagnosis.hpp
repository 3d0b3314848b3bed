// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/machine.hpp"
#include "cli/version.hpp"

namespace dmp::cli {

enum class Health { ok, warn, bad };

/// One thing the doctor looked at.
struct Finding {
    Health health = Health::ok;
    std::string what;     ///< "memory"
    std::string found;    ///< "7.6 GiB, 6.1 GiB free"
    std::string to_do{};  ///< empty when nothing need be done
};

[[nodiscard]] std::vector<Finding> diagnose(const BuildFacts& build, const Machine& machine);

}  // namespace dmp::cli
