// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/length_text.hpp"
#include "base/nearest_name.hpp"
#include "cli/first_guess.hpp"
#include "cli/first_scene.hpp"
#include "cli/plane_guess.hpp"
#include "cli/text.hpp"

namespace dmp::cli {

namespace {

/// Particles at the narrowest tip, and along the shortest flexible curve.
constexpr double particles_at_a_tip = 6, particles_along = 8;
/// Nothing is to happen faster than in this time [s]: at a fixed Reynolds number it would where all is small.
constexpr double shortest_passage = 0.01;
/// What drives the fluid bends flexible curves by this much of their length.
constexpr double bend = 0.1;
/// Of flexible curves: two rows [spacings].
constexpr double thickness = 2;

class AuthorInPlane {
  public:
    AuthorInPlane(const Geometry& geometry, bool unit_given)
        : geometry_(geometry), unit_given_(unit_given), guess_(guess_of_plane(geometry)), liquid_(&liquid_named("")) {
        choose_fluid();
        choose_numbers();
    }

    FirstScene write() {
        const std::string parts = written_parts(), flow = written_flow();  // assume more
        const SceneDraft draft{geometry_, unit_given_, geometry_.regions.front().name, assumptions_, spacing_, parts,
                               flow,      duration_};
        return {draft.text(), assumptions_};
    }

  private:
    void assume(const std::string& what) { assumptions_.push_back(what); }
    [[nodiscard]] double size() const { return guess_.box.extent().norm(); }

    void choose_fluid() {
        std::vector<std::string> areas;
        for (const Region& region : geometry_.regions) areas.push_back(region.name);
        const auto named = std::ranges::find_if(
            areas, [](const std::string& name) { return &liquid_named(name) != &liquid_named(""); });
        if (named != areas.end()) liquid_ = &liquid_named(*named);
        assume(areas.size() == 1 ? quoted_list(areas) + " is the fluid: the only area"
                                 : quoted_list(areas) + " are areas of fluid, all of the same one");
        assume(fmt::format("it is {}: {:g} kg/m^3, {:g} mPa s", liquid_->what, liquid_->density,
                           1e3 * liquid_->viscosity));
    }

    void choose_numbers() {
        const double across = guess_.across;
        const double tip = guess_.narrowest_tip / particles_at_a_tip;
        spacing_ = std::min(across / particles_across, tip);
        for (const CurveGuess& curve : guess_.curves)
            if (curve.role == CurveRole::flexible) spacing_ = std::min(spacing_, curve.shortest / particles_along);
        spacing_ = std::max(spacing_, std::sqrt(guess_.area / most_particles));
        for (const int axis : {0, 1})
            if (guess_.periodic.at(static_cast<std::size_t>(axis)))
                spacing_ = std::min(spacing_, guess_.box.extent()[axis] / 4.5);
        spacing_ = rounded(spacing_);
        assume(fmt::format("{} between particles: {:.3g} across the usual distance between walls, {}",
                           length_text(spacing_), across / spacing_, length_text(across)) +
               (std::isfinite(tip)
                    ? fmt::format("; {:.3g} at the narrowest tip of a flexible curve", guess_.narrowest_tip / spacing_)
                    : ""));
        const double kinematic_viscosity = liquid_->viscosity / liquid_->density;
        speed_ = std::min(reynolds_number * kinematic_viscosity / across, across / shortest_passage);
        // Poiseuille's between plates, u = -dp/dx H^2 / (8 mu) in the middle; of the right size elsewhere.
        gradient_ = -8 * liquid_->viscosity * speed_ / (across * across);
        duration_ = across / speed_;
        axis_ = guess_.periodic[0] == guess_.periodic[1] ? guess_.longest_axis() : (guess_.periodic[0] ? 0 : 1);
    }

    [[nodiscard]] bool is_periodic() const { return guess_.periodic[0] || guess_.periodic[1]; }
    [[nodiscard]] char axis_name() const { return "xy"[axis_]; }
    [[nodiscard]] double reynolds() const { return speed_ * guess_.across * liquid_->density / liquid_->viscosity; }

    std::string written_parts() {
        std::string selections, parts;
        std::vector<std::string> walls, ends, left_out;
        for (const Region& region : geometry_.regions) parts += written_fluid(region.name, *liquid_);
        for (const FaceSelection& cap : guess_.caps) selections += written_selection(cap, size(), 2);
        for (const FaceSelection& wall : guess_.walls) {
            selections += written_selection(wall, size(), 2);
            walls.push_back(wall.name);
            parts += written_wall(wall.name);
        }
        std::vector<std::string> anchors;
        for (const CurveGuess& curve : guess_.curves) {
            if (curve.role == CurveRole::flexible) {
                parts += written_flexible(curve);
                anchors.push_back(curve.anchor);
                continue;
            }
            if (curve.role == CurveRole::wall) {
                parts += written_wall(curve.name);
                walls.push_back(curve.name);
            } else if (curve.role == CurveRole::end) {
                parts += written_left_out(curve.name, "an end of the period");
                ends.push_back(curve.name);
            } else {
                parts += written_left_out(curve.name, "no edge of the fluid, and no open curve in it");
                left_out.push_back(curve.name);
            }
        }
        for (const auto& [name, positions] : geometry_.points)
            if (std::ranges::find(anchors, name) == anchors.end())
                parts += written_left_out(name, "nothing is held there");
        assume("walls that do not move and that the fluid sticks to: " + (walls.empty() ? "none" : quoted_list(walls)));
        if (!ends.empty()) assume("ends of the period, no walls: " + quoted_list(ends));
        if (!left_out.empty())
            assume("left out, as they are no edge of the fluid and no open curve in it: " + quoted_list(left_out));
        return selections + parts;
    }

    /// Two rows of springs. A cantilever of length L under p on each length bends by p L^4 / (8 E I) at its end.
    std::string written_flexible(const CurveGuess& curve) {
        const double rho = liquid_->density, length = curve.longest, thick = thickness * spacing_;
        const double pressure = is_periodic() ? -gradient_ * guess_.box.extent()[axis_] : 10 * rho * speed_ * speed_;
        const double bending = pressure * std::pow(length, 3) / (8 * bend), axial = 12 * bending / (thick * thick);
        const std::size_t loose = curve.held_ends.size() - curve.anchored;
        std::string held = curve.anchor.empty() ? "free" : "clamped at '" + curve.anchor + "'";
        if (loose > 0) held += fmt::format(", free at {} more that meet the edge elsewhere", count_text(loose, "end"));
        assume(
            fmt::format("'{}' lies in the fluid: flexible, {}; it bends by {:g} % of its length under {:.2g} Pa, "
                        "E I = {:.2g} N m^2",
                        curve.name, held, 100 * bend, pressure, bending));
        return fmt::format(
                   "\n[[part]]\nname = \"{}\"\nkind = \"elastic\"\nbending_stiffness = \"{:.3g} N*m^2\"\n"
                   "axial_stiffness = \"{:.3g} N\"\nmass_per_length = \"{:.3g} kg/m\"\n",
                   curve.name, bending, axial, rho * thick) +
               (curve.anchor.empty() ? "" : fmt::format("anchor = \"{}\"\n", curve.anchor));
    }

    std::string written_flow() {
        const bool profile = guess_.is_a_straight_channel();
        std::string flow =
            fmt::format("\n[flow]\nlargest_speed = \"{:.4g} m/s\"\n", (profile ? faster : faster_past_bodies) * speed_);
        if (!is_periodic()) {
            assume("it is enclosed, at rest and not driven: its ends are not two flat sides that are alike");
            return flow + written_numerics();
        }
        std::vector<std::string> axes;
        if (guess_.periodic[0]) axes.emplace_back("x");
        if (guess_.periodic[1]) axes.emplace_back("y");
        std::array<std::string, 2> drive{"0", "0"}, start{"0", "0"};
        drive.at(static_cast<std::size_t>(axis_)) = fmt::format("\"{:.4g} Pa/m\"", gradient_);
        flow += fmt::format("periodic = [{}]\npressure_gradient = [{}, {}]\n", listed(axes), drive[0], drive[1]);
        for (const std::string& axis : axes)
            assume(fmt::format("what leaves along {} comes in again: its sides there are flat and alike", axis));
        assume(fmt::format("driven along {} by {:.3g} Pa/m, for about {:.3g} m/s, a Reynolds number of {:.2g}",
                           axis_name(), gradient_, speed_, reynolds()));
        if (profile) {
            const int aside = 1 - axis_;
            const auto from = [&](double position, const char* sign) {
                return fmt::format("({}{} {} {})", sign, "xy"[aside], (*sign == '-') == (position < 0) ? '-' : '+',
                                   in_millimetres(std::abs(position), size()));
            };
            start.at(static_cast<std::size_t>(axis_)) =
                fmt::format("\"{:.4g} m/s * 4 * {} * {} / ({})^2\"", speed_, from(guess_.box.low[aside], ""),
                            from(guess_.box.high[aside], "-"), in_millimetres(guess_.box.extent()[aside], 0));
            flow += fmt::format("initial_velocity = [{}, {}]\n", start[0], start[1]);
        }
        assume(profile ? "it starts from the parabolic profile between two plates" : "it starts at rest");
        return flow + written_numerics();
    }

    [[nodiscard]] std::string written_numerics() const {
        return reynolds() < 1 ? "\n[numerics]\nviscosity_stepping = \"implicit\"\n" : "";
    }

    const Geometry& geometry_;
    bool unit_given_;
    PlaneGuess guess_;
    const Liquid* liquid_;
    std::vector<std::string> assumptions_;
    int axis_ = 0;  ///< along which it is driven
    double spacing_ = 0, speed_ = 0, duration_ = 0;
    double gradient_ = 0;  ///< of the pressure that drives it [Pa/m]
};

}  // namespace

FirstScene first_scene_in_plane(const Geometry& geometry, bool unit_given) {
    if (geometry.regions.empty())
        throw InputError({geometry.file, 0, 0}, "the geometry has no area that could hold the fluid",
                         "Name one, as in Physical Surface(\"water\") = {1};, whose edges meet in the same points.");
    return AuthorInPlane(geometry, unit_given).write();
}

}  // namespace dmp::cli
