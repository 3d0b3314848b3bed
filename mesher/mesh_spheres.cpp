// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/mesh_spheres.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/closest_point.hpp"
#include "mesher/sphere_builder.hpp"
#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"
#include "particles/touching_spheres.hpp"

namespace dmp::mesher {

namespace {

/// Spheres that lie deeper than this in another one, or in a wall, were not meant to [smaller radius].
constexpr double deepest_overlap = 0.05;

/// Looks at how spheres and walls lie to each other.
class Checker {
  public:
    Checker(const Scene& scene, const ParticleSet& set) : scene_(scene), set_(set) {
        std::vector<int> counted(set.parts.size());
        for (const int part : set.part) number_.push_back(counted[static_cast<std::size_t>(part)]++);
    }

    void spheres(MeshReport& report) const {
        for (const TouchingSpheres& pair : touching_spheres(set_)) {
            const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
            if (!touch(name_of(set_.part[a]), name_of(set_.part[b]))) continue;
            const double smaller = std::min(set_.radius[a], set_.radius[b]);
            if (a == b)
                throw InputError(scene_.part_of_particles(name_of(set_.part[a])).name.location,
                                 text(a) + " reaches around a period and touches itself", "give [box] a longer period");
            if (pair.overlap > deepest_overlap * smaller)
                throw InputError(
                    scene_.part_of_particles(name_of(set_.part[b])).name.location,
                    fmt::format("{} and {} overlap by {:.3g} m at the start", text(a), text(b), pair.overlap),
                    fmt::format("move them apart: at most {} of the smaller radius, {:.3g} m, may overlap",
                                deepest_overlap, deepest_overlap * smaller));
            ++report.touching;
            report.deepest_overlap = std::max(report.deepest_overlap, pair.overlap);
        }
    }

    void planes() const {
        for (const WallPlane& plane : set_.wall_planes)
            for (std::size_t i = 0; i < set_.size(); ++i) {
                if (!touch(name_of(plane.part), name_of(set_.part[i]))) continue;
                need_clear(i, (set_.position[i] - plane.point).dot(plane.normal), plane.part, "behind or in");
            }
    }

    void triangles() const {
        if (set_.wall_triangles.empty()) return;
        const double widest = *std::ranges::max_element(set_.radius);
        Coordinates points;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const Vec& x : set_.position) points.at(axis).push_back(x[static_cast<Eigen::Index>(axis)]);
        const CellGrid grid(points, set_.size(), 3, 2 * widest);
        for (const WallTriangle& wall : set_.wall_triangles) {
            const auto corner = [&](int k) -> const Vec& { return set_.wall_corners[static_cast<std::size_t>(k)]; };
            const Vec &a = corner(wall.a), &b = corner(wall.b), &c = corner(wall.c);
            const Vec low = a.cwiseMin(b).cwiseMin(c) - Vec::Constant(widest);
            const Vec high = a.cwiseMax(b).cwiseMax(c) + Vec::Constant(widest);
            grid.for_each_near({low[0], low[1], low[2]}, {high[0], high[1], high[2]}, [&](int k) {
                const auto i = static_cast<std::size_t>(k);
                if (!touch(name_of(wall.part), name_of(set_.part[i]))) return;
                const Vec& x = set_.position[i];
                need_clear(i, (x - closest_on_triangle(x, a, b, c)).norm(), wall.part, "in");
            });
        }
    }

  private:
    [[nodiscard]] const std::string& name_of(int part) const { return set_.parts[static_cast<std::size_t>(part)].name; }
    [[nodiscard]] bool touch(const std::string& a, const std::string& b) const {
        const ContactPair* pair = scene_.contact_between(a, b);
        return pair == nullptr || *pair->enabled;
    }
    [[nodiscard]] std::string text(std::size_t i) const {
        const Vec& x = set_.position[i];
        return fmt::format("sphere {} of '{}' at ({:.6g}, {:.6g}, {:.6g}) m", number_[i], name_of(set_.part[i]), x[0],
                           x[1], x[2]);
    }
    void need_clear(std::size_t i, double distance, int wall, const char* where) const {
        if (distance >= (1 - deepest_overlap) * set_.radius[i]) return;
        throw InputError(scene_.part_of_particles(name_of(set_.part[i])).name.location,
                         fmt::format("{} lies {} the wall '{}' at the start: its centre is {:.3g} m from it", text(i),
                                     where, name_of(wall), distance),
                         "move it away by its radius or more");
    }

    const Scene& scene_;
    const ParticleSet& set_;
    std::vector<int> number_;  ///< of each sphere in its part, from 0
};

/// The box around all spheres and the scene's; along periodic axes the scene's. Spheres come into it.
void set_box(const Scene& scene, ParticleSet& set) {
    Box box{Vec::Constant(std::numeric_limits<double>::infinity()),
            Vec::Constant(-std::numeric_limits<double>::infinity())};
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < set.size(); ++i) {
        box.low = box.low.cwiseMin(set.position[i] - Vec::Constant(set.radius[i]));
        box.high = box.high.cwiseMax(set.position[i] + Vec::Constant(set.radius[i]));
        smallest = std::min(smallest, set.radius[i]);
    }
    if (scene.box.from.given() && scene.box.to.given()) {
        box.low = box.low.cwiseMin(*scene.box.from);
        box.high = box.high.cwiseMax(*scene.box.to);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!set.periodic[static_cast<std::size_t>(axis)]) continue;
        box.low[axis] = (*scene.box.from)[axis];
        box.high[axis] = (*scene.box.to)[axis];
        for (Vec& x : set.position) x[axis] = wrapped(x[axis], box.low[axis], box.high[axis]);
    }
    set.box = box;
    set.spacing = 2 * smallest;
}

}  // namespace

bool is_of_spheres(const Scene& scene) { return !scene.parts_of(PartKind::spheres).empty(); }

MeshResult mesh_spheres(const Scene& scene) {
    SphereBuilder builder(scene);
    for (const Part* part : scene.parts_of(PartKind::plane)) builder.add_plane(*part);
    for (const Part* part : scene.parts_of(PartKind::surface)) builder.add_surface(*part);
    const auto spheres = scene.parts_of(PartKind::spheres);
    for (const Part* part : spheres)
        if (!part->around.given() && !part->fill_from.given()) builder.add_spheres(*part);
    for (const Part* part : spheres)
        if (part->around.given()) builder.add_spheres(*part);
    for (const Part* part : spheres)
        if (part->fill_from.given()) builder.add_spheres(*part);
    MeshResult result = builder.finish();
    set_box(scene, result.particles);
    const Checker checker(scene, result.particles);
    checker.spheres(result.report);
    checker.planes();
    checker.triangles();
    return result;
}

}  // namespace dmp::mesher
