// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/geometry_report.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/length_text.hpp"
#include "cli/mesh_geometry.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "geometry/flat_ends.hpp"
#include "geometry/geometry_file.hpp"
#include "geometry/solids_that_meet.hpp"
#include "geometry/surface_box.hpp"
#include "geometry/surface_edges.hpp"
#include "geometry/surface_pieces.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Lengths in the unit that suits the geometry's size.
struct Scale {
    double metres = 1;
    std::string unit = "m";

    [[nodiscard]] std::string length(double value) const { return fmt::format("{:.5g}", value / metres); }
    [[nodiscard]] std::string power(double value, int exponent) const {
        return fmt::format("{:.5g} {}{}", value / std::pow(metres, exponent), unit,
                           exponent == 1 ? "" : fmt::format("^{}", exponent));
    }
    [[nodiscard]] std::string size(const Box& box) const {
        const Vec extent = box.extent();
        return fmt::format("{} x {} x {} {}", length(extent[0]), length(extent[1]), length(extent[2]), unit);
    }
    [[nodiscard]] std::string location(const Vec& at) const {
        return fmt::format("({}, {}, {})", length(at[0]), length(at[1]), length(at[2]));
    }
};

Scale scale_for(const Box& box, bool unit_known) {
    if (!unit_known) return {1, "units"};
    const LengthUnit unit = length_unit(box.extent().maxCoeff());
    return {unit.metres, unit.name};
}

std::string unit_text(const Geometry& geometry, bool unit_known) {
    if (!unit_known) return "unknown: the file does not say it";
    const std::string length = length_text(geometry.unit);
    switch (geometry.unit_source) {
        case UnitSource::file:
            return "stated by the file";
        case UnitSource::scene:
            return length + ", as given";
        case UnitSource::assumed:
            break;
    }
    return length + ", assumed; the file does not say it";
}

std::string unit_word(UnitSource source) {
    return source == UnitSource::file ? "file" : source == UnitSource::scene ? "given" : "assumed";
}

/// How far triangles may be from curved surfaces of a geometry so large.
double inspection_chord_error(double size) { return std::max(1e-3 * size, std::numeric_limits<double>::min()); }

std::string triangles_text(const TriangleSurface& surface) { return count_text(surface.triangles.size(), "triangle"); }

Json json_of(const Vec& vector) { return {vector[0], vector[1], vector[2]}; }
Json json_of(const Box& box) { return {{"low", json_of(box.low)}, {"high", json_of(box.high)}}; }

Json json_of(const TriangleSurface& surface, const std::string& name, const char* kind) {
    return {{"name", name},
            {"kind", kind},
            {"area", surface.area()},
            {"triangles", surface.triangles.size()},
            {"box", json_of(box_of(surface))}};
}

/// Solids that meet themselves or share room, deeper than the triangles are off what they were drawn as.
std::vector<SolidMeeting> meetings_in(const Geometry& geometry) {
    std::vector<std::string> names;
    for (const Solid& solid : geometry.solids) names.push_back(solid.name);
    std::vector<SolidMeeting> found = solids_that_meet_themselves(geometry, names);
    const double tolerance = 5 * inspection_chord_error(geometry.box.extent().norm());
    const std::vector<SolidMeeting> shared = solids_that_overlap(geometry, names, tolerance);
    found.insert(found.end(), shared.begin(), shared.end());
    return found;
}

}  // namespace

std::string geometry_text(const Geometry& geometry, bool unit_known) {
    const Scale scale = scale_for(geometry.box, unit_known);
    Listing facts;
    facts.add("kind", geometry.dimension == 3 ? "in 3-D" : "in 2-D");
    facts.add("unit", unit_text(geometry, unit_known));
    facts.add("box", fmt::format("{}, from {} to {}", scale.size(geometry.box), scale.location(geometry.box.low),
                                 scale.location(geometry.box.high)));
    if (!unit_known)
        facts.add("that is", fmt::format("{}, {} or {}: say which by --unit, and geometry.unit in the scene",
                                         Scale{1, "m"}.size(geometry.box), Scale{1, "mm"}.size(geometry.box),
                                         Scale{1, "um"}.size(geometry.box)));
    Listing parts;
    for (const Solid& solid : geometry.solids)
        parts.add(solid.name, fmt::format("solid, watertight, {}, surface {}, box {}, {}",
                                          scale.power(solid.volume(), 3), scale.power(solid.surface.area(), 2),
                                          scale.size(box_of(solid.surface)), triangles_text(solid.surface)));
    for (const SurfaceSet& set : geometry.surfaces)
        parts.add(set.name, fmt::format("surface, {}, box {}, {}{}", scale.power(set.surface.area(), 2),
                                        scale.size(box_of(set.surface)), triangles_text(set.surface),
                                        set.why_open.empty() ? "" : "; no solid: " + set.why_open));
    for (const Region& region : geometry.regions)
        parts.add(region.name, fmt::format("area, {}, {}", scale.power(region.area(), 2),
                                           count_text(region.loops.size(), "boundary loop")));
    for (const CurveSet& set : geometry.curves)
        parts.add(set.name,
                  fmt::format("curve, {}, {}", scale.power(set.length(), 1), count_text(set.pieces.size(), "piece")));
    for (const auto& [name, places] : geometry.points) parts.add(name, count_text(places.size(), "point"));
    std::string text = Style(Stream::output).strong(geometry.file) + "\n" + facts.text() +
                       "\nParts, by the names that a scene gives them\n" + parts.text();
    Listing ends;
    for (const Solid& solid : geometry.solids)
        for (const FlatEnd& end : flat_ends(solid.surface))
            ends.add(solid.name, fmt::format("{} around {}", scale.power(end.area, 2), scale.location(end.centre)));
    if (!ends.empty()) text += "\nFlat ends, which are walls unless a scene selects them for a period\n" + ends.text();
    std::vector<std::string> notes = geometry.warnings;
    for (const SolidMeeting& meeting : meetings_in(geometry)) notes.push_back(meeting.text(scale.metres, scale.unit));
    for (const std::string& note : notes) text += Style(Stream::output).warning("note: ") + note + "\n";
    return text;
}

std::string geometry_json(const Geometry& geometry, bool unit_known) {
    Json json{{"file", geometry.file}, {"dimension", geometry.dimension}, {"unit", nullptr}};
    if (unit_known) json["unit"] = {{"metres", geometry.unit}, {"source", unit_word(geometry.unit_source)}};
    json["box"] = json_of(geometry.box);
    json["parts"] = Json::array();
    for (const Solid& solid : geometry.solids) {
        Json part = json_of(solid.surface, solid.name, "solid");
        part["volume"] = solid.volume();
        part["watertight"] = true;
        for (const FlatEnd& end : flat_ends(solid.surface))
            part["flat_ends"].push_back({{"area", end.area}, {"centre", json_of(end.centre)}});
        json["parts"].push_back(part);
    }
    for (const SurfaceSet& set : geometry.surfaces) {
        Json part = json_of(set.surface, set.name, "surface");
        part["watertight"] = false;
        if (!set.why_open.empty()) part["why_open"] = set.why_open;
        json["parts"].push_back(part);
    }
    for (const Region& region : geometry.regions)
        json["parts"].push_back({{"name", region.name}, {"kind", "area"}, {"area", region.area()}});
    for (const CurveSet& set : geometry.curves)
        json["parts"].push_back({{"name", set.name}, {"kind", "curve"}, {"length", set.length()}});
    for (const auto& [name, places] : geometry.points)
        json["parts"].push_back({{"name", name}, {"kind", "points"}, {"points", places.size()}});
    std::vector<std::string> warnings = geometry.warnings;
    for (const SolidMeeting& meeting : meetings_in(geometry))
        warnings.push_back(meeting.text(1, unit_known ? "m" : "units"));
    json["warnings"] = warnings;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

TriangleSurface bad_triangles(const Geometry& geometry) {
    TriangleSurface all;
    for (const SurfaceSet& set : geometry.surfaces) {
        if (set.why_open.empty()) continue;
        const TriangleSurface bad = part_of(set.surface, triangles_at_faults(set.surface));
        const auto first = static_cast<int>(all.corners.size());
        all.corners.insert(all.corners.end(), bad.corners.begin(), bad.corners.end());
        for (const auto& [a, b, c] : bad.triangles) all.triangles.push_back({first + a, first + b, first + c});
    }
    return all;
}

GeometryOptions geometry_options(const std::string& file, const std::string& unit) {
    GeometryOptions options{.file = file};
    if (unit.empty()) return options;
    const bool bare = std::isalpha(static_cast<unsigned char>(unit.front())) != 0;
    const SourceLocation location{"--unit", 0, 0};
    options.unit = read_quantity(bare ? "1 " + unit : unit, "m", location);
    if (!(*options.unit > 0))
        throw InputError(location, "'" + unit + "' is no length of a unit",
                         "Give a length such as mm, or \"25.4 mm\".");
    return options;
}

Geometry read_for_inspection(GeometryOptions options, const GeometryReading& reading) {
    if (needs_a_unit(options.file) && !options.unit) options.unit = 1;
    if (has_straight_edges_only(options.file)) return answer_geometry_request_command(options, reading);
    // Coarsely first: how fine is fine depends on the size.
    options.chord_error = std::numeric_limits<double>::max();
    const double size = answer_geometry_request_command(options, reading).box.extent().norm();
    options.chord_error = inspection_chord_error(size);
    return answer_geometry_request_command(options, reading);
}

}  // namespace dmp::cli
