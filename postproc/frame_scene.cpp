// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/frame_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include "base/errors.hpp"
#include "postproc/axis.hpp"
#include "postproc/group_box.hpp"
#include "postproc/viewpoint.hpp"

namespace dmp::postproc {

namespace fs = std::filesystem;

namespace {

// A disc of radius sqrt(1/2) spacings covers the corners of its cell in a square lattice. Moving fluid is less
// regular; where discs overlap, the nearest particle is visible.
constexpr double covering_radius_of_lattice = 0.72;
constexpr double covering_radius_of_fluid = 0.95;

/// One number per particle: the value, or the magnitude of a vector (v . v)^(1/2) or symmetric tensor (s : s)^(1/2).
std::vector<float> scalars(const FrameField& field) {
    if (field.components == 1) return field.values;
    const auto components = static_cast<std::size_t>(field.components);
    std::vector<float> magnitude(field.values.size() / components);
    for (std::size_t i = 0; i < magnitude.size(); ++i) {
        const float* v = &field.values[components * i];
        float square = 0;
        for (std::size_t c = 0; c < components; ++c) square += (c < 3 ? 1.0F : 2.0F) * v[c] * v[c];
        magnitude[i] = std::sqrt(square);
    }
    return magnitude;
}

ParticleLayer plain_layer(const FrameGroup& group, Colour colour, double radius) {
    ParticleLayer layer;
    layer.position = group.position;
    layer.colour.assign(group.size(), colour);
    layer.radius = radius;
    return layer;
}

void colour_by(ParticleLayer& layer, const FrameGroup& group, const std::string& name, const ColourScale& scale) {
    const FrameField* found = find_field(group, name);
    if (found == nullptr) return;
    const std::vector<float> values = scalars(*found);
    std::transform(values.begin(), values.end(), layer.colour.begin(), std::cref(scale.map));
}

ParticleLayer layer_of_spheres(const FrameGroup& spheres, const std::string& field, const ColourScale& scale) {
    ParticleLayer layer = plain_layer(spheres, colours::plain_fluid, 0);
    const FrameField* radius = find_field(spheres, "radius");
    layer.radii = radius != nullptr ? radius->values : std::vector<float>(spheres.size(), 0.0F);
    colour_by(layer, spheres, field, scale);
    return layer;
}

}  // namespace

RunFolder::RunFolder(fs::path folder) : folder_(std::move(folder)), files_(folder_) {
    if (files_.times().empty())
        throw InputError("'" + folder_.string() + "' contains no frames (no fluid.pvd, solid.pvd or spheres.pvd)",
                         "Give the output folder of a run.");
    title_ = files_.title();
    walls_ = files_.walls();
    if (walls_) turn(*walls_);

    const RunFrame first = read(0);
    const RunFrame last = frames() > 1 ? read(frames() - 1) : first;
    area_ = empty_box();
    include(area_, walls_);
    include(area_, first.fluid);
    include(area_, first.solid);
    include(area_, first.spheres);
    include(area_, first.moving_walls);
    const Box limit = is_empty(area_) ? Box{} : Box{area_.low - area_.extent() / 2, area_.high + area_.extent() / 2};
    include(area_, last.fluid, &limit);
    include(area_, last.solid, &limit);
    include(area_, last.spheres, &limit);
    include(area_, last.moving_walls, &limit);
    if (is_empty(area_))
        throw InputError("'" + folder_.string() + "': no particle of the first frame has a finite position",
                         "The run diverged at the start, or the files are damaged; run the simulation again.");
    flat_ = area_.extent().z() <= 4 * first.spacing;
    const Vec margin = Vec::Constant(std::max(first.spacing, 1e-3 * area_.extent().maxCoeff()));
    area_ = {area_.low - margin, area_.high + margin};
}

void RunFolder::turn(FrameGroup& group) const {
    if (!of_spheres()) return;
    static const Viewpoint view = aslant(along(0, 2));
    for (std::size_t i = 0; i < group.size(); ++i) {
        const Vec seen = view(position_of(group, i));
        for (std::size_t axis = 0; axis < 3; ++axis)
            group.position[3 * i + axis] = static_cast<float>(seen[static_cast<Eigen::Index>(axis)]);
    }
}

RunFrame RunFolder::read(std::size_t frame) const {
    Frame stored = files_.read(frame);
    RunFrame result;
    result.time = stored.time;
    result.spacing = stored.spacing;
    for (FrameGroup& group : stored.groups) {
        turn(group);
        std::optional<FrameGroup>& place = group.name == "fluid"     ? result.fluid
                                           : group.name == "solid"   ? result.solid
                                           : group.name == "spheres" ? result.spheres
                                                                     : result.moving_walls;
        place = std::move(group);
    }
    leave_out_bonds_round_borders(result);
    return result;
}

void FieldRange::include(const RunFrame& frame, const std::string& field) {
    field_ = field;
    if (!frame.coloured()) return;
    const FrameField* found = find_field(*frame.coloured(), field);
    if (found == nullptr) {
        missing_ = true;
        return;
    }
    unit_ = found->unit;
    vector_ = found->components > 1;
    std::vector<float> values = scalars(*found);
    values.erase(std::remove_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }), values.end());
    if (values.empty()) return;
    std::sort(values.begin(), values.end());
    const std::size_t outermost = values.size() / 1000;
    const auto extend = [this](double& low, double& high, double new_low, double new_high) {
        low = any_ ? std::min(low, new_low) : new_low;
        high = any_ ? std::max(high, new_high) : new_high;
    };
    extend(lowest_, highest_, values.front(), values.back());
    extend(low_, high_, values[outermost], values[values.size() - 1 - outermost]);
    any_ = true;
}

ColourScale FieldRange::scale() const {
    const std::string label = axis_label(field_ == "velocity" ? "speed" : field_, unit_);
    if (!any_) return {ColourMap::sequential(0, 1), label, false, false, colours::solid, false};
    const auto with_ends = [&](const ColourMap& map, Colour solid) {
        const double slack = 1e-6 * (map.high() - map.low());
        const bool beyond_low = map.low() - lowest_ > slack;
        const bool beyond_high = highest_ - map.high() > slack;
        return ColourScale{map, label, beyond_low, beyond_high, solid, true};
    };
    if (field_ == "pressure" || (low_ < 0 && high_ > 0)) {
        const double span = std::max(std::abs(low_), std::abs(high_));
        return with_ends(ColourMap::diverging(0, span > 0 ? span : 1), colours::dark_solid);
    }
    const double low = vector_ || (low_ >= 0 && low_ < 0.3 * high_) ? 0 : low_;
    const bool constant = high_ - low <= 1e-6 * std::abs(high_);
    const double high = constant ? (high_ == 0 ? 1 : low + 1e-3 * std::abs(low)) : high_;
    return with_ends(ColourMap::sequential(low, high), colours::solid);
}

void leave_out_bonds_round_borders(RunFrame& frame) {
    if (!frame.fluid || !frame.solid) return;
    Box around = empty_box();
    include(around, frame.fluid);
    FrameGroup& solid = *frame.solid;
    std::vector<std::int32_t> shown;
    for (std::size_t bond = 0; bond < solid.bonds(); ++bond) {
        const std::int32_t a = solid.bond_ends[2 * bond], b = solid.bond_ends[2 * bond + 1];
        const Vec apart =
            position_of(solid, static_cast<std::size_t>(a)) - position_of(solid, static_cast<std::size_t>(b));
        if ((apart.cwiseAbs().array() <= 0.5 * around.extent().array()).all()) shown.insert(shown.end(), {a, b});
    }
    solid.bond_ends = std::move(shown);
    solid.bond_fields.clear();
}

std::vector<ParticleLayer> layers_of(const RunFrame& frame, const std::optional<FrameGroup>& walls,
                                     const std::string& field, const ColourScale& scale) {
    std::vector<ParticleLayer> layers;
    if (frame.fluid) {
        ParticleLayer layer = plain_layer(*frame.fluid, colours::plain_fluid, covering_radius_of_fluid * frame.spacing);
        colour_by(layer, *frame.fluid, field, scale);
        layers.push_back(std::move(layer));
    }
    for (const auto* rigid : {&walls, &frame.moving_walls}) {
        if (!*rigid) continue;
        layers.push_back(plain_layer(**rigid, colours::wall, covering_radius_of_lattice * frame.spacing));
        layers.back().triangles = (*rigid)->triangles;
    }
    if (frame.bodies)
        layers.push_back(plain_layer(*frame.bodies, colours::body, covering_radius_of_lattice * frame.spacing));
    if (frame.spheres) layers.push_back(layer_of_spheres(*frame.spheres, field, scale));
    if (frame.solid) {
        ParticleLayer layer = plain_layer(*frame.solid, scale.solid, 0.6 * frame.spacing);
        layer.lines = frame.solid->bond_ends;
        layer.line_colour = scale.solid;
        layer.line_width = frame.spacing / 2;
        layers.push_back(std::move(layer));
    }
    return layers;
}

std::size_t count_outside(const RunFrame& frame, const Box& area, int dimension) {
    std::size_t outside = 0;
    for (const auto* group : {&frame.fluid, &frame.solid, &frame.spheres}) {
        if (!*group) continue;
        for (std::size_t i = 0; i < (*group)->size(); ++i)
            if (const Vec position = position_of(**group, i);
                !is_finite(position) || !contains(area, position, dimension))
                ++outside;
    }
    return outside;
}

std::string time_text(double seconds, double scale) {
    struct Prefix {
        double size;
        const char* unit;
    };
    constexpr std::array prefixes{Prefix{1, "s"}, Prefix{1e-3, "ms"}, Prefix{1e-6, "µs"}};
    const auto fits = [scale](const Prefix& prefix) { return std::abs(scale) >= prefix.size * (1 - 1e-9); };
    const auto* const found = std::find_if(prefixes.begin(), prefixes.end(), fits);
    const Prefix& prefix = found == prefixes.end() ? prefixes.front() : *found;
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.4g %s", seconds / prefix.size, prefix.unit);
    return text.data();
}

}  // namespace dmp::postproc
