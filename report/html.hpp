// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dmp::report {

/// Text as it stands in an element or in a quoted attribute: whatever it holds shows as text. Control characters other
/// than tabs and ends of lines, and U+FFFE and U+FFFF, which XML does not have, become U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// At most so many bytes of a text in UTF-8, and where there were more, " ...".
[[nodiscard]] std::string shortened(const std::string& text, std::size_t most);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Six digits, "not known" for what is no number.
[[nodiscard]] std::string number_text(double value);
/// The same with a unit.
[[nodiscard]] std::string number_text(double value, std::string_view unit);

/// The cell of a table as a page shows it: a number with six digits, another text as it is.
[[nodiscard]] std::string short_cell(const std::string& cell);

/// "26.3 s", "4.2 min", "11.5 h".
[[nodiscard]] std::string wall_time_text(double seconds);

/// <section> with a heading and an id.
[[nodiscard]] std::string section(std::string_view id, std::string_view title, std::string_view content);

/// A table, cells escaped. Columns from `first_number` on are aligned as numbers. Wider than the page it scrolls, also
/// by keyboard. `caption` is also its name for screen readers.
[[nodiscard]] std::string table(std::string_view caption, const std::vector<std::string>& heading,
                                const std::vector<std::vector<std::string>>& rows, std::size_t first_number = 1);

/// <dl>: names and what belongs to them, escaped. An empty name goes on with the one before.
[[nodiscard]] std::string list(const std::vector<std::pair<std::string, std::string>>& items);

}  // namespace dmp::report
