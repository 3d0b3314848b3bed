// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/implicit/implicit_viscosity.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "solver/implicit/viscous_system.hpp"

namespace dmp::solver {

namespace {

/// A solve begins again from its true residual, as springs are not linear and residuals drift, at most this often; and
/// after the first few times, in which it becomes known what touches, only while that halves the error.
constexpr int most_cycles = 30, cycles_to_settle = 3, cycles_to_touch = 12;

}  // namespace

ImplicitViscosity::ImplicitViscosity(const PairSweeps& sweeps, const Ranks& ranks, double tolerance, int threads)
    : sweeps_(sweeps), ranks_(ranks), tolerance_(tolerance), threads_(threads) {}

void ImplicitViscosity::add_forces(ParticleStore& particles, const ClusterList& list, SpringBodies& springs,
                                   SurfaceContact* contact, double dt, const std::array<double, 3>& g,
                                   const Sweep& sweep) {
    ViscousSystem system({particles, list, springs, contact, sweeps_, ranks_, sweep, threads_}, dt, g);
    const long most = patience(system.condition(), tolerance_);
    long iterations = 0;
    double error = 0;
    for (int cycle = 0;; ++cycle) {
        const double before = error;
        error = system.true_error();
        const double scale = system.velocity_scale();
        if (error <= tolerance_ * scale) break;
        const bool stuck = cycle > (contact != nullptr ? cycles_to_touch : cycles_to_settle) &&
                           error > (contact != nullptr ? 0.9 : 0.5) * before;
        if (stuck || cycle == most_cycles || !std::isfinite(error))
            give_up(error / scale, iterations, contact != nullptr);
        // From rest there is no scale yet.
        const double target = scale > 0 ? 0.5 * tolerance_ * scale : 0.01 * error;
        iterations += conjugate_gradients(system, target, most).iterations;
    }
    system.add_forces();
    ++solves_.solves;
    solves_.iterations += iterations;
    solves_.most_iterations = std::max<std::int64_t>(solves_.most_iterations, iterations);
}

void ImplicitViscosity::give_up(double error, long iterations, bool may_touch) const {
    std::ostringstream problem;
    problem << "implicit viscosity: the velocities' error is still " << error << " of them after " << iterations
            << " iterations, more than numerics.viscosity_tolerance = " << tolerance_
            << (may_touch ? "; elastic solids touch in this step" : "");
    throw UnsolvedViscosity(problem.str(),
                            "lower the viscosity or numerics.step_factor: rounding alone leaves about 1e-15 times the "
                            "step over the explicit limit; where that is below 0.01, a higher "
                            "numerics.viscosity_tolerance will do, too");
}

void ImplicitViscosity::archive(Archive& file) {
    file("viscosity/solves", solves_.solves);
    file("viscosity/iterations", solves_.iterations);
    file("viscosity/most_iterations", solves_.most_iterations);
}

}  // namespace dmp::solver
