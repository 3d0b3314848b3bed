// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/first_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "cli/text.hpp"
#include "geometry/nearest_triangle.hpp"
#include "geometry/select_faces.hpp"
#include "geometry/surface_box.hpp"
#include "geometry/winding_number.hpp"
#include "scene/toml_node.hpp"

namespace dmp::cli {

namespace {

constexpr double reynolds_number = 10, particles_across = 20, most_particles = 2e5;
/// What the fluid speeds up to, over the speed that it is driven to in the empty section.
constexpr double faster = 1.5, faster_past_bodies = 2;

struct Liquid {
    const char* name;  ///< what part of the fluid's name says that it is this
    const char* what;
    double density, viscosity;  ///< [kg/m^3], [Pa s]
};

/// The first one where no name fits.
constexpr std::array<Liquid, 3> liquids{
    {{"water", "water", 1000, 1e-3}, {"blood", "blood, Newtonian", 1060, 3.5e-3}, {"air", "air", 1.2, 1.8e-5}}};

/// A length as scenes have it; what is as good as 0 beside `size` is 0.
std::string in_millimetres(double length, double size) {
    return std::abs(length) < 1e-9 * size ? "0 mm" : fmt::format("{:.9g} mm", 1e3 * length);
}

/// To two digits.
double rounded(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return std::max(1.0, std::round(value / unit)) * unit;
}

std::string in_small_letters(std::string name) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
}

const Liquid& liquid_named(const std::string& name) {
    const std::string lower = in_small_letters(name);
    const auto* found = std::ranges::find_if(
        liquids, [&](const Liquid& liquid) { return lower.find(liquid.name) != std::string::npos; });
    return found == liquids.end() ? liquids.front() : *found;
}

bool sounds_like_a_fluid(const std::string& name) {
    const std::string lower = in_small_letters(name);
    constexpr std::array<const char*, 9> words{"fluid",  "blood", "water", "lumen",  "liquid",
                                               "plasma", "mucus", "air",   "channel"};
    return std::ranges::any_of(words, [&](const char* word) { return lower.find(word) != std::string::npos; });
}

/// What lies in the plane at one end of the fluid.
struct Cap {
    double area = 0;
    Vec centre = Vec::Zero();
};

Cap cap_at(const TriangleSurface& surface, int axis, double place, double tolerance) {
    Cap cap;
    for (const auto& [a, b, c] : surface.triangles) {
        const Vec &p = surface.corners[static_cast<std::size_t>(a)], &q = surface.corners[static_cast<std::size_t>(b)],
                  &r = surface.corners[static_cast<std::size_t>(c)];
        if (std::max({std::abs(p[axis] - place), std::abs(q[axis] - place), std::abs(r[axis] - place)}) > tolerance)
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
        text_ = "# A first scene, made by 'dmp new' of " + file_name() + ". It assumes:\n";
        const std::string parts = written_parts();  // may assume more
        for (const std::string& assumption : assumptions_) text_ += "# - " + assumption + "\n";
        text_ += fmt::format("schema = 1\ntitle = \"First scene of {}\"\ndimension = 3\n\n[geometry]\nfile = {}\n",
                             fluid_.name, toml_quoted(file_name()));
        if (unit_given_) text_ += fmt::format("unit = \"{:.17g} m\"\n", geometry_.unit);
        text_ += fmt::format("\n[particles]\nspacing = \"{}\"\n", in_millimetres(spacing_, 0)) + parts +
                 written_flow() +
                 fmt::format(
                     "\n[run]\nduration = \"{:.3g} s\"\n\n[output]\nevery = \"{:.3g} s\"\n"
                     "fields = [\"velocity\", \"pressure\"]\n",
                     duration_, duration_ / 20);
        return {text_, assumptions_};
    }

  private:
    [[nodiscard]] std::string file_name() const { return std::filesystem::path(geometry_.file).filename().string(); }
    [[nodiscard]] char axis_name() const { return "xyz"[axis_]; }
    void assume(const std::string& what) { assumptions_.push_back(what); }

    const Solid& choose_fluid() {
        if (geometry_.dimension != 3)
            throw InputError({geometry_.file, 0, 0}, "first scenes are made for drawings in space only",
                             "Start from a case in the plane, such as cases/vein_valve.");
        if (geometry_.solids.empty())
            throw InputError({geometry_.file, 0, 0}, "the drawing has no closed body that could hold the fluid",
                             "'dmp inspect' says what is open; close it in the program that made the drawing.");
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
        // Poiseuille's in a pipe, u = a R^2 / (4 nu) in the middle; of the right size elsewhere.
        acceleration_ = 4 * kinematic_viscosity * speed_ / std::pow(0.5 * across, 2);
        duration_ = across / speed_;
    }

    [[nodiscard]] std::string free_name(std::string name) const {
        const auto names = geometry_.names();
        while (std::ranges::find(names, name) != names.end()) name += "_end";
        return name;
    }

    static std::string written_wall(const std::string& name) {
        return fmt::format("\n[[part]]\nname = \"{}\"\nkind = \"rigid\"\n", name);
    }

    /// Whether a named surface is an end of the period: no wall.
    [[nodiscard]] bool is_cap(const SurfaceSet& set) const {
        const Box box = box_of(set.surface);
        return periodic_ && box.extent()[axis_] <= tolerance_ &&
               std::min(std::abs(box.low[axis_] - box_.low[axis_]), std::abs(box.low[axis_] - box_.high[axis_])) <=
                   tolerance_;
    }

    std::string written_parts() {
        std::string parts = fmt::format(
            "\n[[part]]\nname = \"{}\"\nkind = \"fluid\"\ndensity = \"{:g} kg/m^3\"\nviscosity = \"{:g} mPa*s\"\n",
            fluid_.name, liquid_.density, 1e3 * liquid_.viscosity);
        std::string selections, walls;
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
            if (!is_cap(set)) {
                wall(set.name);
                continue;
            }
            parts += written_wall(set.name) + "enabled = false  # an end of the period\n";
        }
        for (const bool high : {false, true}) {
            if (!periodic_) break;
            FaceSelection cap{.name = free_name(high ? "outlet" : "inlet"), .of = fluid_.name};
            const double place = (high ? box_.high : box_.low)[axis_];
            cap.in_plane.at(static_cast<std::size_t>(axis_)) = place;
            selections += fmt::format("\n[[select]]\nname = \"{}\"\nof = \"{}\"\n{} = \"{}\"\n", cap.name, fluid_.name,
                                      axis_name(), in_millimetres(place, box_.extent().norm()));
            taken.push_back(cap.name);
            asked.push_back(cap);
        }
        const FaceSelection rest{.name = free_name("wall"), .of = fluid_.name, .except = taken};
        asked.push_back(rest);
        // All of it, with room to spare: finer particles follow round walls further out.
        const Box around{.low = box_.low - box_.extent(), .high = box_.high + box_.extent()};
        if (taken.empty()) asked.back().in_box = around;
        if (has_faces(asked)) {
            selections += fmt::format("\n[[select]]\nname = \"{}\"\nof = \"{}\"\n", rest.name, fluid_.name);
            if (taken.empty())
                selections += fmt::format("from = [{}]\nto = [{}]\n", written(around.low), written(around.high));
            else
                selections += fmt::format("except = [{}]\n", listed(taken));
            wall(rest.name);
        }
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

    [[nodiscard]] std::string written(const Vec& place) const {
        std::string list;
        for (const double x : place)
            list += (list.empty() ? "\"" : ", \"") + in_millimetres(x, box_.extent().norm()) + "\"";
        return list;
    }
    static std::string listed(const std::vector<std::string>& names) {
        std::string list;
        for (const std::string& name : names) list += (list.empty() ? "\"" : ", \"") + name + "\"";
        return list;
    }

    [[nodiscard]] std::string written_flow() const {
        std::string flow = fmt::format("\n[flow]\nlargest_speed = \"{:.4g} m/s\"\n",
                                       (obstructed_ ? faster_past_bodies : faster) * speed_);
        if (!periodic_) return flow;
        std::array<std::string, 3> force{"0", "0", "0"}, start{"0", "0", "0"};
        force.at(static_cast<std::size_t>(axis_)) = fmt::format("\"{:.4g} m/s^2\"", acceleration_);
        flow += fmt::format("periodic = [\"{}\"]\nacceleration = [{}, {}, {}]\n", axis_name(), force[0], force[1],
                            force[2]);
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
            assume("it is enclosed, at rest and not driven: its ends are not two flat sections that are alike");
            return;
        }
        assume(fmt::format("what leaves along {} comes in again: its ends there are flat and alike", axis_name()));
        assume(fmt::format("driven along {} at {:.3g} m/s^2, for about {:.3g} m/s, a Reynolds number of {:.2g}",
                           axis_name(), acceleration_, speed_, reynolds_number));
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
    double spacing_ = 0, speed_ = 0, acceleration_ = 0, duration_ = 0;
    std::string text_;
};

}  // namespace

FirstScene first_scene(const Geometry& geometry, bool unit_given) {
    Author author(geometry, unit_given);
    author.tell_flow();
    return author.write();
}

}  // namespace dmp::cli
