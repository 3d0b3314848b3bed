// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A solid of cells in moving water, in 2-D and in 3-D, on several ranks: the bits of one, also through a checkpoint.
#include <atomic>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesher/cell_solids.hpp"
#include "mesher/solid_cells.hpp"
#include "solver/state/checkpoint_folder.hpp"
#include "solver/store/share_particles.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::cells_on_ranks_tests {
namespace {

constexpr double spacing = 0.1;
constexpr int side = 14;

/// A block of boxes, those on its low sides filled by two thirds.
SolidCells block(int dimension, const std::array<int, 3>& first, const std::array<int, 3>& last) {
    const BoxLattice lattice{dimension,
                             Vec::Zero(),
                             Vec(spacing, spacing, dimension == 3 ? spacing : 0),
                             {side, side, dimension == 3 ? side : 0}};
    const auto filling = [&](const std::array<int, 3>& box) {
        Filling filled{lattice.volume(), lattice.middle(box), lattice.step.cwiseAbs2() / 12};
        if (box[0] == first[0]) {
            filled.volume *= 2.0 / 3;
            filled.centroid[0] += spacing / 6;
            filled.moment[0] *= 4.0 / 9;
        }
        return filled;
    };
    return solid_cells(lattice, first, last, {filling, [](const auto&, int) { return true; }});
}

void add_particle(ParticleSet& set, const Vec& position, double volume, int part, int body) {
    set.position.push_back(position);
    set.volume.push_back(volume);
    set.mass.push_back(1000 * volume);
    set.part.push_back(part);
    set.body.push_back(body);
    set.fixed.push_back(0);
    set.seated.push_back(0);
    set.wall_normal.push_back(Vec::Zero());
    set.wall_distance.push_back(0);
}

/// Water, periodic and sheared, with a solid that reaches through the planes halfway across it.
SceneAndParticles solid_in_water(int dimension, SpringStepping stepping) {
    SceneAndParticles made = endless_water();
    Scene& scene = made.scene;
    scene.dimension = dimension;
    scene.flow.acceleration[0] = Expression("sin(4 * y)", "sin(4 * y)");
    for (int axis = 0; axis < dimension; ++axis) scene.flow.periodic[axis] = true;
    Part part;
    part.name = std::string("solid");
    part.kind = PartKind::elastic;
    part.model = ElasticModel::cells;
    part.elastic_law = ElasticLaw::of<NeoHookean>();
    part.density = 1000.0;
    part.youngs_modulus = 1e4;
    part.poisson_ratio = 0.4;
    scene.parts.push_back(part);
    scene.contact.strength = 1e-2;
    scene.run.duration = 0.05;
    scene.numerics.step_factor = 0.3;
    scene.numerics.spring_stepping = stepping;
    scene.output.every = 0.05;

    ParticleSet& set = made.particles;
    set = {};
    set.dimension = dimension;
    set.spacing = spacing;
    const int layers = dimension == 3 ? side : 1;
    set.box = {Vec::Zero(), spacing * Vec(side, side, dimension == 3 ? side : 0)};
    set.periodic = {true, true, dimension == 3};
    set.parts = {{"water", PartKind::fluid}, {"solid", PartKind::elastic}};
    // In 3-D it goes on through the periodic sides across y.
    const std::array<int, 3> first{4, dimension == 3 ? 0 : 5, dimension == 3 ? 3 : 0},
        last{9, dimension == 3 ? side : 10, dimension == 3 ? 9 : 1};
    const auto is_solid = [&](const std::array<int, 3>& box) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (box.at(axis) < first.at(axis) || box.at(axis) >= last.at(axis)) return false;
        return true;
    };
    const double volume = std::pow(spacing, dimension);
    for (int k = 0; k < layers; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                if (!is_solid({i, j, k}))
                    add_particle(set, spacing * Vec(i + 0.5, j + 0.5, dimension == 3 ? k + 0.5 : 0), volume, 0, -1);
    const SolidCells cells = block(dimension, first, last);
    const std::size_t first_particle = set.size();
    for (std::size_t n = 0; n < cells.cells.size(); ++n)
        add_particle(set, cells.fillings[n].centroid, cells.fillings[n].volume, 1, cells.piece[n]);
    add_cells_of(cells, first_particle, set);
    return made;
}

RunSummary run_on(const SceneAndParticles& made, const Ranks& ranks, const std::filesystem::path& resumed = {}) {
    Resources resources(1);
    resources.ranks = ranks;
    Simulation simulation(made.scene, made.particles, resources);
    if (!resumed.empty()) simulation.resume(resumed);
    return simulation.run({});
}

class StopAtSecondFrame : public FrameSink {
  public:
    void write(const Frame&) override {
        if (++frames_ == 2) stop = true;
    }
    std::atomic<bool> stop = false;

  private:
    int frames_ = 0;
};

/// Runs half of it, and says where its checkpoint is.
std::filesystem::path stopped_halfway(const SceneAndParticles& made, const Ranks& ranks,
                                      const std::filesystem::path& folder) {
    Resources resources(1);
    resources.ranks = ranks;
    StopAtSecondFrame sink;
    RunOptions options;
    options.sink = ranks.is_first() ? &sink : nullptr;
    options.stop = &sink.stop;
    options.checkpoints.folder = folder;
    options.checkpoints.every = 0;
    EXPECT_TRUE(Simulation(made.scene, made.particles, resources).run(options).interrupted);
    return CheckpointFolder(folder).newest_good()->file;
}

class CellsOnRanks : public ::testing::TestWithParam<std::tuple<int, SpringStepping>> {
  protected:
    SceneAndParticles made_ = solid_in_water(std::get<0>(GetParam()), std::get<1>(GetParam()));
    Ranks ranks_ = Ranks::world();

    [[nodiscard]] static int dimension() { return std::get<0>(GetParam()); }
    [[nodiscard]] std::size_t count_of_solid() const { return made_.particles.cells.size(); }
};

TEST_P(CellsOnRanks, are_the_same_bits_on_any_number_of_ranks) {
    const RunSummary alone = run_on(made_, Ranks::alone()), shared = run_on(made_, ranks_);
    EXPECT_GT(alone.steps, 5);
    EXPECT_EQ(shared.steps, alone.steps);
    EXPECT_EQ(shared.lost, 0U);
    EXPECT_EQ(shared.momentum_residual, alone.momentum_residual);
    EXPECT_LT(shared.momentum_residual, 1e-12);
    if (ranks_.is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
}

TEST(CellsInThickLiquid, move_with_implicit_viscosity_to_the_same_bits_on_any_number_of_ranks) {
    for (const int dimension : {2, 3}) {
        SceneAndParticles made = solid_in_water(dimension, SpringStepping::implicit);
        made.scene.numerics.viscosity_stepping = ViscosityStepping::implicitly;
        made.scene.parts[0].viscosity = 100.0;
        const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, Ranks::world());
        EXPECT_GT(alone.steps, 2);
        EXPECT_EQ(shared.momentum_residual, alone.momentum_residual);
        EXPECT_LT(shared.momentum_residual, 1e-12);
        if (Ranks::world().is_first()) {
            EXPECT_EQ(shared.state_hash, alone.state_hash);
        }
    }
}

Measure measure_of(const std::string& name, MeasureKind kind) {
    Measure measure;
    measure.name = name;
    measure.kind = kind;
    measure.part = std::string("solid");
    return measure;
}

TEST(FieldsOfCells, are_measured_to_the_same_bits_on_any_number_of_ranks) {
    for (const int dimension : {2, 3}) {
        SceneAndParticles made = solid_in_water(dimension, SpringStepping::implicit);
        Scene& scene = made.scene;
        scene.output.measure_every = 0.02;
        scene.regions.emplace_back();
        scene.regions[0].name = std::string("low_half");
        scene.regions[0].to = Vec(2, 0.7, 2);
        scene.measures.push_back(measure_of("low_stress", MeasureKind::field));
        scene.measures.back().field = FluidField::shear_stress;
        scene.measures.back().region = std::string("low_half");
        for (const SolidField field : {SolidField::traction, SolidField::displacement}) {
            scene.measures.push_back(measure_of(to_string(field), MeasureKind::solid_field));
            scene.measures.back().solid_field = field;
        }
        const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, Ranks::world());
        EXPECT_EQ(shared.measures.rows, alone.measures.rows);
        const auto columns = 3 + static_cast<std::size_t>(dimension);
        EXPECT_EQ(alone.measures.names.size(), 3 * columns);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(alone.measures.rows.back().at(k * columns + 2), 0) << k;
    }
}

class LastFrame : public FrameSink {
  public:
    void write(const Frame& frame) override { last = frame; }
    Frame last;
};

/// How far the particles of the solid have moved at the end, all together [m].
double moved(SceneAndParticles made) {
    made.scene.output.solid_fields = std::vector<SolidField>{SolidField::displacement};
    LastFrame sink;
    RunOptions options;
    options.sink = &sink;
    Resources alone(1);
    alone.ranks = Ranks::alone();
    Simulation(made.scene, made.particles, alone).run(options);
    double sum = 0;
    for (const FrameGroup& group : sink.last.groups)
        for (const FrameField& field : group.fields)
            if (field.name == "displacement")
                for (const float component : field.values) sum += std::abs(static_cast<double>(component));
    return sum;
}

TEST(CellsInThickLiquid, move_as_with_explicit_viscosity) {
    SceneAndParticles made = solid_in_water(2, SpringStepping::implicit);
    made.scene.parts[0].viscosity = 20.0;
    made.scene.numerics.step_factor = 0.05;
    const double explicitly = moved(made);
    made.scene.numerics.viscosity_stepping = ViscosityStepping::implicitly;
    EXPECT_GT(explicitly, 0);
    EXPECT_NEAR(moved(made) / explicitly, 1, 0.02);
}

TEST_P(CellsOnRanks, only_the_first_rank_needs_the_particles) {
    SceneAndParticles given = made_;
    if (!ranks_.is_first()) given.particles = {};
    share_particles(given.particles, ranks_);
    ASSERT_EQ(given.particles.cells.size(), made_.particles.cells.size());
    const RunSummary shared = run_on(given, ranks_), whole = run_on(made_, ranks_);
    if (ranks_.is_first()) {
        EXPECT_EQ(shared.state_hash, whole.state_hash);
    }
}

TEST_P(CellsOnRanks, go_on_after_a_restart_on_another_number_of_ranks) {
    made_.scene.output.every = 0.02;
    const RunSummary whole = run_on(made_, Ranks::alone());
    const TemporaryFolder on_each;
    std::string folder = on_each.path().string();
    ranks_.broadcast(folder);
    const RunSummary resumed = run_on(made_, Ranks::alone(), stopped_halfway(made_, ranks_, folder));
    EXPECT_EQ(resumed.steps, whole.steps);
    EXPECT_EQ(resumed.state_hash, whole.state_hash);
    (void)ranks_.largest(0);  // the first rank's folder is there until all have read
}

TEST_P(CellsOnRanks, feel_a_force_by_their_initial_places_also_after_a_restart) {
    ForceOnPart push;
    push.name = std::string("push");
    push.part = std::string("solid");
    push.amount = ForceAmount::per_particle;
    push.force = std::array{Expression("0.1*(X>0.6)+X*x", ""), Expression("Y*Y", ""), Expression()};
    made_.scene.forces = {push};
    made_.scene.output.every = 0.02;
    const RunSummary alone = run_on(made_, Ranks::alone()), shared = run_on(made_, ranks_);
    EXPECT_LT(shared.momentum_residual, 1e-12);
    EXPECT_EQ(shared.impulse_of_body_forces, alone.impulse_of_body_forces);
    double y = 0;  // of the same force at any time
    for (std::size_t i = 0; i < made_.particles.size(); ++i)
        if (made_.particles.part[i] == 1) y += std::pow(made_.particles.position[i][1], 2);
    EXPECT_NEAR(alone.impulse_of_body_forces[1], 0.05 * y, 1e-12);
    const TemporaryFolder on_each;
    std::string folder = on_each.path().string();
    ranks_.broadcast(folder);
    const RunSummary resumed = run_on(made_, Ranks::alone(), stopped_halfway(made_, ranks_, folder));
    EXPECT_EQ(resumed.state_hash, alone.state_hash);
    if (ranks_.is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
    (void)ranks_.largest(0);  // the first rank's folder is there until all have read
}

TEST_P(CellsOnRanks, tear_at_the_same_places_also_after_a_restart) {
    ForceOnPart pull;
    pull.name = std::string("pull");
    pull.part = std::string("solid");
    pull.amount = ForceAmount::per_particle;
    const double strength = dimension() == 3 ? 0.02 : 0.2;
    const std::string formula = std::to_string(strength) + "*(X>0.65?1:-1)";
    pull.force = std::array{Expression(formula, ""), Expression(), Expression()};
    made_.scene.forces = {pull};
    Breaking tear;
    tear.name = std::string("tear");
    tear.part = std::string("solid");
    tear.stress_above = 1.0;
    made_.scene.breaking = {tear};
    if (dimension() == 2) made_.scene.run.duration = 0.1;
    made_.scene.output.every = 0.02;
    const RunSummary alone = run_on(made_, Ranks::alone()), shared = run_on(made_, ranks_);
    EXPECT_LT(shared.momentum_residual, 1e-12);
    const Aggregate& solid = alone.aggregates.at(0);
    EXPECT_EQ(static_cast<std::size_t>(solid.particles), count_of_solid());
    EXPECT_GT(solid.bonds_broken, 4);
    if (dimension() == 2) {  // in 3-D many faces have to break
        EXPECT_GT(solid.pieces, 1);
    }
    const TemporaryFolder on_each;
    std::string folder = on_each.path().string();
    ranks_.broadcast(folder);
    const RunSummary resumed = run_on(made_, Ranks::alone(), stopped_halfway(made_, ranks_, folder));
    EXPECT_EQ(resumed.state_hash, alone.state_hash);
    EXPECT_EQ(resumed.aggregates.at(0).bonds_broken, solid.bonds_broken);
    EXPECT_EQ(shared.aggregates.at(0).pieces, solid.pieces);
    if (ranks_.is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
    (void)ranks_.largest(0);  // the first rank's folder is there until all have read
}

INSTANTIATE_TEST_SUITE_P(Steppers, CellsOnRanks,
                         ::testing::Combine(::testing::Values(2, 3),
                                            ::testing::Values(SpringStepping::implicit, SpringStepping::subcycled)));

}  // namespace
}  // namespace dmp::tests::cells_on_ranks_tests
