// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/mesh_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "postproc/panel_layout.hpp"
#include "postproc/sheet.hpp"
#include "postproc/viewpoint.hpp"
#include "postproc/virtual_display.hpp"
#include "postproc/vtk_messages.hpp"

namespace dmp::postproc {

namespace {

using Kind = MeshView::Kind;

constexpr double disc = 0.5;          // radius of discs in slices [spacings]
constexpr double least_span = 0.005;  // smallest half-range of kernel sums: smaller differences look alike

Box around(const MeshView& mesh, const Viewpoint& view, const std::vector<std::size_t>& members) {
    Box box{Vec::Constant(std::numeric_limits<double>::infinity()),
            Vec::Constant(-std::numeric_limits<double>::infinity())};
    for (const std::size_t i : members) {
        const Vec seen = view(mesh.position[i]);
        box.low = box.low.cwiseMin(seen);
        box.high = box.high.cwiseMax(seen);
    }
    const Vec margin = Vec::Constant(std::max(mesh.spacing, 1e-3 * box.extent().maxCoeff()));
    return {box.low - margin, box.high + margin};
}

template <class Which>
std::vector<std::size_t> members(const MeshView& mesh, const Which& which) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < mesh.position.size(); ++i)
        if (which(i)) found.push_back(i);
    return found;
}

template <class ColourOf>
ParticleLayer layer(const MeshView& mesh, const Viewpoint& view, const std::vector<std::size_t>& members, double radius,
                    const ColourOf& colour_of) {
    ParticleLayer layer;
    layer.radius = radius * mesh.spacing;
    for (const std::size_t i : members) {
        const Vec seen = view(mesh.position[i]);
        for (Eigen::Index axis = 0; axis < 3; ++axis) layer.position.push_back(static_cast<float>(seen[axis]));
        layer.colour.push_back(colour_of(i));
    }
    return layer;
}

/// A scale around `middle` that covers the values, with a half-range of at least `least`.
ColourScale scale_about(double middle, double least, const std::vector<float>& values,
                        const std::vector<std::size_t>& members, const std::string& label) {
    std::vector<double> away;
    away.reserve(members.size());
    for (const std::size_t i : members) away.push_back(std::abs(static_cast<double>(values[i]) - middle));
    std::ranges::sort(away);
    double span = least;
    if (!away.empty()) span = std::max(span, away[away.size() - 1 - away.size() / 1000]);
    const bool beyond = !away.empty() && away.back() > 1.001 * span;
    return {ColourMap::diverging(middle, span), label, beyond, beyond, colours::dark_solid, true};
}

/// Draws one sheet of one or more views.
class Painter {
  public:
    Painter(std::filesystem::path folder, const MeshView& mesh, int width)
        : folder_(std::move(folder)), mesh_(mesh), width_(width) {}

    void slices() {
        const auto fluid = members(mesh_, [&](std::size_t i) { return mesh_.kind[i] == Kind::fluid; });
        if (fluid.empty()) return;
        const ColourScale scale = scale_about(1, least_span, mesh_.kernel_sum, fluid, "kernel sum of the fluid");
        const Vec middle = mesh_.dimension == 2 ? Vec::Zero() : middle_of(fluid);
        const auto all = members(mesh_, [](std::size_t) { return true; });
        const double size = around(mesh_, along(0, 1), all).extent().maxCoeff();
        std::vector<Viewpoint> views;
        std::vector<PanelActors> panels;
        constexpr std::array<std::array<int, 2>, 3> axes{{{0, 1}, {0, 2}, {1, 2}}};
        for (const auto& [right, up] : axes) {
            views.push_back(along(right, up, middle));
            panels.push_back({around(mesh_, views.back(), all), slice_text(right, up, middle, size)});
            if (mesh_.dimension == 3) continue;
            panels.back().caption.clear();
            break;
        }
        const PanelLayout layout(panels);
        Sheet sheet(layout.area(), 1, width_, mesh_.title);
        const auto draw_slice = [&](std::size_t k, int width, int height) {
            const auto in_slice = [&](std::size_t i) {
                return std::abs(views[k](mesh_.position[i]).z()) <= 0.5001 * mesh_.spacing;
            };
            return slice(views[k], panels[k].area, width, height, scale, in_slice);
        };
        sheet.add(layout.draw(sheet.panel_width(), sheet.panel_height(), draw_slice), "");
        finish(sheet, scale, "slices.png");
    }

    void surface_error() {
        const auto shown = members(mesh_, [&](std::size_t i) { return std::isfinite(mesh_.surface_error[i]); });
        if (shown.empty()) return;
        const ColourScale scale =
            scale_about(0, 0.05, mesh_.surface_error, shown, "distance to the CAD surface less 1/2 [spacings]");
        const Viewpoint view = mesh_.dimension == 3 ? aslant(along(0, 2)) : along(0, 1);
        const auto colour = [&](std::size_t i) { return scale.map(mesh_.surface_error[i]); };
        std::vector<ParticleLayer> layers;
        Box area = around(mesh_, view, shown);
        if (mesh_.dimension == 2) {
            const auto all = members(mesh_, [](std::size_t) { return true; });
            area = around(mesh_, view, all);
            layers.push_back(layer(mesh_, view, all, 0.25, [](std::size_t) { return colours::grid; }));
            layers.push_back(layer(mesh_, view, shown, 0.8, colour));
        } else {
            layers.push_back(layer(mesh_, view, shown, disc, colour));
            layers.back().radii.assign(shown.size(), static_cast<float>(0.6 * mesh_.spacing));
        }
        draw(area, layers, scale, "surface_error.png");
    }

    void valence() {
        if (mesh_.bond_ends.empty()) return;
        const auto nodes = members(mesh_, [&](std::size_t i) { return mesh_.kind[i] == Kind::solid; });
        int most = 1, fewest = std::numeric_limits<int>::max();
        for (const std::size_t i : nodes) {
            most = std::max(most, mesh_.valence[i]);
            fewest = std::min(fewest, mesh_.valence[i]);
        }
        const double low = std::min(fewest, most - 1);
        const ColourScale scale{
            ColourMap::sequential(low, most), "bonds of a node", false, false, colours::solid, true};
        const Viewpoint view = mesh_.dimension == 3 ? aslant(along(0, 2)) : along(0, 1);
        ParticleLayer shown = layer(mesh_, view, nodes, 0.35,
                                    [&](std::size_t i) { return scale.map(static_cast<double>(mesh_.valence[i])); });
        std::vector<std::int32_t> index(mesh_.position.size(), -1);
        for (std::size_t k = 0; k < nodes.size(); ++k) index[nodes[k]] = static_cast<std::int32_t>(k);
        ParticleLayer bonds = shown;
        bonds.radius = 0.05 * mesh_.spacing;
        for (const std::int32_t end : mesh_.bond_ends) bonds.lines.push_back(index[static_cast<std::size_t>(end)]);
        bonds.line_colour = colours::frame;
        bonds.line_width = 0.1 * mesh_.spacing;
        if (mesh_.dimension == 3) shown.radii.assign(nodes.size(), static_cast<float>(0.35 * mesh_.spacing));
        draw(around(mesh_, view, nodes), {bonds, shown}, scale, "valence.png");
    }

    [[nodiscard]] const Pictures& pictures() const { return pictures_; }
    void warn(const std::string& words) { pictures_.warning += (pictures_.warning.empty() ? "" : "\n") + words; }

  private:
    [[nodiscard]] Vec middle_of(const std::vector<std::size_t>& fluid) const {
        Vec middle;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const auto by_place = [&](std::size_t a, std::size_t b) {
                return mesh_.position[a][axis] < mesh_.position[b][axis];
            };
            std::vector<std::size_t> sorted = fluid;
            const auto half = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
            std::nth_element(sorted.begin(), half, sorted.end(), by_place);
            middle[axis] = mesh_.position[*half][axis];
        }
        return middle;
    }

    template <class Which>
    Image slice(const Viewpoint& view, const Box& area, int width, int height, const ColourScale& scale,
                const Which& which) {
        std::vector<ParticleLayer> layers;
        const auto of_kind = [&](Kind kind) {
            return members(mesh_, [&](std::size_t i) { return mesh_.kind[i] == kind && which(i); });
        };
        const auto add = [&](Kind kind, const auto& colour_of) {
            layers.push_back(layer(mesh_, view, of_kind(kind), disc, colour_of));
        };
        add(Kind::fluid, [&](std::size_t i) { return scale.map(mesh_.kernel_sum[i]); });
        add(Kind::wall, [](std::size_t) { return colours::wall; });
        add(Kind::solid, [](std::size_t) { return colours::dark_solid; });
        return view_.draw(layers, area, width, height);
    }

    void draw(const Box& area, const std::vector<ParticleLayer>& layers, const ColourScale& scale,
              const std::string& file) {
        Sheet sheet(area, 1, width_, mesh_.title);
        const Image image = view_.draw(layers, area, sheet.panel_width(), sheet.panel_height());
        if (distinct_colours(image, 2) < 2) warn(file + " is blank");
        sheet.add(image, "");
        finish(sheet, scale, file);
    }

    void finish(Sheet& sheet, const ColourScale& scale, const std::string& file) {
        sheet.finish(scale);
        sheet.save(folder_ / file);
        pictures_.files.push_back(file);
    }

    std::filesystem::path folder_;
    const MeshView& mesh_;
    int width_;
    ParticleView view_;
    Pictures pictures_;
};

}  // namespace

Pictures write_mesh_pictures(const std::filesystem::path& folder, const MeshView& mesh, int width) {
    const VirtualDisplay display;
    if (!display.usable()) return {{}, "no pictures of the mesh: " + display.problem()};
    const VtkMessages messages;
    Painter painter(folder, mesh, width);
    painter.slices();
    painter.surface_error();
    painter.valence();
    if (!messages.text().empty()) painter.warn("message of VTK: " + messages.text());
    return painter.pictures();
}

}  // namespace dmp::postproc
