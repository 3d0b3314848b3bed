// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace dmp::cli {

std::string count_text(std::size_t count) {
    std::string digits = std::to_string(count);
    for (auto at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), " ");
    return digits;
}

std::string count_text(std::size_t count, std::string_view word) {
    return fmt::format("{} {}{}", count_text(count), word, count == 1 ? "" : "s");
}

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds)) return "unknown";
    if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
    if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
    if (seconds < 59.95) return fmt::format("{:.3g} s", seconds);
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    if (whole < 48LL * 3600) return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
    return fmt::format("{} days {} h", whole / 86400, whole % 86400 / 3600);
}

std::string bytes_text(double bytes) {
    constexpr std::array<const char*, 5> units{"B", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    while (bytes >= 1024 && unit + 1 < units.size()) {
        bytes /= 1024;
        ++unit;
    }
    return fmt::format("{:.{}f} {}", bytes, unit == 0 || bytes >= 100 ? 0 : 1, units.at(unit));
}

std::string quantity_text(double value, std::string_view unit) { return fmt::format("{:.4g} {}", value, unit); }

std::string part_text(double part) { return std::isnan(part) ? "-" : percentage_text(part); }

std::string percent_text(double fraction) { return fmt::format("{:+.2g} %", fraction * 100); }

std::string table_text(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    std::string text;
    for (const auto& row : rows) {
        std::string line = " ";
        for (std::size_t k = 0; k < row.size(); ++k) line += fmt::format(" {:<{}} ", row[k], widths[k]);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string Listing::text() const {
    std::size_t width = 0;
    for (const auto& [name, text] : lines_) width = std::max(width, name.size());
    std::string result;
    for (const auto& [name, text] : lines_) result += fmt::format("{:{}}{:<{}}  {}\n", "", indent_, name, width, text);
    return result;
}

}  // namespace dmp::cli
