// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace dmp::solver {

/// Where a solve stands.
struct Residual {
    double weighted = 0;  ///< r . P^-1 r of the preconditioner P
    double error = 0;     ///< what is to become small; of the unit that the system measures it in
};

struct ConjugateGradientsEnd {
    long iterations = 0;
    double error = 0;
    bool converged = false;
};

/// Preconditioned conjugate gradients (Hestenes & Stiefel 1952; Saad 2003, algorithm 9.1) for a symmetric positive
/// definite A, which only `system` knows:
///     Residual start();              r = b - A x;  p = P^-1 r
///     double curvature();            p . A p
///     Residual step(double alpha);   x += alpha p;  r -= alpha A p
///     void turn(double beta);        p = P^-1 r + beta p
/// Ends when the residual's error is at most `target`, after `most` iterations, or where no progress can be made: the
/// curvature is not positive (rounding, or a number that is none).
template <class System>
ConjugateGradientsEnd conjugate_gradients(System& system, double target, long most) {
    Residual now = system.start();
    ConjugateGradientsEnd end{0, now.error, now.error <= target};
    while (!end.converged && end.iterations < most) {
        const double curvature = system.curvature();
        if (!(curvature > 0) || !(now.weighted > 0)) break;
        const Residual next = system.step(now.weighted / curvature);
        ++end.iterations;
        end.error = next.error;
        end.converged = next.error <= target;
        if (!end.converged) system.turn(next.weighted / now.weighted);
        now = next;
    }
    return end;
}

/// Iterations after which conjugate gradients should long have converged: the number for a matrix of condition kappa,
/// sqrt(kappa) / 2 ln(2 sqrt(kappa) / tolerance), twice, and some for small systems.
inline long patience(double kappa, double tolerance) {
    const double root = std::sqrt(std::min(kappa, 1e15));
    return 100 + static_cast<long>(root * std::log(2 * root / tolerance));
}

}  // namespace dmp::solver
