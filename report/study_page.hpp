// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/study_files.hpp"

namespace dmp::report {

/// The page of a study: HTML that needs nothing else, with links to the pages of its runs. What came from files stands
/// in it escaped.
[[nodiscard]] std::string study_page(const StudyFiles& study);

}  // namespace dmp::report
