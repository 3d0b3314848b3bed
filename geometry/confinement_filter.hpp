// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <linux/filter.h>

namespace dmp::geometry {

/// The program that the kernel runs at each system call of a confined process (seccomp). A list of what is allowed:
/// all else fails with EPERM, and what starts programs ends the process. Empty for processors that it is not written
/// for.
[[nodiscard]] std::vector<sock_filter> confinement_filter();

}  // namespace dmp::geometry
