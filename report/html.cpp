// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace dmp::report {

std::string escaped(std::string_view text) {
    std::string result;
    result.reserve(text.size() + text.size() / 8);
    constexpr std::string_view replacement = "\xEF\xBF\xBD";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else if (c == '>') {
            result += "&gt;";
        } else if (c == '"') {
            result += "&quot;";
        } else if (c == '\'') {
            result += "&#39;";
        } else if ((c >= 0 && c < ' ' && c != '\n' && c != '\t') || c == 0x7f) {
            result += replacement;
        } else if (const auto code = text.substr(i, 3); code == "\xEF\xBF\xBE" || code == "\xEF\xBF\xBF") {
            result += replacement;
            i += 2;
        } else {
            result += c;
        }
    }
    return result;
}

std::string shortened(const std::string& text, std::size_t most) {
    if (text.size() <= most) return text;
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not within a character
    return text.substr(0, end) + " ...";
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    result.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) result += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
    }
    return result;
}

std::string number_text(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "not known"; }

std::string number_text(double value, std::string_view unit) {
    return std::isfinite(value) ? fmt::format("{:.6g} {}", value, unit) : "not known";
}

std::string short_cell(const std::string& cell) {
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return error == std::errc() && end == cell.data() + cell.size() && std::isfinite(value) ? number_text(value) : cell;
}

std::string wall_time_text(double seconds) {
    if (!std::isfinite(seconds)) return "not known";
    if (seconds < 120) return fmt::format("{:.3g} s", seconds);
    return seconds < 7200 ? fmt::format("{:.1f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

std::string section(std::string_view id, std::string_view title, std::string_view content) {
    return fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n<h2 id=\"{0}-heading\">{1}</h2>\n{2}</section>\n",
        escaped(id), escaped(title), content);
}

std::string table(std::string_view caption, const std::vector<std::string>& heading,
                  const std::vector<std::vector<std::string>>& rows, std::size_t first_number) {
    const auto kind = [&](std::size_t column) { return column >= first_number ? " class=\"number\"" : ""; };
    std::string text = fmt::format(
        "<div class=\"scrolls\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\"><table>\n"
        "<caption>{0}</caption>\n<thead><tr>",
        escaped(caption));
    for (std::size_t k = 0; k < heading.size(); ++k)
        text += fmt::format("<th scope=\"col\"{}>{}</th>", kind(k), escaped(heading[k]));
    text += "</tr></thead>\n<tbody>\n";
    for (const auto& row : rows) {
        text += "<tr>";
        for (std::size_t k = 0; k < row.size(); ++k)
            text += k == 0 ? fmt::format("<th scope=\"row\">{}</th>", escaped(row[k]))
                           : fmt::format("<td{}>{}</td>", kind(k), escaped(row[k]));
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

std::string list(const std::vector<std::pair<std::string, std::string>>& items) {
    std::string text = "<dl>\n";
    for (const auto& [name, value] : items) {
        if (!name.empty()) text += "<dt>" + escaped(name) + "</dt>";
        text += "<dd>" + escaped(value) + "</dd>\n";
    }
    return text + "</dl>\n";
}

}  // namespace dmp::report
