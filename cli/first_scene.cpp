// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/first_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "base/length_text.hpp"
#include "cli/first_guess.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "geometry/flat_ends.hpp"
#include "geometry/nearest_triangle.hpp"
#include "geometry/select_faces.hpp"
#include "geometry/surface_box.hpp"
#include "geometry/winding_number.hpp"

namespace dmp::cli {

namespace {

/// What lies in 2-D at one end of the fluid.
struct Cap {
    double area = 0;
    Vec centre = Vec::Zero();
};

Cap cap_at(const TriangleSurface& surface, int axis, double position, double tolerance) {
    Cap cap;
    for (const auto& [a, b, c] : surface.triangles) {
        const Vec &p = surface.corners[static_cast<std::size_t>(a)], &q = surface.corners[static_cast<std::size_t>(b)],
                  &r = surface.corners[static_cast<std::size_t>(c)];
        if (std::max({std::abs(p[axis] - position), std::abs(q[axis] - position), std::abs(r[axis] - position)}) >
            tolerance)
            continue;
        const double area = 0.5 * (q - p).cross(r - p).norm();
        cap.area += area;
        cap.centre += area * (p + q + r) / 3;
    }
    if (cap.area > 0) cap.centre /= cap.area;
    return cap;
}

/// Whether a body's surface comes into the fluid, or the fluid is less than what its ends and its length enclose.
bool is_obstructed(const Geometry& geometry, const Solid& fluid, double swept_volume, double tolerance) {
    if (fluid.volume() < 0.99 * swept_volume) return true;
    const WindingNumber winding(fluid.surface);
    const NearestTriangle surface(fluid.surface, tolerance);
    const auto in_fluid = [&](const Vec& corner) { return !surface.nearest(corner) && winding.inside(corner); };
    return std::ranges::any_of(geometry.solids, [&](const Solid& solid) {
        return solid.name != fluid.name && std::ranges::any_of(solid.surface.corners, in_fluid);
    });
}

/// Writes one scene.
class Author {
  public:
    Author(const Geometry& geometry, bool unit_given)
        : geometry_(geometry),
          unit_given_(unit_given),
          fluid_(choose_fluid()),
          liquid_(liquid_named(fluid_.name)),
          box_(box_of(fluid_.surface)) {
        find_caps();
        choose_numbers();
    }

    FirstScene write() {
        const std::string parts = written_parts();  // may assume more
        const SceneDraft draft{geometry_, unit_given_, fluid_.name,    assumptions_,
                               spacing_,  parts,       written_flow(), duration_};
        return {draft.text(), assumptions_};
    }

  private:
    [[nodiscard]] char axis_name() const { return "xyz"[axis_]; }
    void assume(const std::string& what) { assumptions_.push_back(what); }

    const Solid& choose_fluid() {
        if (geometry_.solids.empty())
            throw InputError({geometry_.file, 0, 0}, "the geometry has no closed body that could hold the fluid",
                             "'dmp inspect' says what is open; close it in the program that made the geometry.");
        for (const Solid& solid : geometry_.solids)
            if (sounds_like_a_fluid(solid.name)) {
                assume("'" + solid.name + "' is the fluid, by its name");
                return solid;
            }
        const Solid& largest = *std::ranges::max_element(geometry_.solids, {}, &Solid::volume);
        assume("'" + largest.name + "' is the fluid" +
               (geometry_.solids.size() > 1 ? ": the largest body" : ": the only body"));
        return largest;
    }

    /// Flat ends along the longest axis that could be one and the same section.
    void find_caps() {
        const Vec extent = box_.extent();
        extent.maxCoeff(&axis_);
        tolerance_ = 1e-5 * extent.norm();
        const Cap low = cap_at(fluid_.surface, axis_, box_.low[axis_], tolerance_);
        const Cap high = cap_at(fluid_.surface, axis_, box_.high[axis_], tolerance_);
        Vec apart = high.centre - low.centre;
        apart[axis_] = 0;
        const double width = std::sqrt(low.area);
        periodic_ = low.area > 0 && std::abs(high.area / low.area - 1) < 0.01 && apart.norm() < 0.01 * width;
        if (!periodic_) return;
        centre_ = low.centre;
        obstructed_ = is_obstructed(geometry_, fluid_, low.area * extent[axis_], 0.01 * width);
        const int one = (axis_ + 1) % 3, other = (axis_ + 2) % 3;
        const double round = std::numbers::pi / 4 * extent[one] * extent[other];
        if (std::abs(extent[one] / extent[other] - 1) < 0.02 && std::abs(low.area / round - 1) < 0.02)
            radius_ = 0.25 * (extent[one] + extent[other]);
        // Flexible sheets would be torn along by a flow that starts as if they were not there.
        if (std::ranges::none_of(geometry_.surfaces, [&](const SurfaceSet& set) { return lies_in_the_fluid(set); }))
            return;
        obstructed_ = true;
        radius_.reset();
    }

    void choose_numbers() {
        const double across = box_.extent().minCoeff();
        spacing_ = across / particles_across;
        const double count = fluid_.volume() / std::pow(spacing_, 3);
        if (count > most_particles) spacing_ *= std::cbrt(count / most_particles);
        if (periodic_) spacing_ = std::min(spacing_, box_.extent()[axis_] / 4.5);
        spacing_ = rounded(spacing_);
        assume(fmt::format("{} between particles: {:.3g} across the fluid's smallest extent, {}", length_text(spacing_),
                           across / spacing_, length_text(across)));
        assume(
            fmt::format("it is {}: {:g} kg/m^3, {:g} mPa s", liquid_.what, liquid_.density, 1e3 * liquid_.viscosity));
        const double kinematic_viscosity = liquid_.viscosity / liquid_.density;
        speed_ = reynolds_number * kinematic_viscosity / across;
        // Poiseuille's in a pipe, u = -dp/dx R^2 / (4 mu) in the middle; of the right size elsewhere.
        gradient_ = -4 * liquid_.viscosity * speed_ / std::pow(0.5 * across, 2);
        duration_ = across / speed_;
    }

    [[nodiscard]] std::string free_name(const std::string& name) const {
        return name_that_is_free(name, geometry_.names());
    }

    /// Whether a named surface is an end of the period: no wall.
    [[nodiscard]] bool is_cap(const SurfaceSet& set) const {
        const Box box = box_of(set.surface);
        return periodic_ && box.extent()[axis_] <= tolerance_ &&
               std::min(std::abs(box.low[axis_] - box_.low[axis_]), std::abs(box.low[axis_] - box_.high[axis_])) <=
                   tolerance_;
    }

    /// Most of it has fluid on both sides.
    [[nodiscard]] bool lies_in_the_fluid(const SurfaceSet& set) const {
        double both = 0;
        const WindingNumber fluid(fluid_.surface);
        for (const auto& [a, b, c] : set.surface.triangles) {
            const auto corner = [&](int k) -> const Vec& { return set.surface.corners[static_cast<std::size_t>(k)]; };
            const Vec across = (corner(b) - corner(a)).cross(corner(c) - corner(a));
            const Vec middle = (corner(a) + corner(b) + corner(c)) / 3;
            const Vec aside = 1e-3 * box_.extent().norm() * across.normalized();
            if (fluid.inside(middle + aside) && fluid.inside(middle - aside)) both += 0.5 * across.norm();
        }
        return both > 0.9 * set.surface.area();
    }

    /// The walls on which most corners of a sheet lie; empty: none touches it.
    [[nodiscard]] std::string held_by(const SurfaceSet& sheet, const std::vector<FaceSelection>& asked) const {
        Geometry cad_geometry = geometry_;
        if (has_faces(asked)) select_faces(cad_geometry, asked);
        std::string best;
        std::ptrdiff_t most = 0;
        const auto consider = [&](const std::string& name, const TriangleSurface& surface) {
            const NearestTriangle nearest(surface, 0.1 * spacing_);
            const std::ptrdiff_t held = std::ranges::count_if(
                sheet.surface.corners, [&](const Vec& corner) { return nearest.nearest(corner).has_value(); });
            if (held <= most) return;
            best = name;
            most = held;
        };
        for (const SurfaceSet& set : cad_geometry.surfaces)
            if (set.name != sheet.name && !is_cap(set)) consider(set.name, set.surface);
        for (const Solid& solid : cad_geometry.solids)
            if (solid.name != fluid_.name) consider(solid.name, solid.surface);
        return best;
    }

    /// A shell of springs that what drives the fluid bends by a tenth of its length: as a strip of length L that is
    /// held at one end, by p L^4 / (8 D) under the pressure p.
    std::string written_sheet(const SurfaceSet& sheet, const std::vector<FaceSelection>& asked) {
        constexpr double bend = 0.1;
        const double thickness = 2 * spacing_, length = std::sqrt(sheet.surface.area());
        const double pressure = periodic_ ? -gradient_ * box_.extent()[axis_] : 10 * liquid_.density * speed_ * speed_;
        const double stiffness = 12 * pressure * std::pow(length, 3) / (8 * bend * std::pow(thickness, 3));
        const std::string anchor = held_by(sheet, asked);
        assume(fmt::format(
            "'{}' lies in the fluid: flexible, {}; E = {:.2g} Pa, so that {:.2g} Pa bend it by about "
            "{:g} % of its length",
            sheet.name, anchor.empty() ? "free" : "clamped at '" + anchor + "'", stiffness, pressure, 100 * bend));
        return fmt::format(
                   "\n[[part]]\nname = \"{}\"\nkind = \"elastic\"\ndensity = \"{:g} kg/m^3\"\n"
                   "youngs_modulus = \"{:.3g} Pa\"\nthickness = \"{}\"\n",
                   sheet.name, liquid_.density, stiffness, in_millimetres(thickness, 0)) +
               (anchor.empty() ? "" : fmt::format("anchor = \"{}\"\n", anchor));
    }

    /// Ends of branches besides those of the period, that no named surface closes.
    [[nodiscard]] std::vector<FlatEnd> closed_ends() const {
        std::vector<FlatEnd> ends = flat_ends(fluid_.surface);
        std::erase_if(ends, [&](const FlatEnd& end) {
            const auto is_at = [&](double position) {
                return periodic_ && end.box.extent()[axis_] <= tolerance_ &&
                       std::abs(end.centre[axis_] - position) <= tolerance_;
            };
            if (is_at(box_.low[axis_]) || is_at(box_.high[axis_])) return true;
            return std::ranges::any_of(geometry_.surfaces, [&](const SurfaceSet& set) {
                return NearestTriangle(set.surface, tolerance_).nearest(end.centre).has_value();
            });
        });
        return ends;
    }

    /// The selection of an end that lies across an axis; none of another, which stays a piece of the wall.
    [[nodiscard]] std::optional<FaceSelection> selection_of(const FlatEnd& end, int number) const {
        // Finer triangles follow a round rim further out; the plane keeps to the end.
        const Vec room = Vec::Constant(0.02 * end.box.extent().norm());
        FaceSelection selection{.name = free_name("closed_end_" + std::to_string(number)), .of = fluid_.name};
        for (int axis = 0; axis < 3; ++axis)
            if (end.box.extent()[axis] <= tolerance_) {
                selection.in_plane.at(static_cast<std::size_t>(axis)) = end.centre[axis];
                selection.in_box = Box{.low = end.box.low - room, .high = end.box.high + room};
                return selection;
            }
        return std::nullopt;
    }

    [[nodiscard]] static std::string end_text(const FlatEnd& end) {
        const double millimetre = 1e-3;
        return fmt::format("of {:.3g} mm^2 around ({:.4g}, {:.4g}, {:.4g}) mm", end.area / (millimetre * millimetre),
                           end.centre[0] / millimetre, end.centre[1] / millimetre, end.centre[2] / millimetre);
    }

    std::string written_parts() {
        std::string parts = written_fluid(fluid_.name, liquid_);
        std::string selections, walls;
        std::vector<const SurfaceSet*> sheets;
        std::vector<FaceSelection> asked;
        std::vector<std::string> taken;
        const auto wall = [&](const std::string& name) {
            parts += written_wall(name);
            walls += (walls.empty() ? "'" : ", '") + name + "'";
        };
        for (const Solid& solid : geometry_.solids)
            if (solid.name != fluid_.name) wall(solid.name);
        for (const SurfaceSet& set : geometry_.surfaces) {
            taken.push_back(set.name);
            if (lies_in_the_fluid(set)) {
                sheets.push_back(&set);
                continue;
            }
            if (!is_cap(set)) {
                wall(set.name);
                continue;
            }
            parts += written_left_out(set.name, "an end of the period");
        }
        for (const auto& [name, positions] : geometry_.points) parts += written_left_out(name, "points");
        for (const bool high : {false, true}) {
            if (!periodic_) break;
            FaceSelection cap{.name = free_name(high ? "outlet" : "inlet"), .of = fluid_.name};
            const double position = (high ? box_.high : box_.low)[axis_];
            cap.in_plane.at(static_cast<std::size_t>(axis_)) = position;
            selections += written_selection(cap, box_.extent().norm(), 3);
            taken.push_back(cap.name);
            asked.push_back(cap);
        }
        int number = 0;
        for (const FlatEnd& end : closed_ends()) {
            const auto selection = selection_of(end, ++number);
            assume(fmt::format("the flat end {} is {}: nothing flows through it", end_text(end),
                               selection ? "a wall, '" + selection->name + "'" : "a piece of the wall"));
            if (!selection) continue;
            selections += written_selection(*selection, box_.extent().norm(), 3);
            taken.push_back(selection->name);
            asked.push_back(*selection);
            wall(selection->name);
        }
        const FaceSelection rest{.name = free_name("wall"), .of = fluid_.name, .except = taken};
        asked.push_back(rest);
        // All of it, with room to spare: finer particles follow round walls further out.
        const Box around{.low = box_.low - box_.extent(), .high = box_.high + box_.extent()};
        if (taken.empty()) asked.back().in_box = around;
        if (has_faces(asked)) {
            selections += written_selection(asked.back(), box_.extent().norm(), 3);
            wall(rest.name);
        }
        for (const SurfaceSet* sheet : sheets) parts += written_sheet(*sheet, asked);
        assume("walls that do not move and that the fluid sticks to: " + (walls.empty() ? "none" : walls));
        return selections + parts;
    }

    [[nodiscard]] bool has_faces(const std::vector<FaceSelection>& asked) const {
        Geometry copy = geometry_;
        try {
            select_faces(copy, asked);
        } catch (const InputError&) {  // nothing is left over
            return false;
        }
        return true;
    }

    [[nodiscard]] std::string written_flow() const {
        std::string flow = fmt::format("\n[flow]\nlargest_speed = \"{:.4g} m/s\"\n",
                                       (obstructed_ ? faster_past_bodies : faster) * speed_);
        if (!periodic_) return flow;
        std::array<std::string, 3> drive{"0", "0", "0"}, start{"0", "0", "0"};
        drive.at(static_cast<std::size_t>(axis_)) = fmt::format("\"{:.4g} Pa/m\"", gradient_);
        flow += fmt::format("periodic = [\"{}\"]\npressure_gradient = [{}, {}, {}]\n", axis_name(), drive[0], drive[1],
                            drive[2]);
        if (radius_) {
            const int one = (axis_ + 1) % 3, other = (axis_ + 2) % 3;
            const auto from_centre = [&](int axis) {
                const std::string off_axis = in_millimetres(std::abs(centre_[axis]), box_.extent().norm());
                if (off_axis == "0 mm") return fmt::format("{}^2", "xyz"[axis]);
                return fmt::format("({} {} {})^2", "xyz"[axis], centre_[axis] < 0 ? '+' : '-', off_axis);
            };
            start.at(static_cast<std::size_t>(axis_)) =
                fmt::format("\"{:.4g} m/s * (1 - ({} + {}) / ({})^2)\"", speed_, from_centre(one), from_centre(other),
                            in_millimetres(*radius_, 0));
            flow += fmt::format("initial_velocity = [{}, {}, {}]\n", start[0], start[1], start[2]);
        }
        return flow;
    }

  public:
    void tell_flow() {
        if (!periodic_) {
            assume("it is enclosed, at rest and not driven: no two of its ends are flat, alike and square to an axis");
            return;
        }
        assume(fmt::format("what leaves along {} comes in again: its ends there are flat and alike", axis_name()));
        assume(fmt::format("driven along {} by {:.3g} Pa/m, for about {:.3g} m/s, a Reynolds number of {:.2g}",
                           axis_name(), gradient_, speed_, reynolds_number));
        if (!radius_)
            assume("it starts at rest");
        else if (obstructed_)
            assume(
                "it starts from the parabolic profile of a round pipe, as if nothing stood in it, and finds its way");
        else
            assume("it starts from the parabolic profile of a round pipe");
    }

  private:
    const Geometry& geometry_;
    bool unit_given_;
    std::vector<std::string> assumptions_;
    const Solid& fluid_;
    const Liquid& liquid_;
    Box box_;
    int axis_ = 0;
    double tolerance_ = 0;
    bool periodic_ = false, obstructed_ = false;
    Vec centre_ = Vec::Zero();
    std::optional<double> radius_;
    double spacing_ = 0, speed_ = 0, duration_ = 0;
    double gradient_ = 0;  ///< of the pressure that drives it [Pa/m]
};

}  // namespace

FirstScene first_scene(const Geometry& geometry, bool unit_given) {
    if (geometry.dimension == 2) return first_scene_in_plane(geometry, unit_given);
    Author author(geometry, unit_given);
    author.tell_flow();
    return author.write();
}

}  // namespace dmp::cli
