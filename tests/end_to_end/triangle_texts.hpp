// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "geometry/triangle_surface.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// One solid of an STL text.
inline std::string stl_text(const TriangleSurface& surface, const std::string& name) {
    std::string text = "solid " + name + "\n";
    for (const auto& triangle : surface.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : triangle) {
            const Vec& position = surface.corners[static_cast<std::size_t>(corner)];
            text += fmt::format("vertex {:.9g} {:.9g} {:.9g}\n", position[0], position[1], position[2]);
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

/// A binary STL file; its header begins with "solid", as many do.
inline std::string stl_binary(const TriangleSurface& surface) {
    std::string text = "solid in binary";
    text.resize(80, ' ');
    const auto add = [&](std::uint32_t bits) {
        for (unsigned byte = 0; byte < 4; ++byte) text += static_cast<char>(bits >> (8 * byte) & 0xffU);
    };
    add(static_cast<std::uint32_t>(surface.triangles.size()));
    for (const auto& triangle : surface.triangles) {
        for (int k = 0; k < 3; ++k) add(0);
        for (const int corner : triangle)
            for (const double x : surface.corners[static_cast<std::size_t>(corner)])
                add(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
        text += std::string(2, '\0');
    }
    return text;
}

/// A scene in 3-D whose fluid is the geometry's "body" and whose wall is all of its surface, "skin".
inline std::string scene_of(const std::string& file, const std::string& spacing = "0.1 mm",
                            const std::string& unit = "1 mm") {
    return "schema = 1\ndimension = 3\n[geometry]\nfile = \"" + file + "\"\n" +
           (unit.empty() ? "" : "unit = \"" + unit + "\"\n") +
           "[[select]]\nname = \"skin\"\nof = \"body\"\nfrom = [\"-1e9 m\", \"-1e9 m\", \"-1e9 m\"]\n"
           "to = [\"1e9 m\", \"1e9 m\", \"1e9 m\"]\n[particles]\nspacing = \"" +
           spacing +
           "\"\n[[part]]\nname = \"body\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 mPa*s\"\n"
           "[[part]]\nname = \"skin\"\nkind = \"rigid\"\n[flow]\nlargest_speed = \"1 m/s\"\n"
           "[run]\nduration = \"1 ms\"\n[output]\nevery = \"1 ms\"\npictures = false\n";
}

}  // namespace dmp::tests
