// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// SpringBodies: contact stiffness.
#include <algorithm>
#include <array>
#include <limits>

#include "models/contact/contact_stiffness.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

namespace {

template <int D>
using Point = std::array<double, D>;

/// PairPositions of a group, axis by axis.
template <int D>
struct PairPositions {
    std::array<const double*, D> axis;

    explicit PairPositions(const ParticleGroup& group) {
        for (int a = 0; a < D; ++a) axis[a] = group.data(Field::position, a);
    }
    [[nodiscard]] Point<D> operator[](std::int32_t i) const {
        Point<D> position;
        for (int a = 0; a < D; ++a) position[a] = axis[a][i];
        return position;
    }
};

template <int D>
struct Bounds {
    Point<D> low, high;

    Bounds(const PairPositions<D>& positions, const Cluster& cluster) : low(positions[cluster.first]), high(low) {
        for (std::int32_t i = cluster.first + 1; i < cluster.first + cluster.count; ++i)
            for (int a = 0; a < D; ++a) {
                low[a] = std::min(low[a], positions.axis[a][i]);
                high[a] = std::max(high[a], positions.axis[a][i]);
            }
    }
    [[nodiscard]] double distance_square(const Point<D>& position) const {
        double square = 0;
        for (int a = 0; a < D; ++a) {
            const double beyond = std::max({0.0, low[a] - position[a], position[a] - high[a]});
            square += beyond * beyond;
        }
        return square;
    }
};

template <int D>
double distance_square(const Point<D>& a, const Point<D>& b) {
    double square = 0;
    for (int axis = 0; axis < D; ++axis) square += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return square;
}

/// Calls visit(node, kind, other, squared distance, smaller range) for the pairs of a cluster that touch.
template <int D, class Visit>
void for_each_contact(const ParticleStore& particles, const ClusterList& list, std::size_t number, bool of_solids,
                      const Visit& visit) {
    const ParticleGroup& nodes = particles.of(PartKind::elastic);
    const Cluster& cluster = list.clusters(PartKind::elastic)[number];
    const PairPositions<D> position_of_node(nodes);
    const Bounds<D> bounds(position_of_node, cluster);
    for (const PartKind kind : all_kinds) {
        const auto near = list.neighbours(PartKind::elastic, number, kind);
        if (near.empty() || (kind != PartKind::fluid && !of_solids)) continue;
        const ParticleGroup& others = particles.of(kind);
        const Field field = kind == PartKind::rigid ? Field::wall_contact_range : Field::contact_range;
        const PairPositions<D> position_of(others);
        const double *range_of_node = nodes.data(field), *range_of = others.data(field);
        for (const std::int32_t other : near) {
            const Point<D> position = position_of[other];
            if (bounds.distance_square(position) >= range_of[other] * range_of[other]) continue;
            for (std::int32_t node = cluster.first; node < cluster.first + cluster.count; ++node) {
                const double square = distance_square<D>(position, position_of_node[node]);
                const double range = std::min(range_of_node[node], range_of[other]);
                if (square < range * range) visit(node, kind, other, square, range);
            }
        }
    }
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
    // Terms up to some 10^6 times as large as at first touch add up exactly.
    const ReproducibleSum rounding(1e6 * 12 * contact_.repulsion.strength / (contact_.range * contact_.range) *
                                   largest_inverse_mass);

    const double* mass_of_fluid = particles.fluid().data(Field::mass);
    const auto clusters = list.clusters(PartKind::elastic);
    const auto count = static_cast<std::ptrdiff_t>(clusters.size());
    double largest = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : largest)
    for (std::ptrdiff_t c = 0; c < count; ++c) {
        const auto number = static_cast<std::size_t>(c);
        std::array<double, cluster_size> rate{};
        const auto add = [&](std::int32_t node, PartKind kind, std::int32_t other, double square, double range) {
            const double of_other = kind == PartKind::rigid   ? 0
                                    : kind == PartKind::fluid ? 1 / mass_of_fluid[other]
                                                              : inverse_mass(nodes_[other]);
            rate[node - clusters[number].first] += rounding(contact_rate(
                contact_stiffness(contact_.repulsion, square, range), inverse_mass(nodes_[node]), of_other));
        };
        if (dimension_ == 3) {
            for_each_contact<3>(particles, list, number, contact_.of_solids, add);
        } else {
            for_each_contact<2>(particles, list, number, contact_.of_solids, add);
        }
        for (const double of_node : rate) largest = std::max(largest, of_node);
    }
    return ranks_.largest(largest) + of_themselves;
}

}  // namespace dmp::solver
