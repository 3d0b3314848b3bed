// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/cad_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/inside_test.hpp"
#include "geometry/points_inside.hpp"
#include "geometry/segments.hpp"
#include "mesher/uses.hpp"
#include "models/sph/kernels.hpp"
#include "particles/periodic_images.hpp"

namespace dmp::mesher {

namespace {

constexpr double samples_apart = 0.5;  // [spacings]
constexpr double most_samples = 2e6;
constexpr double beside_surface = 0.01;  // how far to both sides of the surface one looks what is there [spacings]

using Sample = CadSurface::Sample;

/// Drops the samples that lie, seen a little to one side (+1: along the normal), in the solid or outside it.
void drop(std::vector<Sample>& samples, std::vector<int>& triangle, const TriangleSurface& solid, double step,
          bool where_inside) {
    if (samples.empty()) return;
    std::vector<Vec> points;
    points.reserve(samples.size());
    for (const Sample& sample : samples) points.emplace_back(sample.point + step * sample.normal);
    const std::vector<bool> is_inside = points_inside(solid, points);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        if (is_inside[k] == where_inside) continue;
        samples[kept] = samples[k];
        triangle[kept++] = triangle[k];
    }
    samples.resize(kept);
    triangle.resize(kept);
}

/// Adds samples of a triangle, about `area` each: at its centre, or spread by the R2 sequence (Roberts 2018).
void sample_triangle(const Vec& a, const Vec& b, const Vec& c, double area, std::vector<Sample>& samples) {
    const Vec across = (b - a).cross(c - a);
    const double whole = 0.5 * across.norm();
    if (!(whole > 0)) return;
    const auto count = static_cast<long>(std::max(1.0, std::ceil(whole / area)));
    const Vec normal = across.normalized();
    for (long k = 0; k < count; ++k) {
        const auto part = [k](double step) { return std::fmod(0.5 + step * static_cast<double>(k + 1), 1.0); };
        double u = 1.0 / 3, v = 1.0 / 3;
        if (count > 1) {
            u = part(0.7548776662466927);
            v = part(0.5698402909980532);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
        }
        samples.push_back({a + u * (b - a) + v * (c - a), normal, whole / static_cast<double>(count)});
    }
}

}  // namespace

std::vector<const Part*> fitted_parts(const Scene& scene) {
    std::vector<const Part*> parts = scene.parts_of(PartKind::elastic);
    std::erase_if(parts, [](const Part* part) { return !part->bonds_within.given(); });
    const auto fluids = scene.parts_of(PartKind::fluid);
    parts.insert(parts.end(), fluids.begin(), fluids.end());
    return parts;
}

CadSurface::CadSurface(const Geometry& geometry, const Scene& scene, const ParticleSpace& space, const Part& fluid,
                       double reach)
    : space_(space), reach_(reach) {
    if (space.dimension == 3)
        sample_solids(geometry, scene, fluid);
    else
        sample_curves(geometry, fluid, fitted_parts(scene));
    Coordinates points;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const Sample& sample : samples_) points[axis].push_back(sample.point[static_cast<Eigen::Index>(axis)]);
    grid_ = CellGrid(points, samples_.size(), space.dimension, space.spacing);
}

std::optional<Vec> CadSurface::way_out(const Vec& point) const {
    const Vec here = back_in_box(point);
    double best = square(space_.spacing);
    const Sample* nearest = nullptr;
    grid_.for_each_near({here.x(), here.y(), here.z()}, space_.spacing, [&](int k) {
        const Sample& sample = samples_[static_cast<std::size_t>(k)];
        const double apart = (sample.point - here).squaredNorm();
        if (apart >= best) return;
        best = apart;
        nearest = &sample;
    });
    return nearest == nullptr ? std::nullopt : std::optional(nearest->normal);
}

bool CadSurface::is_on_a_side(const Vec& point) const {
    const double tolerance = 1e-3 * space_.spacing;
    for (int axis = 0; axis < space_.dimension; ++axis)
        for (const bool high : {false, true}) {
            const auto at = static_cast<std::size_t>(axis);
            if (!space_.periodic.at(at) && !space_.mirrored.at(at).at(high ? 1 : 0)) continue;
            if (std::abs(point[axis] - (high ? space_.box.high : space_.box.low)[axis]) < tolerance) return true;
        }
    return false;
}

Vec CadSurface::back_in_box(Vec point) const {
    for (int axis = 0; axis < space_.dimension; ++axis) {
        point[axis] = space_.mirrored_back(point[axis], axis);
        if (space_.periodic.at(static_cast<std::size_t>(axis)))
            point[axis] = wrapped(point[axis], space_.box.low[axis], space_.box.high[axis]);
    }
    return point;
}

/// In 2-D both sides of each piece are asked: the fluid is on one of them only. A point that several fluids hold
/// is the first one's.
void CadSurface::sample_curves(const Geometry& geometry, const Part& fluid, const std::vector<const Part*>& fluids) {
    const double step = samples_apart * space_.spacing, beside = beside_surface * space_.spacing;
    std::vector<InsideTest> regions;
    std::vector<const Region*> drawn;
    for (const Part* part : fluids) {
        drawn.push_back(geometry.region(part->name));
        regions.emplace_back(*drawn.back());
        if (part == &fluid) break;
    }
    const auto is_fluid = [&](const Vec& point) {
        const Vec here = back_in_box(point);
        const auto holds = [&](const InsideTest& region) { return region.side_of(here) == Side::inside; };
        return holds(regions.back()) && std::none_of(regions.begin(), regions.end() - 1, holds);
    };
    double length = 0;
    for (const Region* region : drawn)
        for_each_segment(*region, [&](const Vec& a, const Vec& b) { length += (b - a).norm(); });
    const double apart = std::max(step, length / most_samples);
    CurveSet real;
    for (const Region* region : drawn)
        for_each_segment(*region, [&](const Vec& a, const Vec& b) {
            const double whole = (b - a).norm();
            if (!(whole > 0)) return;
            const Vec normal = Vec(b.y() - a.y(), a.x() - b.x(), 0) / whole;
            const auto count = static_cast<long>(std::max(1.0, std::ceil(whole / apart)));
            bool any = false;
            for (long k = 0; k < count; ++k) {
                const Vec point = a + (static_cast<double>(k) + 0.5) / static_cast<double>(count) * (b - a);
                if (is_on_a_side(point)) continue;
                const bool before = is_fluid(point - beside * normal), behind = is_fluid(point + beside * normal);
                if (before == behind) continue;
                samples_.push_back({point, before ? normal : Vec(-normal), whole / static_cast<double>(count)});
                any = true;
            }
            if (any) real.pieces.push_back({{a, b}, false});
        });
    if (!real.pieces.empty()) curves_.emplace(real, reach_);
}

/// In 3-D the side is known: triangles of closed surfaces face outward. Only solids that have the room before this
/// fluid are asked, which are walls' bodies and the fluids named earlier.
void CadSurface::sample_solids(const Geometry& geometry, const Scene& scene, const Part& fluid) {
    const double step = samples_apart * space_.spacing, beside = beside_surface * space_.spacing;
    std::vector<const TriangleSurface*> before;
    for (const Part* part : scene.parts_of(PartKind::rigid))
        if (const Solid* solid = geometry.solid(part->name)) before.push_back(&solid->surface);
    for (const Part* part : fitted_parts(scene)) {
        if (part == &fluid) break;
        before.push_back(&geometry.solid(part->name)->surface);
    }
    const TriangleSurface& own = geometry.solid(fluid.name)->surface;
    double area = own.area();
    for (const TriangleSurface* surface : before) area += surface->area();
    const double area_of_one = std::max(step * step, area / most_samples);

    TriangleSurface real;
    const auto add = [&](const TriangleSurface& surface, bool is_own) {
        std::vector<Sample> samples;
        std::vector<int> triangle;
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            const auto& [a, b, c] = surface.triangles[t];
            const auto corner = [&](int k) -> const Vec& { return surface.corners[static_cast<std::size_t>(k)]; };
            sample_triangle(corner(a), corner(b), corner(c), area_of_one, samples);
            triangle.resize(samples.size(), static_cast<int>(t));
        }
        std::size_t kept = 0;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            if (is_on_a_side(samples[k].point)) continue;
            samples[kept] = samples[k];
            triangle[kept++] = triangle[k];
        }
        samples.resize(kept);
        triangle.resize(kept);
        // The fluid is behind its own triangles, and before those of others.
        const double into_fluid = is_own ? -beside : beside;
        if (!is_own) drop(samples, triangle, own, into_fluid, false);
        if (!is_own) drop(samples, triangle, own, -into_fluid, false);  // coincident with the fluid's own surface
        for (const TriangleSurface* other : before)
            if (other != &surface) drop(samples, triangle, *other, into_fluid, true);
        for (Sample& sample : samples)
            if (!is_own) sample.normal = -sample.normal;
        samples_.insert(samples_.end(), samples.begin(), samples.end());
        triangle.erase(std::unique(triangle.begin(), triangle.end()), triangle.end());
        for (const int t : triangle) {
            std::array<int, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                corners.at(k) = static_cast<int>(real.corners.size());
                real.corners.push_back(
                    surface.corners[static_cast<std::size_t>(surface.triangles[static_cast<std::size_t>(t)].at(k))]);
            }
            real.triangles.push_back(corners);
        }
    };
    add(own, true);
    for (const TriangleSurface* surface : before) add(*surface, false);
    if (!real.triangles.empty()) triangles_.emplace(real, reach_);
}

std::optional<Projection> CadSurface::nearest_here(const Vec& point) const {
    if (curves_) return curves_->nearest(point);
    if (!triangles_) return std::nullopt;
    const auto found = triangles_->nearest(point);
    return found ? std::optional(Projection{found->point, found->distance}) : std::nullopt;
}

std::optional<Projection> CadSurface::nearest(const Vec& point) const {
    std::optional<Projection> nearest = nearest_here(point);
    for (int axis = 0; axis < space_.dimension; ++axis) {
        if (!space_.periodic.at(static_cast<std::size_t>(axis))) continue;
        for (const bool high : {false, true}) {
            const double to_side = high ? space_.box.high[axis] - point[axis] : point[axis] - space_.box.low[axis];
            if (to_side > reach_) continue;
            const Vec shift = (high ? -1 : 1) * space_.box.extent()[axis] * Vec::Unit(axis);
            const auto found = nearest_here(point + shift);
            if (found && (!nearest || found->distance < nearest->distance))
                nearest = Projection{found->point - shift, found->distance};
        }
    }
    return nearest;
}

}  // namespace dmp::mesher
