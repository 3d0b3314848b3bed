// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The law of diffusion on two particles by hand, and its sweep against a plain loop over all pairs.
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "all_pairs.hpp"
#include "models/sph/kernels.hpp"
#include "models/transport/species_diffusion.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_species_sweep_tests {
namespace {

using Point = SpeciesPoint<double, 2>;
using WallPoint = SpeciesWallPoint<double, 2>;

constexpr SpeciesDiffusion diffusion{0.05};
constexpr Point particle_i{{{0.4, 0.3}}, 1.1, 5, 2}, particle_j{{{0.1, 0.7}}, 0.9, 3, 6};

TEST(SpeciesDiffusion, between_two_particles_by_hand) {
    // 1.1 * 0.9 * 4 * 2 * 6 / (2 + 6) * (5 - 3)
    EXPECT_DOUBLE_EQ(diffusion.law(particle_i, particle_j), 0.99 * 6 * 2);
    EXPECT_EQ(diffusion.law(particle_j, particle_i), -diffusion.law(particle_i, particle_j));
    EXPECT_DOUBLE_EQ(diffusion.conductance(particle_i, particle_j), 0.99 * 6);
    Point even = particle_j;
    even.concentration = particle_i.concentration;
    EXPECT_EQ(diffusion.law(particle_i, even), 0);
    Point closed = particle_j;
    closed.diffusivity = 0;
    EXPECT_EQ(diffusion.law(particle_i, closed), 0);
    closed.diffusivity = particle_i.diffusivity;
    EXPECT_DOUBLE_EQ(diffusion.law(particle_i, closed), 0.99 * 2 * 2 * 2) << "the sum of both where they are alike";
}

TEST(SpeciesDiffusion, at_a_held_surface_by_hand) {
    // A wall below y = 0; the particle 0.3 in front of it, the wall's 0.2 behind.
    const WallPoint wall{{{{0.1, -0.2}}, 0.9, 3, 0}, {{0, 1}}, 0.2, 1, 0};
    EXPECT_DOUBLE_EQ(diffusion.law(particle_i, wall), 0.99 * 2 * 2 * (1 + 0.2 / 0.3) * (5 - 3));
    EXPECT_EQ(diffusion.law(wall, particle_i), -diffusion.law(particle_i, wall));
    Point touching = particle_i;
    touching.position[1] = 0.01;
    EXPECT_DOUBLE_EQ(diffusion.conductance(touching, wall), 0.99 * 2 * 2 * (1 + 0.2 / 0.05)) << "no nearer than dx/2";
}

TEST(SpeciesDiffusion, at_a_held_body_by_hand) {
    // As to a body that conducts infinitely well; between two that are held nothing goes.
    const SpeciesBodyPoint<double, 2> body{{{{0.1, 0.7}}, 0.9, 3, 0}, 1};
    EXPECT_DOUBLE_EQ(diffusion.law(particle_i, body), 0.99 * 4 * 2 * (5 - 3));
    EXPECT_EQ(diffusion.law(body, particle_i), -diffusion.law(particle_i, body));
    SpeciesBodyPoint<double, 2> other = body;
    other.concentration = 7;
    EXPECT_EQ(diffusion.law(body, other), 0);
    Point infinite = particle_j;
    infinite.diffusivity = 1e20;
    EXPECT_DOUBLE_EQ(diffusion.conductance(particle_i, body), diffusion.conductance(particle_i, infinite));
    other.held = 0;
    EXPECT_EQ(diffusion.law(particle_i, other), 0) << "closed";
}

TEST(SpeciesDiffusion, of_a_surface_that_gives_by_hand) {
    const WallPoint wall{{{{0.1, -0.2}}, 0.9, 7, 0}, {{0, 1}}, 0.2, 0, 1};
    EXPECT_DOUBLE_EQ(diffusion.law(particle_i, wall), -2 * 0.99 * 7 * 0.5);
    EXPECT_EQ(diffusion.law(wall, particle_i), -diffusion.law(particle_i, wall));
    EXPECT_EQ(diffusion.conductance(particle_i, wall), 0);
}

/// Dimension, and whether all fluid particles have one diffusivity.
using Variant = std::tuple<int, bool>;

class SpeciesSweepOf : public testing::TestWithParam<Variant> {
  protected:
    static constexpr int species = 1;  ///< the second of two

    SpeciesSweepOf() : set(crowd(std::get<0>(GetParam()), {true, false, std::get<0>(GetParam()) == 3}, 4)) {
        settings.spacing = set.spacing;
        settings.support = 3 * set.spacing;
        settings.sound_speed = 20;
        settings.density.largest = 1000;
    }

    /// A crowd with concentrations, ready for the sweep.
    struct Crowd {
        Crowd(const ParticleSet& set, PairSettings settings, VectorUnit unit, int threads, bool alike)
            : particles(set, std::vector<double>(set.parts.size(), 1000.0)),
              neighbours(ranks, particles.space(), settings.support, threads) {
            settings.vector_unit = unit;
            settings.threads = threads;
            sweeps = make_pair_sweeps(settings, particles);
            for (ParticleGroup& group : particles.groups()) {
                for (const Field field : {Field::species_amount, Field::concentration, Field::species_diffusivity})
                    group.declare(field, 2);
                if (group.kind() != PartKind::fluid) group.declare(Field::species_wall, 2);
            }
            neighbours.list_within_solids();
            fill(set, alike);
            neighbours.renew(particles);
            fill(set, alike);
            neighbours.exchange(particles, {Field::concentration, Field::species_diffusivity, Field::species_wall});
        }
        void fill(const ParticleSet& set, bool alike) {
            const ById by_id(particles);
            std::mt19937 random(12);
            std::uniform_real_distribution<double> unit(0, 1);
            for (std::size_t id = 0; id < by_id.size(); ++id) {
                const auto put = [&](Field field, double value, int array) {
                    if (by_id.group(id).has(field)) by_id.value(field, id, array) = value;
                };
                const bool fluid = set.kind(id) == PartKind::fluid, rigid = set.kind(id) == PartKind::rigid;
                const double concentration = unit(random), diffusivity = 0.5 + unit(random);
                // A third of the wall each is held, gives a flux and conducts; a quarter of the bodies is closed, and
                // one held.
                const bool wall = rigid && id % 3 != 2, body = !fluid && !rigid, closed = body && id % 4 == 0;
                const bool held = (wall && id % 3 == 0) || (body && id % 4 == 1);
                put(Field::concentration, concentration, species);
                put(Field::species_diffusivity,
                    wall || closed || held ? 0
                    : fluid && alike       ? 0.8
                                           : diffusivity,
                    species);
                put(Field::species_wall, held ? 1 : wall ? -1 : 0, species);
                for (int axis = 0; axis < set.dimension; ++axis)
                    put(Field::wall_normal, set.wall_normal[id][axis], axis);
                put(Field::wall_distance, set.wall_distance[id], 0);
            }
        }
        Ranks ranks = Ranks::alone();
        ParticleStore particles;
        Neighbours neighbours;
        std::unique_ptr<PairSweeps> sweeps;
    };

    template <int D>
    static SpeciesWallPoint<double, D> point(const ById& by_id, std::size_t id, const Vec& position) {
        SpeciesWallPoint<double, D> point{};
        for (int axis = 0; axis < D; ++axis) point.position[axis] = position[axis];
        point.volume = by_id.value(Field::volume, id);
        point.concentration = by_id.value(Field::concentration, id, species);
        point.diffusivity = by_id.value(Field::species_diffusivity, id, species);
        if (by_id.group(id).kind() == PartKind::fluid) return point;
        point.held = by_id.value(Field::species_wall, id, species) > 0 ? 1 : 0;
        if (by_id.group(id).kind() != PartKind::rigid) return point;
        for (int axis = 0; axis < D; ++axis) point.normal[axis] = by_id.value(Field::wall_normal, id, axis);
        point.depth = by_id.value(Field::wall_distance, id);
        point.gives = by_id.value(Field::species_wall, id, species) < 0 ? 1 : 0;
        return point;
    }

    /// What each particle takes, and its conductance to all others, written out anew.
    template <int D>
    void by_all_pairs(ParticleStore& particles, std::vector<double>& taken, std::vector<double>& conductances) const {
        const WendlandC2<D> kernel(settings.support);
        const ById by_id(particles);
        const double nearest = 0.5 * set.spacing;
        for_all_pairs(particles, settings.support, [&](const Meeting& m) {
            const auto i = point<D>(by_id, m.i, m.separation), j = point<D>(by_id, m.j, Vec::Zero());
            const bool wall_i = set.kind(m.i) == PartKind::rigid, wall_j = set.kind(m.j) == PartKind::rigid;
            const double pair = i.volume * j.volume * kernel.slope(m.separation.norm());
            const double di = i.diffusivity, dj = j.diffusivity;
            const auto ratio = [&](const auto& wall, double sign) {
                double front = -wall.depth;
                for (int axis = 0; axis < D; ++axis) front += sign * m.separation[axis] * wall.normal[axis];
                return 1 + wall.depth / std::max(front, nearest);
            };
            double both = di + dj > 0 ? 4 * di * dj / (di + dj) : 0;
            if (wall_j) both += j.held * 2 * di * ratio(j, 1);
            if (wall_i) both += i.held * 2 * dj * ratio(i, -1);
            if (!wall_j) both += j.held * 4 * di;
            if (!wall_i) both += i.held * 4 * dj;
            taken[m.i] += pair * both * (i.concentration - j.concentration);
            conductances[m.i] -= pair * both;
            for (int axis = 0; axis < D; ++axis) {
                if (wall_j && !wall_i)
                    taken[m.i] -= 2 * pair * j.gives * j.concentration * m.separation[axis] * j.normal[axis];
                if (wall_i && !wall_j)
                    taken[m.i] -= 2 * pair * i.gives * i.concentration * m.separation[axis] * i.normal[axis];
            }
        });
    }

    [[nodiscard]] SpeciesSums sums(bool alike, double largest_term) const {
        SpeciesSums wanted;
        wanted.species = wanted.array_of_values = species;
        wanted.array_of_result = species;
        wanted.time = 0.25;
        wanted.largest_term = largest_term;
        wanted.with_rigid = wanted.with_elastic = true;
        if (alike) wanted.diffusivity = 0.8;
        return wanted;
    }

    ParticleSet set;
    PairSettings settings;
};

TEST_P(SpeciesSweepOf, takes_what_all_pairs_give) {
    const auto [dimension, alike] = GetParam();
    std::vector<double> first_bits;
    for (const VectorUnit unit : available_vector_units())
        for (const int threads : {1, 3}) {
            SCOPED_TRACE(std::string(to_string(unit)) + ", threads: " + std::to_string(threads));
            Crowd made(set, settings, unit, threads, alike);
            std::vector<double> taken(set.size()), conductances(set.size());
            if (dimension == 3)
                by_all_pairs<3>(made.particles, taken, conductances);
            else
                by_all_pairs<2>(made.particles, taken, conductances);
            double largest = 0;
            for (const double value : taken) largest = std::max(largest, 0.25 * std::abs(value));
            ASSERT_GT(largest, 0);
            SpeciesSums wanted = sums(alike, largest);
            made.sweeps->species(made.particles, {made.neighbours.list(), made.neighbours.within_solids()}, wanted);
            const ById by_id(made.particles);
            std::vector<double> bits;
            double all = 0;
            for (std::size_t id = 0; id < set.size(); ++id) {
                const double found = by_id.value(Field::species_amount, id, species);
                EXPECT_NEAR(found, 0.25 * taken[id], 1e-12 * largest) << "particle " << id;
                bits.push_back(found);
                all += found;
            }
            EXPECT_EQ(all, 0) << "not a bit is lost";
            if (first_bits.empty()) first_bits = bits;
            EXPECT_EQ(bits, first_bits);

            wanted.adds = true;
            made.sweeps->species(made.particles, {made.neighbours.list(), made.neighbours.within_solids()}, wanted);
            for (std::size_t id = 0; id < set.size(); ++id)
                EXPECT_EQ(by_id.value(Field::species_amount, id, species), 2 * bits[id]);

            wanted.adds = false;
            wanted.of = SpeciesSums::Of::conductances;
            made.sweeps->species(made.particles, {made.neighbours.list(), made.neighbours.within_solids()}, wanted);
            for (std::size_t id = 0; id < set.size(); ++id)
                EXPECT_NEAR(by_id.value(Field::species_amount, id, species), 0.25 * conductances[id], 1e-11 * largest);
        }
}

TEST_P(SpeciesSweepOf, leaves_solids_alone_that_take_no_part) {
    const auto [dimension, alike] = GetParam();
    Crowd made(set, settings, VectorUnit::widest, 1, alike);
    SpeciesSums wanted = sums(alike, 1);
    wanted.with_rigid = wanted.with_elastic = false;
    made.sweeps->species(made.particles, {made.neighbours.list(), nullptr}, wanted);
    const ById by_id(made.particles);
    double all = 0, some = 0;
    for (std::size_t id = 0; id < set.size(); ++id) {
        const double found = by_id.value(Field::species_amount, id, species);
        if (set.kind(id) != PartKind::fluid) {
            EXPECT_EQ(found, 0);
        }
        all += found;
        some += std::abs(found);
    }
    EXPECT_EQ(all, 0);
    EXPECT_GT(some, 0);
}

TEST_P(SpeciesSweepOf, takes_up_what_shifting_leaves_behind) {
    const auto [dimension, alike] = GetParam();
    settings.shifting = 4;
    for (const VectorUnit unit : available_vector_units()) {
        SCOPED_TRACE(to_string(unit));
        Crowd made(set, settings, unit, 1, alike);
        const ById by_id(made.particles);
        std::mt19937 random(13);
        std::uniform_real_distribution<double> unit_sum(-1, 1);
        for (std::size_t id = 0; id < set.size(); ++id)
            for (int axis = 0; axis < dimension; ++axis)
                if (set.kind(id) == PartKind::fluid) by_id.value(Field::shift, id, axis) = unit_sum(random);
        SpeciesSums wanted = sums(alike, 1e-6);
        wanted.with_rigid = wanted.with_elastic = false;
        const auto run = [&] {
            made.sweeps->species(made.particles, {made.neighbours.list(), nullptr}, wanted);
            std::vector<double> found;
            for (std::size_t id = 0; id < set.size(); ++id)
                found.push_back(by_id.value(Field::species_amount, id, species));
            return found;
        };
        const std::vector<double> plain = run();
        wanted.shift_per_sum = -0.01;
        wanted.longest_shift = 0.008;  // of which some want more
        const std::vector<double> with = run();

        std::vector<double> expected(set.size());
        double largest = 0;
        int shortened = 0;
        for_all_pairs(made.particles, settings.support, [&](const Meeting& m) {
            if (set.kind(m.i) != PartKind::fluid || set.kind(m.j) != PartKind::fluid) return;
            Vec shift = -0.01 * by_id.vector(Field::shift, m.i);
            if (shift.norm() > 0.008) {
                shift *= 0.008 / shift.norm();
                ++shortened;
            }
            const double r = m.separation.norm();
            const double slope =
                dimension == 3 ? WendlandC2<3>(settings.support).slope(r) : WendlandC2<2>(settings.support).slope(r);
            const double difference =
                by_id.value(Field::concentration, m.j, species) - by_id.value(Field::concentration, m.i, species);
            // V_i [d . grad c + d^2 / 2 laplacian c]
            expected[m.i] += by_id.value(Field::volume, m.i) * by_id.value(Field::volume, m.j) * slope * difference *
                             (shift.dot(m.separation) - shift.squaredNorm());
            largest = std::max(largest, std::abs(expected[m.i]));
        });
        EXPECT_GT(shortened, 10);
        for (std::size_t id = 0; id < set.size(); ++id)
            EXPECT_NEAR(with[id] - plain[id], expected[id], 1e-10 * largest) << "particle " << id;
    }
}

TEST_P(SpeciesSweepOf, is_the_same_along_with_density_rates) {
    const auto [dimension, alike] = GetParam();
    for (const WallModel walls : {WallModel::extrapolated, WallModel::plain})
        for (const auto& [hydrostatic, shifting] : {std::pair(false, 0.0), {false, 4.0}, {true, 0.0}, {true, 4.0}})
            for (const VectorUnit unit : available_vector_units()) {
                SCOPED_TRACE(std::string(to_string(unit)) + ", " + std::string(to_string(walls)) +
                             (shifting > 0 ? ", shifted" : "") + (hydrostatic ? ", hydrostatic" : ""));
                settings.shifting = shifting;
                settings.hydrostatic = hydrostatic;
                settings.walls.model = walls;
                Crowd made(set, settings, unit, 2, alike);
                SpeciesSums wanted = sums(alike, 1e-6);
                EXPECT_FALSE(made.sweeps->can_fuse(wanted)) << "solids take part";
                wanted.with_rigid = wanted.with_elastic = false;
                EXPECT_EQ(made.sweeps->can_fuse(wanted), alike && shifting == 0);
                if (shifting > 0) {
                    wanted.shift_per_sum = -3e-4;
                    wanted.longest_shift = 0.008;  // of which some want more
                    EXPECT_EQ(made.sweeps->can_fuse(wanted), alike);
                }
                if (!alike) continue;
                const ById by_id(made.particles);
                for (std::size_t id = 0; id < set.size(); ++id)
                    for (int axis = 0; axis < dimension; ++axis)
                        by_id.value(Field::velocity, id, axis) = std::sin(static_cast<double>(7 * id + axis));
                made.neighbours.exchange(made.particles, {Field::velocity});
                const std::array<double, 3> g{0.1, -2, 0.3};
                const auto found = [&](Field field, int array) {
                    std::vector<double> values;
                    for (std::size_t id = 0; id < set.size(); ++id)
                        if (set.kind(id) == PartKind::fluid && by_id.group(id).has(field))
                            values.push_back(by_id.value(field, id, array));
                    return values;
                };
                made.sweeps->density_rates(made.particles, made.neighbours.list(), g);
                const auto rates = found(Field::density_rate, 0), shifts = found(Field::shift, 1);
                made.sweeps->species(made.particles, {made.neighbours.list(), nullptr}, wanted);
                const auto alone = found(Field::species_amount, species);
                for (const bool adds : {false, true}) {
                    wanted.adds = adds;
                    for (const ClusterChoice choice : {ClusterChoice::inner, ClusterChoice::border})
                        made.sweeps->density_rates(made.particles, made.neighbours.list(), g, choice, &wanted);
                    EXPECT_EQ(found(Field::density_rate, 0), rates);
                    EXPECT_EQ(found(Field::shift, 1), shifts);
                    const auto along = found(Field::species_amount, species);
                    double largest = 0;
                    for (const double value : alone) largest = std::max(largest, std::abs(value));
                    ASSERT_GT(largest, 0);
                    for (std::size_t k = 0; k < alone.size(); ++k) {
                        const double expected = (adds ? 2 : 1) * alone[k];
                        if (shifting > 0)
                            EXPECT_NEAR(along[k], expected, 1e-11 * largest) << k;
                        else
                            EXPECT_EQ(along[k], expected) << k;
                    }
                }
                if (shifting == 0) continue;
                for (const double value : alone) wanted.largest_term = std::max(wanted.largest_term, std::abs(value));
                wanted.shift_per_sum = -1e-30;
                wanted.adds = false;
                made.sweeps->density_rates(made.particles, made.neighbours.list(), g, ClusterChoice::all, &wanted);
                double all = 0;
                for (const double value : found(Field::species_amount, species)) all += value;
                EXPECT_EQ(all, 0) << "what diffuses is kept to the bit";
            }
}

INSTANTIATE_TEST_SUITE_P(Solver, SpeciesSweepOf, testing::Combine(testing::Values(2, 3), testing::Bool()),
                         [](const auto& variant) {
                             return (std::get<0>(variant.param) == 3 ? std::string("space") : std::string("plane")) +
                                    (std::get<1>(variant.param) ? "_alike" : "");
                         });

}  // namespace
}  // namespace dmp::tests::solver_species_sweep_tests
