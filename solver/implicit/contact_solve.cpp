// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/implicit/contact_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dmp::solver {

namespace {

/// How far an unknown is from where it should be at the end of the step, at most [spacings].
constexpr double tolerance = 1e-6;
/// Newton's iterations.
constexpr int most_cycles = 40, cycles_at_large = 10;
/// A cycle that leaves more than this of the error calls for new matrices.
constexpr double slow = 0.3;
/// Iterations with one preconditioner.
constexpr long most_iterations = 20;

}  // namespace

ContactSolve::ContactSolve(SpringBodies& bodies, SurfaceContact& contact, const ParticleStore& particles, double dt)
    : bodies_(bodies), contact_(contact), dt_(dt), spacing_(particles.space().spacing) {
    const std::vector<Vec> on_particles = bodies.collected(particles, Field::force);
    std::size_t particle = 0;
    for (const auto& body : bodies.bodies()) {
        const auto own = std::span(on_particles).subspan(particle, body->nodes());
        std::ranges::copy(body->on_unknowns(own), std::back_inserter(other_force_));
        for (std::size_t n = 0; n < body->unknowns(); ++n) velocity_.push_back(body->unknown_velocity(n));
        particle += body->nodes();
    }
    residual_ = preconditioned_ = direction_ = image_ = std::vector<Vec>(velocity_.size(), Vec::Zero());
}

/// Calls visit(body, its first unknown, how many it has) for those that may touch.
template <class Visit>
void ContactSolve::for_each_body(const Visit& visit) const {
    std::size_t first = 0;
    for (std::size_t b = 0; b < bodies_.bodies().size(); ++b) {
        SpringBody& body = *bodies_.bodies()[b];
        if (contact_.touched_bodies()[b]) visit(body, first, body.unknowns());
        first += body.unknowns();
    }
}

bool ContactSolve::solve() {
    constexpr double of_cycle = 0.05;  // each cycle solves its linear equations to this part of the error
    const auto prepare = [this](bool anew) {
        for_each_body([&](SpringBody& body, std::size_t first, std::size_t count) {
            body.prepare_alone(std::span(velocity_).subspan(first, count), dt_, anew);
        });
    };
    prepare(false);
    bool is_slow = false;
    double error = find_residual();
    for (int cycle = 0; cycle < most_cycles && !(error <= tolerance); ++cycle) {
        if (is_slow) {
            prepare(true);
            if (held_.is_ready()) held_.factorise(bodies_, contact_);
            precondition();
        }
        const std::vector<Vec> start = velocity_, residual_at_start = residual_;
        if (!conjugate_gradients(*this, std::max(0.5 * tolerance, of_cycle * error), most_iterations).converged)
            held_.factorise(bodies_, contact_);
        // Whole steps may go round in circles.
        const double pushes_back = cycle < cycles_at_large ? 0.5 : 0.05;
        const double before = std::exchange(error, go_along(start, residual_at_start, pushes_back));
        is_slow = error > slow * before;
    }
    // The bodies' own steps are halved where they cannot be solved.
    return error <= tolerance;
}

/// From `start` towards the present w, as far as the residual does not push back by more than this share of its pull:
/// the equations are the gradient of an energy, all but friction and dashpots, and what touches on the way, or turns,
/// may make the whole way too far. It is so where a cell is crushed, or the pull grows. Returns the error.
double ContactSolve::go_along(const std::vector<Vec>& start, const std::vector<Vec>& residual_at_start,
                              double pushes_back) {
    constexpr double far_enough = 0.9, no_number = std::numeric_limits<double>::quiet_NaN();
    constexpr int most_trials = 12;
    std::vector<Vec> way = velocity_;
    for (std::size_t n = 0; n < way.size(); ++n) way[n] -= start[n];
    const auto pull_of = [&](const std::vector<Vec>& residual) {
        double sum = 0;
        for (std::size_t n = 0; n < way.size(); ++n) sum += residual[n].dot(way[n]);
        return sum;
    };
    struct Place {
        double part, pull;
    };
    Place near{0, pull_of(residual_at_start)}, far{1, 0};
    const double at_start = near.pull, too_much = pushes_back * at_start;
    double part = 1, error = find_residual();
    for (int trial = 0; trial < most_trials; ++trial) {
        double pull = std::isfinite(error) ? pull_of(residual_) : no_number;
        if (pull > 2 * at_start) pull = no_number;
        if (std::abs(pull) <= too_much || (pull > 0 && part >= far_enough)) return error;
        (pull > 0 ? near : far) = {part, pull};
        const double share = std::isfinite(far.pull) ? std::clamp(near.pull / (near.pull - far.pull), 0.1, 0.9) : 0.5;
        part = near.part + share * (far.part - near.part);
        for (std::size_t n = 0; n < way.size(); ++n) velocity_[n] = start[n] + part * way[n];
        error = find_residual();
    }
    if (!std::isfinite(error)) {
        velocity_ = start;
        error = find_residual();
    }
    return error;
}

double ContactSolve::find_residual() {
    for_each_body([&](SpringBody& body, std::size_t first, std::size_t count) {
        const std::vector<Vec> own = body.balance(std::span(velocity_).subspan(first, count), dt_);
        for (std::size_t n = 0; n < count; ++n) residual_[first + n] = own[n] + other_force_[first + n];
    });
    contact_.add_forces_at_end(velocity_, residual_);
    precondition();
    return residual().error;
}

void ContactSolve::precondition() {
    preconditioned_ = residual_;
    if (held_.is_ready()) {
        held_.solve(preconditioned_);
        return;
    }
    for_each_body([&](SpringBody& body, std::size_t first, std::size_t count) {
        body.solve_in_fluid(std::span(preconditioned_).subspan(first, count));
    });
}

Residual ContactSolve::residual() const {
    double weighted = 0, largest = 0;
    for (std::size_t n = 0; n < residual_.size(); ++n) {
        weighted += residual_[n].dot(preconditioned_[n]);
        if (!preconditioned_[n].allFinite()) return {weighted, std::numeric_limits<double>::quiet_NaN()};
        largest = std::max(largest, preconditioned_[n].cwiseAbs().maxCoeff());
    }
    return {weighted, dt_ * largest / spacing_};
}

Residual ContactSolve::start() {
    turn(0);
    return residual();
}

double ContactSolve::curvature() {
    image_ = direction_;
    for_each_body([&](SpringBody& body, std::size_t first, std::size_t count) {
        body.multiply_in_fluid(std::span(image_).subspan(first, count));
    });
    contact_.add_stiffness_times(direction_, image_);
    double product = 0;
    for (std::size_t n = 0; n < direction_.size(); ++n) product += direction_[n].dot(image_[n]);
    return product;
}

Residual ContactSolve::step(double alpha) {
    for (std::size_t n = 0; n < velocity_.size(); ++n) {
        velocity_[n] += alpha * direction_[n];
        residual_[n] -= alpha * image_[n];
    }
    precondition();
    return residual();
}

void ContactSolve::turn(double beta) {
    for (std::size_t n = 0; n < direction_.size(); ++n)
        direction_[n] = beta == 0 ? preconditioned_[n] : Vec(preconditioned_[n] + beta * direction_[n]);
}

}  // namespace dmp::solver
