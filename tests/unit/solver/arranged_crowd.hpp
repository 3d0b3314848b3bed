// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "all_pairs.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// What the sweeps leave, by particle id; 0 where there is no such field.
struct Sums {
    explicit Sums(std::size_t count) : force(count, Vec::Zero()), shift(count, Vec::Zero()), density_rate(count, 0.0) {}
    std::vector<Vec> force, shift;
    std::vector<double> density_rate;
};

/// What results do not depend on.
struct Arrangement {
    VectorUnit vector_unit = VectorUnit::widest;
    int threads = 1;
    double extra_reach = 0;       ///< that the lists look farther than they must [m]
    bool near_only = false;       ///< the lists are looked through for what is near before the sweeps
    bool border_apart = false;    ///< clusters near copies are swept after all others
    unsigned shuffled = 0;        ///< seed for the order of the particles before they are sorted; 0: as meshed
    bool wrapped = false;         ///< a third of the particles stands a period away along each periodic axis
    Vec displaced = Vec::Zero();  ///< all particles by this; along periodic axes only [m]
};

/// Pair terms as a scene may set them, for a crowd.
inline PairSettings crowd_settings(const ParticleSet& set, bool with_extras,
                                   WallModel walls = WallModel::extrapolated) {
    PairSettings settings;
    settings.walls.model = walls;
    settings.spacing = set.spacing;
    settings.support = 3 * set.spacing;
    settings.sound_speed = 20;
    settings.density.largest = 1000;
    settings.viscosity.largest = 0.7;
    if (with_extras) {
        settings.density.diffusion = 0.1;
        settings.shifting = 4;
        settings.repulsion_strength = 1e-4;
    }
    return settings;
}

/// A crowd in an arrangement, each particle in a random state that its id decides, ready for the sweeps.
class ArrangedCrowd {
  public:
    static constexpr std::array<double, 3> body_acceleration{0.7, -2.5, 0.4};

    ArrangedCrowd(const ParticleSet& set, PairSettings settings, const Arrangement& arrangement)
        : particles_(set, std::vector<double>(set.parts.size(), settings.density.largest)),
          neighbours_(ranks_, particles_.space(), settings.support + arrangement.extra_reach, arrangement.threads),
          border_apart_(arrangement.border_apart),
          with_correction_(settings.gradient_correction) {
        settings.vector_unit = arrangement.vector_unit;
        settings.threads = arrangement.threads;
        sweeps_ = make_pair_sweeps(settings, particles_);
        if (arrangement.shuffled != 0) shuffle(arrangement.shuffled);
        move(arrangement);
        fill(set);
        neighbours_.renew(particles_);
        fill(set);  // once more: what is no state is not kept
        FieldList all(static_cast<std::size_t>(Field::count));
        for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<Field>(f);
        neighbours_.exchange(particles_, all);
        if (arrangement.near_only)
            neighbours_.prune_list(
                particles_, [this](ClusterList& list, double reach) { sweeps_->prune(particles_, list, reach); });
    }

    [[nodiscard]] Sums sweep() {
        using enum ClusterChoice;
        for (const ClusterChoice clusters : border_apart_ ? std::vector{inner, border} : std::vector{all}) {
            if (with_correction_) correct(clusters);
            sweeps_->forces(particles_, neighbours_.list(), {body_acceleration}, clusters);
            sweeps_->density_rates(particles_, neighbours_.list(), body_acceleration, clusters);
        }
        const ById by_id(particles_);
        Sums sums(by_id.size());
        for (std::size_t id = 0; id < by_id.size(); ++id) {
            const ParticleGroup& group = by_id.group(id);
            sums.force[id] = by_id.vector(Field::force, id);
            if (group.has(Field::shift)) sums.shift[id] = by_id.vector(Field::shift, id);
            if (group.has(Field::density_rate)) sums.density_rate[id] = by_id.value(Field::density_rate, id);
        }
        return sums;
    }

    /// Densities as sums over neighbours, by particle id; 0 of solids.
    [[nodiscard]] std::vector<double> densities(const std::vector<double>& rest_density) {
        using enum ClusterChoice;
        for (const ClusterChoice clusters : border_apart_ ? std::vector{inner, border} : std::vector{all})
            sweeps_->densities(particles_, neighbours_.list(), rest_density, clusters);
        const ById by_id(particles_);
        std::vector<double> found(by_id.size());
        for (std::size_t id = 0; id < by_id.size(); ++id)
            if (by_id.group(id).kind() == PartKind::fluid) found[id] = by_id.value(Field::density, id);
        return found;
    }

    ParticleStore& particles() { return particles_; }
    [[nodiscard]] const PairSweeps& sweeps() const { return *sweeps_; }
    [[nodiscard]] const ClusterList& list() const { return neighbours_.list(); }
    /// Gives copies the present values.
    void exchange(const FieldList& fields) { neighbours_.exchange(particles_, fields); }

  private:
    /// Before the first clusters' forces: of all, as forces need their neighbours' too.
    void correct(ClusterChoice clusters) {
        if (clusters == ClusterChoice::border) return;
        for (const ClusterChoice part : {ClusterChoice::border, ClusterChoice::inner})
            sweeps_->corrections(particles_, neighbours_.list(), part);
        neighbours_.exchange(particles_, {Field::correction, Field::correction_off_diagonal});
    }

    void shuffle(unsigned seed) {
        std::mt19937 random(seed);
        for (ParticleGroup& group : particles_.groups()) {
            std::vector<std::int32_t> order(group.owned());
            std::iota(order.begin(), order.end(), 0);
            std::shuffle(order.begin(), order.end(), random);
            group.reorder(order);
        }
    }

    void move(const Arrangement& arrangement) {
        const ParticleSpace& space = particles_.space();
        const ById by_id(particles_);
        for (std::size_t id = 0; id < by_id.size(); ++id)
            for (int axis = 0; axis < space.dimension; ++axis) {
                double& x = by_id.value(Field::position, id, axis);
                x += particles_.quantum().round(arrangement.displaced[axis]);
                if (arrangement.wrapped && space.periodic[axis] && id % 3 == 0)
                    x += (id % 2 == 0 ? 1 : -1) * space.box.extent()[axis];
            }
    }

    void fill(const ParticleSet& set) {
        const ById by_id(particles_);
        std::mt19937 random(11);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (std::size_t id = 0; id < by_id.size(); ++id) {
            const auto put = [&](Field field, double value, int axis = 0) {
                if (by_id.group(id).has(field)) by_id.value(field, id, axis) = value;
            };
            for (int axis = 0; axis < set.dimension; ++axis) {
                put(Field::velocity, unit(random), axis);
                put(Field::wall_normal, set.wall_normal[id][axis], axis);
                put(Field::transport_velocity, 0.1 * unit(random), axis);
            }
            put(Field::density, 1000 + 10 * unit(random));
            put(Field::pressure, 3000 * (unit(random) + 0.5));
            put(Field::viscosity, 0.5 + 0.2 * unit(random));
            put(Field::contact_range, set.spacing);
            put(Field::wall_contact_range, id % 3 == 0 ? 0 : set.spacing);
            put(Field::wall_distance, set.wall_distance[id]);
            if (!by_id.group(id).has(Field::velocity_gradient)) continue;
            put(Field::reduced_pressure, 3000 * unit(random));
            put(Field::mean_correction, 1 + 0.1 * unit(random));
            for (int k = 0; k < set.dimension * set.dimension; ++k) put(Field::velocity_gradient, unit(random), k);
        }
    }

    Ranks ranks_ = Ranks::alone();
    ParticleStore particles_;
    Neighbours neighbours_;
    std::unique_ptr<PairSweeps> sweeps_;
    bool border_apart_ = false, with_correction_ = false;
};

}  // namespace dmp::tests
