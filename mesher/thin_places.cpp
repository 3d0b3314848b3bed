// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/thin_places.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <utility>

#include "geometry/local_thickness.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/space_builder.hpp"

namespace dmp {

namespace {

constexpr double least_gap = 3, least_thickness = 2;  // [spacings]

/// Adds the surface of a body in the fluid, as the fluid has it: facing into the body.
void add_turned(TriangleSurface& to, const TriangleSurface& body) {
    const auto first = static_cast<int>(to.corners.size());
    to.corners.insert(to.corners.end(), body.corners.begin(), body.corners.end());
    for (const auto& [a, b, c] : body.triangles) to.triangles.push_back({first + a, first + c, first + b});
}

/// Lines from one side of the box to the other along an axis in which it is no wall that ends there.
class OpenSides {
  public:
    OpenSides(const Geometry& geometry, const Scene& scene) : box_(fluid_box_in_space(geometry, scene)) {
        const auto mirrored = mirrored_sides(scene);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t side = 0; side < 2; ++side)
                open_.at(axis).at(side) = *scene.flow.periodic.at(axis) || mirrored.at(axis).at(side);
    }
    [[nodiscard]] bool holds(const Vec& place) const {
        const double near = 1e-6 * box_.extent().maxCoeff();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<Eigen::Index>(axis);
            if (open_.at(axis)[0] && place[k] < box_.low[k] + near) return true;
            if (open_.at(axis)[1] && place[k] > box_.high[k] - near) return true;
        }
        return false;
    }

  private:
    Box box_;
    std::array<std::array<bool, 2>, 3> open_{};  ///< by axis, low and high
};

/// The line about one part; empty if nothing that counts is thinner than the limit [spacings].
std::string thinnest_text(const LocalThickness& found, double spacing, double limit, const std::string& what,
                          const std::function<bool(const ThicknessSample&)>& counts) {
    const ThicknessSample* thinnest = nullptr;
    double area = 0;
    for (const ThicknessSample& sample : found.samples) {
        if (sample.thickness >= (1 - 1e-9) * limit * spacing || !counts(sample)) continue;
        area += sample.area;
        if (thinnest == nullptr || sample.thickness < thinnest->thickness) thinnest = &sample;
    }
    if (thinnest == nullptr) return {};
    const Vec place = 0.5 * (thinnest->place + thinnest->opposite) * 1e3;
    std::ostringstream text;
    text.precision(3);
    text << what << " of " << thinnest->thickness / spacing << " spacings near (" << place.x() << ", " << place.y()
         << ", " << place.z() << ") mm, less than " << limit << " particles, as are " << 100 * area / found.area
         << " % of its surface";
    return text.str();
}

}  // namespace

std::vector<std::string> thin_places(const Geometry& geometry, const Scene& scene) {
    std::vector<std::string> said;
    const double spacing = scene.particles.spacing;
    const OpenSides open(geometry, scene);
    const auto ends_on_walls = [&](const ThicknessSample& sample) {
        return !open.holds(sample.place) && !open.holds(sample.opposite);
    };
    std::vector<const TriangleSurface*> bodies;
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        const Solid* solid = geometry.solid(part->name);
        if (solid == nullptr) continue;
        bodies.push_back(&solid->surface);
        said.push_back(thinnest_text(local_thickness(solid->surface, spacing), spacing, least_thickness,
                                     part->name.value + ": a thickness", ends_on_walls));
    }
    std::vector<WindingNumber> in_body;
    in_body.reserve(bodies.size());
    for (const TriangleSurface* body : bodies) in_body.emplace_back(*body);
    for (const Part* part : scene.parts_of(PartKind::fluid)) {
        TriangleSurface around = geometry.solid(part->name)->surface;
        const WindingNumber in_fluid(around);
        for (const TriangleSurface* body : bodies) add_turned(around, *body);
        const auto is_fluid = [&](const ThicknessSample& sample) {
            const Vec middle = 0.5 * (sample.place + sample.opposite);
            return ends_on_walls(sample) && in_fluid.inside(middle) &&
                   std::ranges::none_of(in_body, [&](const WindingNumber& body) { return body.inside(middle); });
        };
        said.push_back(thinnest_text(local_thickness(around, spacing), spacing, least_gap, part->name.value + ": a gap",
                                     is_fluid));
    }
    std::erase(said, std::string());
    return said;
}

}  // namespace dmp
