// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/mean_displacement.hpp"

#include <algorithm>

#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

MeanDisplacement::MeanDisplacement(const Scene& scene, const SpringBodies& springs) : from_(scene.output.average_from) {
    if (!scene.asks_for(SolidField::mean_displacement)) return;
    for (const auto& body : springs.bodies()) moment_.emplace_back(body->nodes());
}

void MeanDisplacement::add(const SpringBodies& springs, double time, double dt) {
    const double counted = std::min(dt, time + dt - from_);
    if (moment_.empty() || counted <= 0) return;
    duration_ += counted;
    for (std::size_t b = 0; b < moment_.size(); ++b)
        for (std::size_t node = 0; node < moment_[b].size(); ++node) {
            const Vec displacement = springs.bodies()[b]->displacement(node);
            for (int axis = 0; axis < 3; ++axis) moment_[b][node][axis] += counted * displacement[axis];
        }
}

Vec MeanDisplacement::of(const SpringBodies& springs, std::size_t body, std::size_t node) const {
    if (duration_ == 0) return springs.bodies()[body]->displacement(node);
    const auto& sum = moment_[body][node];
    return (1 / duration_) * Vec(sum[0], sum[1], sum[2]);
}

void MeanDisplacement::archive(Archive& file) {
    if (moment_.empty()) return;
    file("mean_displacement/duration", duration_);
    for (std::size_t body = 0; body < moment_.size(); ++body) {
        const std::size_t nodes = moment_[body].size();
        file("mean_displacement/body_" + std::to_string(body), moment_[body]);
        if (moment_[body].size() != nodes) throw unlike_any_run("mean displacements of more or fewer nodes");
    }
}

}  // namespace dmp::solver
