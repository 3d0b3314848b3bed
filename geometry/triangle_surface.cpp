// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_surface.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace dmp {

namespace {

constexpr std::size_t header_bytes = 80, bytes_per_triangle = 50;

/// Adds triangles, whose corners it finds again.
class Builder {
  public:
    explicit Builder(double unit) : unit_(unit) {}

    void add(const std::array<Vec, 3>& corners) {
        std::array<int, 3> numbers{};
        for (std::size_t c = 0; c < 3; ++c) numbers.at(c) = number_of(unit_ * corners.at(c));
        const auto at = [&](std::size_t c) -> const Vec& {
            return surface_.corners[static_cast<std::size_t>(numbers.at(c))];
        };
        if ((at(1) - at(0)).cross(at(2) - at(0)).norm() > 0)
            surface_.triangles.push_back(numbers);
        else
            ++surface_.left_out;
    }
    TriangleSurface finish() { return std::move(surface_); }

  private:
    int number_of(const Vec& corner) {
        const std::array<double, 3> key{corner[0] + 0.0, corner[1] + 0.0, corner[2] + 0.0};  // -0 is 0
        const auto [found, is_new] = numbers_.try_emplace(key, static_cast<int>(surface_.corners.size()));
        if (is_new) surface_.corners.emplace_back(key[0], key[1], key[2]);
        return found->second;
    }

    double unit_;
    std::map<std::array<double, 3>, int> numbers_;
    TriangleSurface surface_;
};

std::uint32_t whole_number(const char* bytes) {
    std::uint32_t value = 0;
    for (int byte = 3; byte >= 0; --byte) value = value << 8U | static_cast<unsigned char>(bytes[byte]);
    return value;
}

/// The number of triangles if the length is right for it, as it is of every binary file and hardly a text.
bool is_binary(const std::string& contents) {
    if (contents.size() < header_bytes + 4) return false;
    return contents.size() ==
           header_bytes + 4 +
               bytes_per_triangle * static_cast<std::size_t>(whole_number(contents.data() + header_bytes));
}

TriangleSurface read_binary(const std::string& contents, double unit, const std::string& file) {
    Builder builder(unit);
    for (std::size_t at = header_bytes + 4; at < contents.size(); at += bytes_per_triangle) {
        std::array<Vec, 3> corners;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint32_t bits = whole_number(contents.data() + at + 12 * (c + 1) + 4 * axis);
                const auto value = static_cast<double>(std::bit_cast<float>(bits));
                if (!std::isfinite(value))
                    throw InputError(Place{file, 0, 0},
                                     "triangle " + std::to_string((at - header_bytes) / bytes_per_triangle) +
                                         " has a corner that is not finite",
                                     "export the surface again");
                corners.at(c)[static_cast<Eigen::Index>(axis)] = value;
            }
        builder.add(corners);
    }
    return builder.finish();
}

TriangleSurface read_text(const std::string& contents, double unit, const std::string& file) {
    Builder builder(unit);
    std::istringstream lines(contents);
    std::string line;
    std::array<Vec, 3> corners;
    std::size_t corner = 0;
    int number = 0;
    bool ended = false;
    const auto fault = [&](const std::string& problem) {
        return InputError(Place{file, number, 1}, problem, "export the surface again, as STL, text or binary");
    };
    while (std::getline(lines, line)) {
        ++number;
        std::istringstream words(line);
        std::string first;
        if (!(words >> first)) continue;
        if (first == "vertex") {
            std::array<double, 3> values{};
            for (double& value : values) {
                std::string word;
                words >> word;
                char* end = nullptr;
                value = std::strtod(word.c_str(), &end);
                if (word.empty() || *end != '\0' || !std::isfinite(value))
                    throw fault("expected three numbers after 'vertex', found \"" + line + "\"");
            }
            if (corner == 3) throw fault("a triangle has more than three corners");
            corners.at(corner++) = {values[0], values[1], values[2]};
        } else if (first == "endfacet") {
            if (corner != 3) throw fault("a triangle has " + std::to_string(corner) + " corners");
            builder.add(corners);
            corner = 0;
        } else if (first == "endsolid") {
            ended = true;
        } else if (first != "solid" && first != "facet" && first != "outer" && first != "endloop") {
            throw fault("'" + first + "' is no word of an STL file");
        }
    }
    if (!ended) throw fault("the file ends before 'endsolid'");
    return builder.finish();
}

}  // namespace

double TriangleSurface::area() const {
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const Vec& corner = corners[static_cast<std::size_t>(a)];
        sum +=
            0.5 *
            (corners[static_cast<std::size_t>(b)] - corner).cross(corners[static_cast<std::size_t>(c)] - corner).norm();
    }
    return sum;
}

TriangleSurface read_stl(const std::string& file, double unit, const Place& place) {
    std::ifstream stream(file, std::ios::binary);
    std::string contents{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.is_open() || stream.bad())
        throw InputError(place, "'" + file + "' cannot be read", "check the file's name and permissions");
    TriangleSurface surface;
    if (is_binary(contents)) {
        surface = read_binary(contents, unit, file);
    } else {
        const auto begin = contents.find_first_not_of(" \t\r\n");
        if (begin == std::string::npos || contents.compare(begin, 5, "solid") != 0)
            throw InputError(place, "'" + file + "' is no STL file, or a binary one that was cut off",
                             "export the surface again, as STL, text or binary");
        surface = read_text(contents, unit, file);
    }
    if (surface.triangles.empty())
        throw InputError(place, "'" + file + "' has no triangle with an area", "export the surface again");
    return surface;
}

}  // namespace dmp
