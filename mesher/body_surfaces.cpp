// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/body_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/length_text.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/nearest_curve.hpp"
#include "geometry/nearest_triangle.hpp"
#include "mesher/open_sides.hpp"
#include "mesher/spring_lattice.hpp"

namespace dmp::mesher {

namespace {

/// Fluid sees particles up to a kernel's support behind the surface; surfaces farther away need not be found
/// [spacings].
constexpr double reach = 5;
/// A particle so near to the surface is on it [spacings].
constexpr double on_surface = 1e-6;

/// Where a point is from a surface.
struct Nearest {
    Vec outward = Vec::Zero();  ///< unit vector
    double depth = reach;       ///< behind it [spacings]
};
using FindNearest = std::function<std::optional<Nearest>(const Vec&)>;

/// The point and its images across periodic sides: where a surface near a side is met from.
std::vector<Vec> images_of(const Vec& point, const ParticleSpace& space) {
    std::vector<Vec> images{point};
    for (int axis = 0; axis < space.dimension; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const double period = space.box.extent()[axis];
        for (std::size_t k = 0, count = images.size(); k < count && space.periodic[at]; ++k)
            for (const double shift : {-period, period}) {
                images.push_back(images[k]);
                images.back()[axis] += shift;
            }
    }
    return images;
}

/// An area's outline.
class AreaSurface {
  public:
    AreaSurface(const Region& region, const ParticleSpace& space)
        : space_(space), inside_(region), curve_(drawn(region, space), reach * space.spacing) {}

    [[nodiscard]] std::optional<Nearest> operator()(const Vec& point) const {
        std::optional<Projection> best;
        for (const Vec& image : images_of(point, space_))
            if (const auto found = curve_.nearest(image); found && (!best || found->distance < best->distance))
                best = Projection{point + (found->point - image), found->distance};
        if (!best) return std::nullopt;
        const double depth = best->distance / space_.spacing;
        if (depth < on_surface) return Nearest{outward_at(point), 0};
        const Vec to_surface = (best->point - point) / best->distance;
        const bool is_outside = inside_.side_of(point) == Side::outside;
        return is_outside ? Nearest{-to_surface, -depth} : Nearest{to_surface, depth};
    }

  private:
    static CurveSet drawn(const Region& region, const ParticleSpace& space) {
        CurveSet curves;
        for (const Polyline& loop : region.loops)
            for (std::size_t k = 0; k < loop.points.size(); ++k) {
                const std::vector<Vec> ends{loop.points[k], loop.points[(k + 1) % loop.points.size()]};
                if (!on_open_side(ends, space)) curves.pieces.push_back({ends, false});
            }
        return curves;
    }
    /// From a point on the surface: the mean direction in which the area does not lie.
    [[nodiscard]] Vec outward_at(const Vec& point) const {
        constexpr int directions = 64;
        Vec sum = Vec::Zero();
        for (int k = 0; k < directions; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / directions;
            const Vec direction(std::cos(angle), std::sin(angle), 0);
            if (inside_.side_of(point + 0.1 * space_.spacing * direction) == Side::outside) sum += direction;
        }
        return sum.norm() > 0 ? Vec(sum.normalized()) : Vec(Vec::Zero());
    }

    const ParticleSpace& space_;
    InsideTest inside_;
    NearestCurve curve_;
};

/// A volume's surface.
class VolumeSurface {
  public:
    VolumeSurface(const TriangleSurface& surface, const ParticleSpace& space)
        : space_(space), surface_(without_open_sides(surface, space)), nearest_(surface_, reach * space.spacing) {}

    [[nodiscard]] std::optional<Nearest> operator()(const Vec& point) const {
        std::optional<SurfacePoint> best;
        Vec from_image = Vec::Zero();
        for (const Vec& image : images_of(point, space_))
            if (const auto found = nearest_.nearest(image); found && (!best || found->distance < best->distance)) {
                best = found;
                from_image = found->point - image;
            }
        if (!best) return std::nullopt;
        const auto& corners = surface_.triangles[static_cast<std::size_t>(best->triangle)];
        const auto corner = [&](std::size_t k) -> const Vec& {
            return surface_.corners[static_cast<std::size_t>(corners.at(k))];
        };
        const Vec facing = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        const double depth = best->distance / space_.spacing;
        if (depth < on_surface) return Nearest{facing, 0};
        const Vec to_surface = from_image / best->distance;
        return to_surface.dot(facing) < 0 ? Nearest{-to_surface, -depth} : Nearest{to_surface, depth};
    }

  private:
    const ParticleSpace& space_;
    TriangleSurface surface_;
    NearestTriangle nearest_;
};

/// How far the other side is, against the normal: by steps to the nearest surface, which never pass one [spacings].
double opposite_of(const Nearest& here, const Vec& point, double spacing, const FindNearest& nearest) {
    constexpr double there = 0.01, least_step = 0.02;
    double way = std::max(here.depth, least_step);
    // The particle's own surface stays the nearest one until half-way through.
    while (way < reach) {
        const auto found = nearest(point - way * spacing * here.outward);
        if (!found) return reach;
        if (found->depth < there && found->outward.dot(here.outward) < 0.5) return way + found->depth;
        way += std::max(found->depth, least_step);
    }
    return reach;
}

void set_surface(ParticleSet& set, std::size_t i, const SolidSurface& surface) {
    set.wall_normal[i] = surface.normal;
    set.wall_distance[i] = surface.depth;
    set.opposite_distance[i] = surface.opposite;
}

void find_surface_of_solid(ParticleSet& set, int part, const FindNearest& nearest) {
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.part[i] != part) continue;
        const auto here = nearest(set.position[i]);
        const double far = reach * set.spacing;
        if (!here) {
            set_surface(set, i, {Vec::Zero(), far, far});
        } else {
            const double opposite = opposite_of(*here, set.position[i], set.spacing, nearest);
            set_surface(set, i, {here->outward, here->depth * set.spacing, opposite * set.spacing});
        }
    }
}

void find_surface_of_sheet(ParticleSet& set, int part, double thickness, bool has_middle_row,
                           const std::function<std::optional<Vec>(const Vec&)>& nearest_of_middle) {
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.part[i] != part) continue;
        const auto middle = nearest_of_middle(set.position[i]);
        if (!middle) continue;
        Vec off = nearest_image(set.position[i] - *middle, set);
        const double height = off.norm();
        // The middle one of an odd number of rows, which follow one another across the strip, has two surfaces.
        const bool is_in_the_middle = height < on_surface * set.spacing;
        if (is_in_the_middle && !has_middle_row) continue;
        if (is_in_the_middle) off = nearest_image(set.position[i - 1] - set.position[i], set);
        set_surface(set, i, {off.normalized(), thickness / 2 - height, thickness / 2 + height});
    }
}

void find_surface_of_sheet(ParticleSet& set, int part, double thickness, bool has_middle_row, const Sheet& sheet) {
    const double near = reach * set.spacing;
    if (set.dimension == 2) {
        const NearestCurve middle(sheet.curves, near);
        find_surface_of_sheet(set, part, thickness, has_middle_row, [&](const Vec& point) -> std::optional<Vec> {
            const auto found = middle.nearest(point);
            return found ? std::optional(found->point) : std::nullopt;
        });
    } else {
        const NearestTriangle middle(sheet.surface, near);
        find_surface_of_sheet(set, part, thickness, has_middle_row, [&](const Vec& point) -> std::optional<Vec> {
            const auto found = middle.nearest(point);
            return found ? std::optional(found->point) : std::nullopt;
        });
    }
}

StripRows rows_of(const Sheet& sheet, const Scene& scene) {
    return scene.dimension == 3 ? StripRows{2, scene.particles.spacing} : strip_rows(*sheet.part, scene);
}

/// As thick as its rows of particles at most; says so where that is not the material's thickness.
double thickness_of_rows(const Sheet& sheet, const Scene& scene, MeshReport& report) {
    const StripRows rows = rows_of(sheet, scene);
    const std::string name = *sheet.part->name;
    const bool is_given = sheet.part->thickness.given() || report.dimension == 3;
    if (sheet.thickness <= (1 + 1e-9) * rows.thickness()) {
        report.notes.push_back(
            name + ": its surfaces are " + length_text(sheet.thickness) + " apart" +
            (is_given ? "" : ", by its mass_per_length and the liquid's density; `thickness` sets it") +
            (rows.count > 2 ? ", on " + std::to_string(rows.count) + " rows of particles" : ""));
        return sheet.thickness;
    }
    report.warnings.push_back(
        name + ": is " + length_text(sheet.thickness) + " thick" +
        (is_given ? "" : " by its mass_per_length and the liquid's density") +
        ", and liquid flows past its two rows of particles as if it were " + length_text(rows.thickness()) +
        (report.dimension == 3 ? "; draw it as a volume, or take a larger particles.spacing"
         : is_given            ? "; leave out cross_bonds and shear_stiffness, draw it as an area, or take a larger "
                                 "particles.spacing"
                               : "; give its `thickness`, and it has as many rows as it is thick"));
    return rows.thickness();
}

}  // namespace

double strip_thickness(const Part& strip, const Scene& scene) {
    if (strip.thickness.given()) return strip.thickness;
    double density = 0;
    for (const Part* fluid : scene.parts_of(PartKind::fluid)) density = std::max(density, fluid->density.value);
    return density > 0 ? strip.mass_per_length / density : 0;
}

double thickness_between_sides(const Sheet& sheet, const Scene& scene) {
    const double of_rows = rows_of(sheet, scene).thickness();
    if (sheet.thickness <= 0) return of_rows;
    return scene.parts_of(PartKind::fluid).empty() ? sheet.thickness : std::min(sheet.thickness, of_rows);
}

void find_body_surfaces(const Geometry& geometry, const Scene& scene, const std::vector<Sheet>& sheets,
                        MeshResult& result) {
    ParticleSet& set = result.particles;
    if (scene.parts_of(PartKind::fluid).empty() || set.count(PartKind::elastic) == 0) return;
    set.opposite_distance.assign(set.size(), 0);
    for (const Part* part : scene.parts_of(PartKind::elastic)) {
        const int number = set.part_named(part->name);
        const auto sheet = std::ranges::find(sheets, part, &Sheet::part);
        if (sheet != sheets.end()) {
            const bool has_middle_row = set.dimension == 2 && strip_rows(*part, scene).count % 2 == 1;
            find_surface_of_sheet(set, number, thickness_of_rows(*sheet, scene, result.report), has_middle_row, *sheet);
        } else if (const Region* region = geometry.region(part->name)) {
            find_surface_of_solid(set, number, AreaSurface(*region, set));
        } else if (const Solid* solid = geometry.solid(part->name)) {
            find_surface_of_solid(set, number, VolumeSurface(solid->surface, set));
        }
    }
}

}  // namespace dmp::mesher
