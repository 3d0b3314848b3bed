// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/particle_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "postproc/colour_map.hpp"
#include "report/html.hpp"
#include "report/json_value.hpp"
#include "report/page_frame.hpp"
#include "report/quantise.hpp"

namespace dmp::report {

namespace {

using Json = JsonValue::Json;

struct Bounds {
    std::array<double, 3> low{}, high{};
};

Bounds bounds_of(const ShownParticles& particles) {
    Bounds bounds;
    bounds.low.fill(std::numeric_limits<double>::max());
    bounds.high.fill(std::numeric_limits<double>::lowest());
    for (const ShownGroup& group : particles.groups)
        for (const GroupAtTime& at : group.at)
            for (std::size_t k = 0; k < at.position.size(); ++k) {
                const double x = static_cast<double>(at.position[k]);
                bounds.low[k % 3] = std::min(bounds.low[k % 3], x);
                bounds.high[k % 3] = std::max(bounds.high[k % 3], x);
            }
    return bounds;
}

std::string colours(const ColourMap& map) {
    std::string bytes;
    for (int k = 0; k < colours_of_range; ++k) {
        const Colour colour = map(map.low() + (map.high() - map.low()) * k / (colours_of_range - 1));
        bytes += static_cast<char>(colour.red);
        bytes += static_cast<char>(colour.green);
        bytes += static_cast<char>(colour.blue);
    }
    return base64(bytes);
}

/// How large particles are drawn, so that they leave no gaps where they are shown [spacings]: in a square lattice discs
/// of half a diagonal; a moving liquid is less regular. Spheres of a lattice overlap in 3-D.
double drawn_radius(const ShownGroup& group, bool flat) {
    const double whole = !flat ? 0.6 : group.name == "fluid" ? 0.95 : 0.72;
    return whole * std::pow(static_cast<double>(group.every), flat ? 0.5 : 1.0 / 3);
}

double largest_radius(const ShownGroup& group) {
    float largest = 0;
    for (const GroupAtTime& at : group.at)
        for (const float radius : at.radius) largest = std::max(largest, radius);
    return static_cast<double>(largest);
}

ColourRange range_of(const ShownGroup& group, std::size_t field) {
    std::vector<float> all;
    for (const GroupAtTime& at : group.at)
        if (!at.values.empty()) all.insert(all.end(), at.values[field].begin(), at.values[field].end());
    return colour_range(all, group.fields[field].name == "pressure");
}

Json json_of(const GroupAtTime& at, const std::vector<ColourRange>& ranges, double largest, const Bounds& bounds,
             bool flat) {
    std::string places, radii;
    for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t axis = 0; axis < (flat ? 2 : 3); ++axis)
            append(places,
                   step_of(static_cast<double>(at.position[3 * i + axis]), bounds.low[axis], bounds.high[axis]));
    for (const float radius : at.radius) append(radii, step_of(static_cast<double>(radius), 0, largest));
    Json values = Json::array();
    for (std::size_t field = 0; field < at.values.size(); ++field) {
        std::string bytes;
        for (const float value : at.values[field])
            bytes += static_cast<char>(colour_of(static_cast<double>(value), ranges[field]));
        values.push_back(base64(bytes));
    }
    return {{"place", base64(places)}, {"radius", base64(radii)}, {"values", values}};
}

Json json_of(const ShownGroup& group, double spacing, const Bounds& bounds, bool flat) {
    std::vector<ColourRange> ranges;
    Json fields = Json::array();
    for (std::size_t field = 0; field < group.fields.size(); ++field) {
        ranges.push_back(range_of(group, field));
        fields.push_back({{"name", group.fields[field].name},
                          {"unit", group.fields[field].unit},
                          {"low", ranges.back().low},
                          {"high", ranges.back().high},
                          {"diverging", ranges.back().diverging}});
    }
    std::string corners;
    for (const std::int32_t corner : group.triangles) append(corners, static_cast<std::uint32_t>(corner));
    const double largest = largest_radius(group);
    Json times = Json::array();
    for (const GroupAtTime& at : group.at) times.push_back(json_of(at, ranges, largest, bounds, flat));
    return {{"name", group.name}, {"every", group.every},         {"radius", spacing * drawn_radius(group, flat)},
            {"largest", largest}, {"triangles", base64(corners)}, {"fields", fields},
            {"at", times}};
}

std::ptrdiff_t layer_of(const ShownGroup& group) {
    constexpr std::array<std::string_view, 5> order{"fluid", "walls", "moving_walls", "spheres", "solid"};
    return std::ranges::find(order, group.name) - order.begin();
}

}  // namespace

std::string particle_data(const ShownParticles& particles) {
    const bool flat = is_flat(particles);
    const Bounds bounds = bounds_of(particles);
    std::vector<const ShownGroup*> layers;
    for (const ShownGroup& group : particles.groups) layers.push_back(&group);
    std::ranges::stable_sort(layers, {}, [](const ShownGroup* group) { return layer_of(*group); });
    Json groups = Json::array();
    for (const ShownGroup* group : layers) groups.push_back(json_of(*group, particles.spacing, bounds, flat));
    const Json json{{"flat", flat},
                    {"low", bounds.low},
                    {"high", bounds.high},
                    {"time", particles.times},
                    {"sequential", colours(ColourMap::sequential(0, 1))},
                    {"diverging", colours(ColourMap::diverging(0, 1))},
                    {"nan", {colours::not_a_number.red, colours::not_a_number.green, colours::not_a_number.blue}},
                    {"groups", groups}};
    return without_markup(json.dump());
}

}  // namespace dmp::report
