// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "mesher/geometry_options.hpp"
#include "mesher/mesh.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests {

/// A scene with everything that was made of it.
struct Meshed {
    Scene scene;
    Geometry geometry;
    ParticleSet particles;
    MeshReport report;
};

inline Meshed mesh_file(const std::string& file, const std::vector<std::string>& overrides = {}) {
    Meshed meshed;
    meshed.scene = read_scene(file, overrides);
    const Scene& scene = meshed.scene;
    GeometryOptions options = geometry_options_of(scene);
    options.file = std::filesystem::path(options.file).lexically_normal().string();
    meshed.geometry = read_geometry(options);
    MeshResult result = mesh(meshed.geometry, scene);
    meshed.particles = std::move(result.particles);
    meshed.report = std::move(result.report);
    return meshed;
}

inline Meshed mesh_case(const std::string& name, const std::vector<std::string>& overrides = {}) {
    return mesh_file(DMP_SOURCE_DIR "/cases/" + name, overrides);
}

/// A scene and its geometry, "channel.geo", as texts.
struct Texts {
    std::string scene;
    std::string cad_geometry;

    /// With `found`, which must stand in the scene or the geometry, replaced once.
    [[nodiscard]] Texts with(const std::string& found, const std::string& replacement) const {
        Texts changed = *this;
        for (std::string* text : {&changed.scene, &changed.cad_geometry})
            if (const auto at = text->find(found); at != std::string::npos) {
                text->replace(at, found.size(), replacement);
                return changed;
            }
        throw std::logic_error("the test's texts have no " + found);
    }
};

/// A polygon with these corners [m], which makes the area `name`; its side n goes from corner n to the next one and is
/// Gmsh's curve n, from 1 on.
inline std::string polygon(const std::vector<std::array<double, 2>>& corners, const std::string& name) {
    std::ostringstream points, lines, loop;
    points.precision(17);
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const std::size_t number = n + 1;
        points << "Point(" << number << ") = {" << corners[n][0] << ", " << corners[n][1] << ", 0};\n";
        lines << "Line(" << number << ") = {" << number << ", " << number % corners.size() + 1 << "};\n";
        loop << (n > 0 ? ", " : "") << number;
    }
    return points.str() + lines.str() + "Curve Loop(1) = {" + loop.str() +
           "};\nPlane Surface(1) = {1};\nPhysical Surface(\"" + name + "\") = {1};\n";
}

/// A channel of 4 m x 2 m between two walls, periodic along x. Its lattice of 1/8 m is exact in binary.
inline const Texts channel{R"(schema = 1
[geometry]
file = "channel.geo"
[particles]
spacing = "0.125 m"
[[part]]
name = "water"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 mPa*s"
[[part]]
name = "wall"
kind = "rigid"
[flow]
periodic = ["x"]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
                           R"(Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Point(3) = {4, 2, 0};
Point(4) = {0, 2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("water") = {1};
Physical Curve("wall") = {1, 3};
)"};

/// The channel with a flexible flap from the middle of its bottom, clamped there.
inline const Texts flap_channel{channel.scene + R"([[part]]
name = "flap"
kind = "elastic"
bending_stiffness = "3 N*m^2"
axial_stiffness = "100 N"
mass_per_length = "10 kg/m"
anchor = "root"
)",
                                channel.cad_geometry + R"(Point(10) = {2, 0, 0};
Point(11) = {2, 1, 0};
Line(10) = {10, 11};
Physical Curve("flap") = {10};
Physical Point("root") = {10};
)"};

inline Meshed mesh_texts(const Texts& texts) {
    const Folder folder;
    Folder::write(texts.scene);
    Folder::write(texts.cad_geometry, "channel.geo");
    return mesh_file("scene.toml");
}

/// What meshing says is wrong: "scene.toml:8:11: ...\n  what to do".
inline std::string fault_of(const Texts& texts) {
    try {
        (void)mesh_texts(texts);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace dmp::tests
