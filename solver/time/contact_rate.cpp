// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpringBodies: how stiff their contacts are.
#include <algorithm>
#include <array>
#include <limits>

#include "solver/models/contact/contact_stiffness.hpp"
#include "solver/sweeps/order_free.hpp"
#include "solver/time/spring_bodies.hpp"

namespace dmp {

namespace {

using Point = std::array<double, 3>;

Point place_of(const ParticleGroup& group, std::size_t i) {
    Point place{};
    for (int axis = 0; axis < group.dimension(); ++axis) place[axis] = group.data(Field::position, axis)[i];
    return place;
}

struct Bounds {
    Point low, high;

    Bounds(const ParticleGroup& group, const Cluster& cluster)
        : low(place_of(group, static_cast<std::size_t>(cluster.first))), high(low) {
        for (std::int32_t i = cluster.first + 1; i < cluster.first + cluster.count; ++i) {
            const Point place = place_of(group, static_cast<std::size_t>(i));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], place[axis]);
                high[axis] = std::max(high[axis], place[axis]);
            }
        }
    }
    [[nodiscard]] bool within(const Point& place, double reach) const {
        double square = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double beyond = std::max({0.0, low[axis] - place[axis], place[axis] - high[axis]});
            square += beyond * beyond;
        }
        return square < reach * reach;
    }
};

double distance_square(const Point& a, const Point& b) {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) square += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return square;
}

}  // namespace

double SpringBodies::inverse_mass(const Node& node) const {
    const SpringBody& body = *bodies_[node.body];
    const auto index = static_cast<std::size_t>(node.index);
    return body.fixed(index) ? 0 : 1 / body.mass(index);
}

double SpringBodies::largest_contact_rate(const ParticleStore& particles, const ClusterList& list, int threads) const {
    if (!contact_.on() || empty()) return 0;
    double largest_inverse_mass = 0, of_themselves = 0;
    for (const auto& body : bodies_) {
        of_themselves = std::max(of_themselves, body->self_contact_rate());
        for (std::size_t n = 0; n < body->nodes(); ++n)
            if (!body->fixed(n)) largest_inverse_mass = std::max(largest_inverse_mass, 1 / body->mass(n));
    }
    if (largest_inverse_mass == 0) return 0;
    // Terms of up to some 10^6 times those at touch add up exactly.
    const OrderFree order_free(1e6 * 12 * contact_.repulsion.strength / (contact_.range * contact_.range) *
                               largest_inverse_mass);

    const ParticleGroup& nodes = particles.of(ParticleKind::springs);
    const auto clusters = list.clusters(ParticleKind::springs);
    const auto count = static_cast<std::ptrdiff_t>(clusters.size());
    double largest = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : largest)
    for (std::ptrdiff_t c = 0; c < count; ++c) {
        const Cluster& cluster = clusters[static_cast<std::size_t>(c)];
        const Bounds bounds(nodes, cluster);
        std::array<double, cluster_size> rate{};
        for (const ParticleKind kind : all_kinds) {
            const ParticleGroup& others = particles.of(kind);
            const Field field = kind == ParticleKind::rigid ? Field::wall_contact_range : Field::contact_range;
            for (const std::int32_t j : list.neighbours(ParticleKind::springs, static_cast<std::size_t>(c), kind)) {
                const auto other = static_cast<std::size_t>(j);
                const double range_of_other = others.data(field)[other];
                const Point place = place_of(others, other);
                if (!bounds.within(place, range_of_other)) continue;
                const double inverse_mass_of_other = kind == ParticleKind::rigid   ? 0
                                                     : kind == ParticleKind::fluid ? 1 / others.data(Field::mass)[other]
                                                                                   : inverse_mass(nodes_[other]);
                for (std::int32_t k = 0; k < cluster.count; ++k) {
                    const auto node = static_cast<std::size_t>(cluster.first + k);
                    const double stiffness =
                        contact_stiffness(contact_.repulsion, distance_square(place, place_of(nodes, node)),
                                          std::min(nodes.data(field)[node], range_of_other));
                    if (stiffness > 0)
                        rate[static_cast<std::size_t>(k)] +=
                            order_free(contact_rate(stiffness, inverse_mass(nodes_[node]), inverse_mass_of_other));
                }
            }
        }
        for (const double of_node : rate) largest = std::max(largest, of_node);
    }
    return ranks_.largest(largest) + of_themselves;
}

}  // namespace dmp
