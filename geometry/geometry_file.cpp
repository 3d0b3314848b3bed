// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "base/length_text.hpp"
#include "geometry/geo_text.hpp"
#include "geometry/number_text.hpp"
#include "geometry/triangle_file.hpp"

namespace dmp::geometry {

namespace {

constexpr std::string_view formats_read =
    "dmp reads .geo, .geo_unrolled, .msh, .step, .stp, .iges, .igs, .brep, .stl, .obj, .ply and .off geometries.";

std::string extension_of(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void check_blocks(const std::string& file) {
    constexpr std::uintmax_t largest_script = 1U << 28U;
    std::error_code error;
    if (std::filesystem::file_size(file, error) > largest_script)
        throw InputError({.file = file}, "a script of more than 256 MiB",
                         "Save the geometry as a mesh or a STEP file.");
    const GeoText text(file_text(file));
    if (const auto open = text.unclosed_block()) {
        const bool beginning = !open->word.starts_with("End");
        const std::string partner = beginning ? "End" + open->word : open->word.substr(3);
        throw InputError({.file = file, .line = open->line}, "'" + open->word + "' without its '" + partner + "'",
                         "Add '" + partner + "'; gmsh itself does not notice.");
    }
    if (const int line = text.line_cut_short(); line > 0) {
        throw InputError({.file = file, .line = line}, "several statements on a last line without line break",
                         "End the file with a line break; gmsh drops all but the first of them.");
    }
}

}  // namespace

bool is_script(const std::string& file) {
    const std::string extension = extension_of(file);
    return extension == ".geo" || extension == ".geo_unrolled";
}

bool is_cad_file(const std::string& file) {
    const std::string extension = extension_of(file);
    return states_its_unit(file) || extension == ".brep";
}

bool states_its_unit(const std::string& file) {
    const std::string extension = extension_of(file);
    return extension == ".step" || extension == ".stp" || is_iges_file(file);
}

bool is_iges_file(const std::string& file) {
    const std::string extension = extension_of(file);
    return extension == ".iges" || extension == ".igs";
}

bool needs_a_unit(const std::string& file) {
    return is_triangle_file(file) || (is_cad_file(file) && !states_its_unit(file));
}

bool has_straight_edges_only(const std::string& file) { return is_triangle_file(file) || extension_of(file) == ".msh"; }

std::string file_text(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw InputError({.file = file}, "the geometry cannot be read", "Check its permissions.");
    return text;
}

void check_geometry_file(const GeometryOptions& options) {
    const std::string& file = options.file;
    const std::string cad_geometry = "the geometry '" + file + "'";
    const auto refuse = [&](const std::string& what, const std::string& what_to_do) {
        throw InputError(options.location, what, what_to_do);
    };
    if (!(options.metres() > 0) || !std::isfinite(options.metres())) {
        refuse("the geometry's unit must be a positive length", "Give it as a length, like \"1 mm\".");
    }
    if (!(options.chord_error > 0)) {
        refuse("the chord error must be a positive length", "Give it as a length, like \"1 um\".");
    }
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (std::filesystem::is_directory(status)) refuse(cad_geometry + " is a folder", "Name a file in it.");
    if (!std::filesystem::exists(status)) refuse(cad_geometry + " does not exist", "Check the path.");
    const std::string extension = extension_of(file);
    if (!is_script(file) && extension != ".msh" && !is_cad_file(file) && !is_triangle_file(file)) {
        refuse(cad_geometry + (extension.empty() ? " has no extension" : ": unknown extension " + extension),
               std::string(formats_read));
    }
    if (!std::filesystem::is_regular_file(status) || !std::ifstream(file)) {
        refuse(cad_geometry + " cannot be read", "Check its permissions.");
    }
    if (std::filesystem::file_size(file, error) == 0) refuse(cad_geometry + " is empty", "Save or export it again.");
    if (states_its_unit(file) && options.metres() != 1) {
        refuse(cad_geometry + " states its unit itself, and the scene gives another",
               "Leave geometry.unit out, or correct the unit in the program that made the geometry.");
    }
    if (!is_script(file) && !options.parameters.empty()) {
        const auto& [name, value] = *options.parameters.begin();
        const auto location = options.parameter_locations.find(name);
        throw InputError(location == options.parameter_locations.end() ? options.location : location->second,
                         "the geometry '" + file + "' offers no constant '" + name + "' for setting",
                         extension == ".msh" ? "A mesh has no parameters; give its .geo script."
                                             : "Only .geo scripts have parameters.");
    }
    if (is_script(file)) check_blocks(file);
}

void check_coordinates(const Vec& position, const std::string& file) {
    constexpr double furthest = 1e12;
    if (!position.allFinite())
        throw InputError({.file = file}, "the geometry has a point without finite coordinates",
                         "Check the geometry, or the parameters it was given.");
    if (position.cwiseAbs().maxCoeff() > furthest)
        throw InputError(
            {.file = file},
            "the geometry has a point at " + position_text(position) + ", further out than any geometry can mean",
            "Check the geometry and its unit (geometry.unit; on the command line --unit).");
}

}  // namespace dmp::geometry
