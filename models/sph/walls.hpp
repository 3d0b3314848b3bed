// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "base/simd/lanes.hpp"
#include "models/pair.hpp"

namespace dmp::models {

/// Solid particles as neighbours of a fluid particle: each is replaced by a fluid particle at its position, to which
/// the ordinary pair laws apply.

/// A particle of the same fluid at the solid particle's position, with the solid's velocity and volume and the fluid
/// particle's own state.
template <int D, class F, class S>
auto image_fluid_of(const S& solid, const F& fluid) {
    using T = Wider<decltype(fluid.density), decltype(solid.volume)>;
    FluidPoint<T, D> liquid;
    for (int a = 0; a < D; ++a) {
        liquid.position[a] = solid.position[a];
        liquid.velocity[a] = solid.velocity[a];
    }
    liquid.volume = solid.volume;
    liquid.density = fluid.density;
    liquid.pressure = fluid.pressure;
    liquid.viscosity = fluid.viscosity;
    liquid.correction = fluid.correction;
    for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) liquid.gradient[a][b] = fluid.gradient[a][b];
    return liquid;
}

/// Walls with velocity and pressure extrapolated into them, pair by pair; no-slip by default.
///
/// Rigid walls: the velocity is extrapolated linearly from the fluid particle's through the wall's at its surface
/// (Morris, Fox & Zhu 1997), v_j = v_w - (d_j / d_i)(v_i - v_w), where d are the distances to the surface. Nearer than
/// half a spacing this would be too stiff; there d_i is half a spacing, and v_i the velocity at that distance by the
/// fluid particle's velocity gradient, v_i + G_i n (dx / 2 - d_i); 0 for viscous laws that do not read G. The
/// pressure continues hydrostatically (Adami, Hu & Adams 2012, for one pair), p_j = p_i + rho_i g . (x_j - x_i).
///
/// Elastic bodies: the same extrapolation, v_j = v_b - (d_j / d_i)(v_i - v_b - L_j x_ij), with the body's velocity v_b
/// and its gradient L_j at the particle (v_b + L_j x of it is the surface's velocity where the line between both meets
/// it; fluid that turns with the body feels nothing). Bodies are thin and have fluid on both sides: d are the distances
/// to the surface that the fluid particle is in front of, that with the particle's normal or the one opposite to it.
/// Fluid that is in front of neither is beside an edge, or beside a surface that bends away; it sees a particle that is
/// half a spacing behind the surface at most, itself half a spacing off. Particles without a normal are round. Where a
/// body is thinner than its two rows of particles, its particles are in front of its surface: d_j < 0. Into bodies that
/// are clamped the pressure continues as into walls, in full from half a spacing behind the surface on; in front of it,
/// and in bodies that are free to move with the liquid, it is the fluid particle's. In the density rate the body's own
/// velocity counts.
///
/// `WithMotion`: walls may move, and may let the fluid slip. For a wall particle with acceleration a_j the pressure
/// continues with rho_i (g - a_j) . (x_j - x_i) (Adami, Hu & Adams 2012). Where the fluid slips, only the normal part
/// of v_i - v_w is extrapolated, and the tangential part is the fluid's own: no shear stress, v_j = v_i - (1 + d_j /
/// d_i) n n . (v_i - v_w). There, g excludes its component along both the wall and a periodic axis: no pressure can
/// balance it, it drives the fluid. v_w is that of the surface in front of the wall particle; in front of the fluid
/// particle, a way s along the surface from there, it is v_w + S s with the gradient S of the surface's velocity, where
/// the scheme gives one (a wall that turns: S s is the spin times s).
template <int D, bool WithMotion = false>
struct ExtrapolatedSolid {
    static constexpr bool needs_surface = true, needs_state = false, needs_motion = WithMotion;
    /// In the density rate the wall's image approaches as fast as the fluid does (v_j = 2 v_w - v_i along the pair),
    /// so the relative velocity counts twice. This matches the pressure, which also acts twice (p_j = p_i): the work
    /// of the forces then equals the energy stored by the density.
    static constexpr double approach_weight = 2;

    Vector<double, D> acceleration;  ///< current body acceleration g of the fluid [m/s^2]
    double nearest;                  ///< smallest distance to the surface used for a fluid particle: dx/2 [m]
    Vector<double, D> driven{};      ///< the part of g along periodic axes; needed with slip [m/s^2]
    Vector<double, D> subtracted{};  ///< slope of the reference that the fluid's pressures are less of [Pa/m]

    template <class F, class S, class Separation>
    [[nodiscard]] auto rigid(const F& fluid, const S& wall, const Separation& from_wall) const {
        auto liquid = image_fluid_of<D>(wall, fluid);
        using T = decltype(liquid.density);
        const T above = dot(from_wall, wall.normal);
        const T actual = max_of(T(above - wall.depth), T(0.0));
        const T distance = max_of(actual, T(nearest));
        const T ratio = wall.depth / distance;
        // How the fluid moves past the surface in front of it, and what more it does at `distance`.
        Vector<T, D> past_surface, farther;
        for (int a = 0; a < D; ++a) {
            past_surface[a] = fluid.velocity[a] - wall.velocity[a];
            farther[a] = (distance - actual) * dot(fluid.gradient[a], wall.normal);
        }
        if constexpr (WithMotion) {
            const auto past_wall = fluid.velocity - wall.velocity;
            const auto beside = from_wall - above * wall.normal;
            for (int a = 0; a < D; ++a) past_surface[a] = past_surface[a] - dot(wall.surface_gradient[a], beside);
            const auto along = [&wall](const auto& v) { return v - dot(v, wall.normal) * wall.normal; };
            liquid.velocity += wall.slip * (along(past_wall) + ratio * along(past_surface));
            farther -= wall.slip * along(farther);
            const T unheld = dot(driven, from_wall) - dot(driven, wall.normal) * dot(from_wall, wall.normal);
            liquid.pressure = liquid.pressure - fluid.density * (dot(acceleration, from_wall) - wall.slip * unheld -
                                                                 dot(wall.acceleration, from_wall));
        } else {
            liquid.pressure = liquid.pressure - fluid.density * dot(acceleration, from_wall);
        }
        for (int a = 0; a < D; ++a) {
            liquid.velocity[a] = liquid.velocity[a] - ratio * past_surface[a];
            liquid.velocity_by_gradient[a] = -1.0 * (ratio * farther[a]);
        }
        liquid.pressure = liquid.pressure + dot(subtracted, from_wall);
        return liquid;
    }

    template <class F, class S, class Separation>
    [[nodiscard]] auto springs(const F& fluid, const S& body, const Separation& from_body) const {
        auto liquid = image_fluid_of<D>(body, fluid);
        using T = decltype(liquid.density);
        const T has_normal = where_less(T(dot(body.normal, body.normal)), T(0.5), T(0.0), T(1.0));
        const T along = dot(from_body, body.normal);
        const T height = has_normal * along + (1.0 - has_normal) * sqrt(T(dot(from_body, from_body)));
        const T before = height - body.depth, behind = -1.0 * height - body.opposite;
        const auto by_side = [&](const T& in_front, const T& opposite, const T& beside) {
            return where_less(T(0.0), before, in_front, where_less(T(0.0), behind, opposite, beside));
        };
        const T depth = by_side(body.depth, body.opposite, min_of(max_of(T(body.depth), T(0.0)), T(nearest)));
        const T actual = by_side(before, behind, T(nearest));
        const T distance = max_of(actual, T(nearest));
        const T ratio = depth / distance;
        // How much farther than the fluid particle `distance` is from the surface.
        const T farther = has_normal * by_side(1.0, -1.0, 0.0) * (distance - actual);
        for (int a = 0; a < D; ++a) {
            liquid.velocity[a] = body.velocity[a] - ratio * (fluid.velocity[a] - body.velocity[a]);
            liquid.velocity_by_gradient[a] =
                ratio * (dot(body.surface_gradient[a], from_body) - farther * dot(fluid.gradient[a], body.normal));
        }
        const T as_wall = body.held * max_of(T(0.0), min_of(T((1 / nearest) * depth), T(1.0)));
        liquid.pressure =
            liquid.pressure - as_wall * (fluid.density * dot(acceleration, from_body) - dot(subtracted, from_body));
        return liquid;
    }

    /// The state used in the density rate: the wall particle with its own motion v_w, also where its surface slides
    /// along itself. Where the fluid slips, the wall particles move with the fluid, v_w + (v_i - v_w) - n n . (v_i -
    /// v_w). Otherwise sliding past them would act like a rough surface.
    template <class F, class S>
    [[nodiscard]] static auto approached(const F& fluid, const S& wall) {
        using T = Wider<decltype(fluid.density), decltype(wall.volume)>;
        struct {
            Vector<T, D> position, velocity;
            T volume;
        } seen;
        const auto past_wall = fluid.velocity - wall.motion;
        const T towards_fluid = dot(past_wall, wall.normal);
        for (int a = 0; a < D; ++a) {
            seen.position[a] = wall.position[a];
            seen.velocity[a] = wall.motion[a] + wall.slip * (past_wall[a] - towards_fluid * wall.normal[a]);
        }
        seen.volume = wall.volume;
        return seen;
    }

  private:
    template <class T>
    static T max_of(const T& a, const T& b) {
        using std::max;
        return max(a, b);
    }
    template <class T>
    static T min_of(const T& a, const T& b) {
        using std::min;
        return min(a, b);
    }
};

/// The plain fixed particles of Monaghan (1994): solids have a density of their own, integrated like the fluid's. A
/// slip velocity remains at the wall (the no-slip plane lies near the first row of wall particles).
template <int D>
struct PlainSolid {
    static constexpr bool needs_surface = false, needs_state = true, needs_motion = false;
    static constexpr double approach_weight = 1;  ///< the solid's own density accounts for the other half

    template <class F, class S, class Separation>
    [[nodiscard]] auto rigid(const F& fluid, const S& solid, const Separation& /*from_solid*/) const {
        auto liquid = image_fluid_of<D>(solid, fluid);
        liquid.density = solid.density;
        liquid.pressure = solid.pressure;
        return liquid;
    }
    template <class F, class S, class Separation>
    [[nodiscard]] auto springs(const F& fluid, const S& body, const Separation& from_body) const {
        return rigid(fluid, body, from_body);
    }
};

}  // namespace dmp::models
