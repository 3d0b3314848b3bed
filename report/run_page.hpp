// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run_files.hpp"

namespace dmp::report {

/// The page of a run: HTML that needs nothing else. What came from files stands in it escaped. Throws InputError where
/// summary.json has something else than it should.
[[nodiscard]] std::string run_page(const RunFiles& run);

}  // namespace dmp::report
