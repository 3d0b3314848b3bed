// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/contact/surface_contact.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/implicit/contact_preconditioner.hpp"
#include "solver/parallel/exact_sum.hpp"

namespace dmp::solver {

/// The elastic bodies' part of the equations of implicit viscosity. A node's unknown is its mean velocity w over the
/// step to come, from which follows what the fluid sees of the body's particles; the springs, which will act during
/// that step, are in its balance:
///     m / dt (w - v) - F_springs(x + dt/2 w, w) / 2 = F_others + F_viscous(w)
/// as in the body's own implicit midpoint step, whose solution w is. Without them a light body in a thick liquid would
/// first be stopped by it, and then spring as if nothing held it. Where bodies may touch, half of the forces of contact
/// at the end of the step are in the balance, too. Every rank holds all nodes. The preconditioner solves each body's
/// own equations, its diagonal drag in the liquid included, so that stiff springs cost no iterations, and those of
/// bodies that may touch with what is between them (ContactPreconditioner).
class ViscousNodes {
  public:
    /// From the present velocities of nodes, and the other forces on them. `contact`: null where nothing may touch.
    ViscousNodes(SpringBodies& springs, SurfaceContact* contact, const ParticleStore& particles, double dt);

    /// Takes the drag in the liquid from viscous_diagonal.
    void prepare(const ParticleStore& particles);
    /// Hands w, or the direction of search, to the store.
    void show_velocity(ParticleStore& particles) const { show(particles, Field::viscous_velocity, velocity_); }
    void show_direction(ParticleStore& particles) const { show(particles, Field::viscous_direction, direction_); }
    [[nodiscard]] double fastest() const { return largest(velocity_); }
    [[nodiscard]] double fastest_direction() const { return largest(direction_); }

    /// Takes the viscous forces of w from the store.
    void find_residual(const ParticleStore& particles);
    /// Takes those of the direction of search.
    void find_image(const ParticleStore& particles);
    void step(double alpha);
    void turn(double beta);
    /// Tells the bodies what they will do.
    void hand_over() const;

    /// Terms of the sums over all particles; called on every rank after those of the fluid were added up over ranks.
    void add_squares(ExactSum& sum) const;    ///< m w^2
    void add_errors(ExactSum& sum) const;     ///< (dt r)^2 / m
    void add_residual(ExactSum& sum) const;   ///< r . P^-1 r
    void add_curvature(ExactSum& sum) const;  ///< p . A p

  private:
    using Vectors = std::vector<Vec>;
    void show(ParticleStore& particles, Field field, const Vectors& values) const;
    static double largest(const Vectors& values);
    /// Calls visit(body, its part of all unknowns, its part of all particles of bodies).
    struct Part {
        std::size_t first, count;
        template <class Values>
        [[nodiscard]] auto of(Values& values) const {
            return std::span(values).subspan(first, count);
        }
    };
    template <class Visit>
    void for_each_body(const Visit& visit) const;
    void precondition();
    /// A field of the bodies' particles, as forces on the unknowns.
    [[nodiscard]] Vectors on_unknowns(const ParticleStore& particles, Field field) const;

    SpringBodies& springs_;
    SurfaceContact* contact_;
    ContactPreconditioner held_;
    double dt_;
    Vectors other_force_, velocity_, residual_, preconditioned_, direction_, image_;
};

}  // namespace dmp::solver
