// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace dmp::report {

// Texts that CMake takes from files: page.css, page.js and third_party/uplot.
extern const std::string_view page_style, page_script;
extern const std::string_view uplot_style, uplot_script, uplot_licence;

}  // namespace dmp::report
