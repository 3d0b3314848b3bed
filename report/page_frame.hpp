// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dmp::report {

/// What a page runs: each script in an element of its own, after the data that they read and what all pages have in
/// common.
struct PageScripts {
    std::vector<std::pair<std::string, std::string>> data;  ///< ids of elements, and JSON without "<"
    std::vector<std::string> scripts;
};

/// uPlot with its licence, for the scripts that draw plots.
[[nodiscard]] std::string plotting_library();
/// three.js with its licence, for the script that draws particles.
[[nodiscard]] std::string drawing_library();

/// A page: `content` is what <main> holds. Without data it has no scripts.
[[nodiscard]] std::string page_text(const std::string& title, const std::string& content, const PageScripts& run);

/// JSON as it can stand in a <script>.
[[nodiscard]] std::string without_markup(std::string json);

/// A box with a heading and a list; "" where there are no lines.
[[nodiscard]] std::string box(const std::string& kind, const std::string& heading,
                              const std::vector<std::string>& lines);

[[nodiscard]] std::string or_unknown(std::string text);

/// <nav>: anchors and their names.
[[nodiscard]] std::string navigation(const std::vector<std::pair<std::string, std::string>>& anchors);

}  // namespace dmp::report
