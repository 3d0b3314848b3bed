// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dmp::report {

/// A page: `content` is what <main> holds. `data`: JSON without "<" that `scripts` read from the element "page-data";
/// "": no scripts. uPlot and its licence are put before them.
[[nodiscard]] std::string page_text(const std::string& title, const std::string& content, const std::string& data,
                                    std::string_view scripts);

/// JSON as it can stand in a <script>.
[[nodiscard]] std::string without_markup(std::string json);

/// A box with a heading and a list; "" where there are no lines.
[[nodiscard]] std::string box(const std::string& kind, const std::string& heading,
                              const std::vector<std::string>& lines);

[[nodiscard]] std::string or_unknown(std::string text);

/// <nav>: anchors and their names.
[[nodiscard]] std::string navigation(const std::vector<std::pair<std::string, std::string>>& anchors);

}  // namespace dmp::report
