// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "geometry/triangle_file.hpp"
#include "geometry/word_lines.hpp"

namespace dmp::geometry {

namespace {

constexpr std::size_t header_bytes = 80, bytes_per_triangle = 50;
constexpr const char* export_again = "export the surface again, as STL, text or binary";

std::uint32_t whole_number(const char* bytes) {
    std::uint32_t value = 0;
    for (int byte = 3; byte >= 0; --byte) value = value << 8U | static_cast<unsigned char>(bytes[byte]);
    return value;
}

/// The length that a binary file with this beginning has; 0: too short for one.
std::size_t binary_length(std::string_view contents) {
    if (contents.size() < header_bytes + 4) return 0;
    return header_bytes + 4 +
           bytes_per_triangle * static_cast<std::size_t>(whole_number(contents.data() + header_bytes));
}

std::string lower_case(std::string_view word) {
    std::string text(word);
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_text(std::string_view contents) {
    const std::string_view beginning = contents.substr(0, 512);
    const auto first = beginning.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && lower_case(beginning.substr(first, 5)) == "solid" &&
           beginning.find('\0') == std::string_view::npos;
}

TriangleSoup read_binary(std::string_view contents, const std::string& file) {
    SoupBuilder builder;
    for (std::size_t at = header_bytes + 4; at < contents.size(); at += bytes_per_triangle) {
        std::array<int, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            Vec position = Vec::Zero();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint32_t bits = whole_number(contents.data() + at + 12 * (c + 1) + 4 * axis);
                position[static_cast<Eigen::Index>(axis)] = static_cast<double>(std::bit_cast<float>(bits));
            }
            if (!position.allFinite())
                throw InputError(SourceLocation{file, 0, 0},
                                 "triangle " + std::to_string((at - header_bytes) / bytes_per_triangle) +
                                     " has a corner that is not finite",
                                 "export the surface again");
            corners.at(c) = builder.corner(position);
        }
        builder.add_triangle(corners[0], corners[1], corners[2]);
    }
    return builder.finish();
}

/// What stands after the first word of a line.
std::string rest_of(const TokenLines& lines) {
    if (lines.words().size() < 2) return "";
    const char* begin = lines.words()[1].data();
    const char* end = lines.words().back().data() + lines.words().back().size();
    return {begin, end};
}

TriangleSoup read_text(std::string_view contents, const std::string& file) {
    SoupBuilder builder;
    TokenLines lines(contents);
    std::array<int, 3> corners{};
    std::size_t corner = 0;
    bool ended = false;
    const auto fault = [&](const std::string& problem) {
        return InputError(SourceLocation{file, lines.number(), 1}, problem, export_again);
    };
    while (lines.next_with_tokens()) {
        const auto& words = lines.words();
        const std::string first = lower_case(words[0]);
        if (first == "vertex") {
            Vec position = Vec::Constant(NAN);
            for (std::size_t axis = 0; axis < 3 && axis + 1 < words.size(); ++axis)
                position[static_cast<Eigen::Index>(axis)] = number_in(words[axis + 1]).value_or(NAN);
            if (!position.allFinite())
                throw fault("expected three numbers after 'vertex', found " + in_quotes(lines.line()));
            if (corner == 3) throw fault("a triangle has more than three corners, or no 'endfacet'");
            corners.at(corner++) = builder.corner(position);
            ended = false;
        } else if (first == "endfacet") {
            if (corner != 3) throw fault("a triangle has " + std::to_string(corner) + " corners");
            builder.add_triangle(corners[0], corners[1], corners[2]);
            corner = 0;
        } else if (first == "endsolid" || first == "solid" || first == "facet") {
            if (corner > 0) throw fault("the triangle before this line has no 'endfacet'");
            if (first == "solid") builder.begin_group(rest_of(lines));
            ended = first == "endsolid";
        } else if (first != "outer" && first != "endloop") {
            throw fault(in_quotes(words[0], '\'') + " is no word of an STL file");
        }
    }
    if (!ended) throw fault("the file ends before 'endsolid'");
    return builder.finish();
}

}  // namespace

TriangleSoup read_stl_text(std::string_view text, const std::string& file) {
    const std::size_t length = binary_length(text);
    // The right length has every binary file, and hardly a text; many a binary file begins with "solid", too.
    if (length > 0 && text.size() == length) return read_binary(text, file);
    if (is_text(text)) return read_text(text, file);
    std::string problem = "'" + file + "' is no STL file, or a binary one that was cut off";
    if (length > 0 && length < text.size()) problem = "'" + file + "' is no STL file, or a binary one and more";
    if (length > 0)
        problem += ": for its " + std::to_string((length - header_bytes - 4) / bytes_per_triangle) +
                   " triangles it needs " + std::to_string(length) + " bytes, and it has " +
                   std::to_string(text.size());
    throw InputError(SourceLocation{file, 0, 0}, problem, export_again);
}

}  // namespace dmp::geometry
