// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace dmp::report {

// Texts that CMake takes from files: page.css, *.js and third_party.
extern const std::string_view page_style;
extern const std::string_view axes_script;      ///< of all pages with scripts
extern const std::string_view page_script;      ///< plots of the page of a run
extern const std::string_view particle_script;  ///< particles of the page of a run
extern const std::string_view study_script;     ///< of the page of a study
extern const std::string_view uplot_style, uplot_script, uplot_licence;
extern const std::string_view three_script, three_licence;

}  // namespace dmp::report
