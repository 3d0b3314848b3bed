// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/contact/surface_contact.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/implicit/conjugate_gradients.hpp"
#include "solver/implicit/contact_preconditioner.hpp"

namespace dmp::solver {

/// The implicit contact of one step: the mean velocities w of bodies' unknowns that are in balance with the forces of
/// contact at the end of the step,
///     m / dt (w - v) - F_body(x + dt/2 w, w) / 2 = F_others + F_contact(x + dt w) / 2   [N]
/// By Newton's method with conjugate gradients, preconditioned with the factors of the bodies' own implicit steps, or
/// where that takes long with those of the bodies as contact holds them (ContactPreconditioner). Only the forces of
/// contact are taken from it: whatever the tolerance, they are opposite, and bodies take their own step under them.
/// Every rank holds all bodies and does the same. (ViscousSystem has contact among its equations.)
class ContactSolve {
  public:
    /// Of bodies that may touch in this step, under the forces that the store has. All ranks must call it.
    ContactSolve(SpringBodies& bodies, SurfaceContact& contact, const ParticleStore& particles, double dt);

    /// Leaves the forces of contact with `contact`. False if they are not those of a balance: of the last w.
    bool solve();

    Residual start();
    double curvature();
    Residual step(double alpha);
    void turn(double beta);

  private:
    template <class Visit>
    void for_each_body(const Visit& visit) const;
    double find_residual();
    double go_along(const std::vector<Vec>& start, const std::vector<Vec>& residual_at_start, double pushes_back);
    void precondition();
    [[nodiscard]] Residual residual() const;

    SpringBodies& bodies_;
    SurfaceContact& contact_;
    ContactPreconditioner held_;
    double dt_, spacing_;
    std::vector<Vec> other_force_, velocity_, residual_, preconditioned_, direction_, image_;  ///< by unknown
};

}  // namespace dmp::solver
