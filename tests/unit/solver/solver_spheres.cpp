// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "solver/spheres/sphere_group.hpp"
#include "solver/spheres/sphere_run.hpp"
#include "solver/time/step_limits.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/lammps_spheres.hpp"
#include "tests/unit/solver/sphere_scenes.hpp"

namespace dmp::tests::solver_spheres_tests {
namespace {

std::vector<VectorUnit> units() { return available_vector_units(); }

/// Spheres of LAMMPS in the engine, with its law.
class LammpsCrowd {
  public:
    LammpsCrowd(const LammpsSpheres& peer, VectorUnit unit, int threads) {
        const int part = made_.part("s", PartKind::spheres);
        for (std::size_t i = 0; i < peer.size(); ++i) {
            const auto vec = [](const Vector<double, 3>& v) { return Vec(v[0], v[1], v[2]); };
            made_.sphere(part, vec(peer.start.position[i]), peer.radius[i], vec(peer.start.velocity[i]),
                         vec(peer.start.spin[i]));
            made_.set.mass.back() = peer.mass[i];
        }
        made_.set.box = {Vec::Constant(-0.02), Vec::Constant(0.02)};
        made_.contact(0.5, 0.4).tangential = TangentialLaw::of<PlainHistory>();
        setup_ = sphere_setup(made_.scene, made_.set);
        setup_.pairs.front().constants = peer.pair;
        Resources resources(threads);
        resources.vector_unit = unit;
        group_ = sphere_group(made_.set, PositionQuantum(made_.set), Ranks::alone());
        step_.emplace(made_.scene, made_.set, made_.set, group_, setup_, resources);
        step_->start(true, 0);
    }
    SphereStep& step() { return *step_; }
    /// By id: a row's three numbers.
    template <class Of>
    [[nodiscard]] std::vector<Vector<double, 3>> by_id(const Of& of) const {
        std::vector<Vector<double, 3>> values(made_.set.size());
        for (std::size_t i = 0; i < step_->rows().owned(); ++i) {
            const double* v = of(step_->rows(), i);
            values[static_cast<std::size_t>(group_.tags()[i].id)] = {{v[0], v[1], v[2]}};
        }
        return values;
    }
    [[nodiscard]] auto positions() const {
        return by_id([](const SphereRows& r, std::size_t i) { return r.motion()[i].position.c; });
    }
    [[nodiscard]] auto velocities() const {
        return by_id([](const SphereRows& r, std::size_t i) { return r.motion()[i].velocity.c; });
    }
    [[nodiscard]] auto spins() const {
        return by_id([](const SphereRows& r, std::size_t i) { return r.motion()[i].spin.c; });
    }
    [[nodiscard]] auto forces() const {
        return by_id([](const SphereRows& r, std::size_t i) { return r.loads()[i].force.c; });
    }
    [[nodiscard]] auto torques() const {
        return by_id([](const SphereRows& r, std::size_t i) { return r.loads()[i].torque.c; });
    }

  private:
    SphereScene made_;
    SphereSetup setup_;
    ParticleGroup group_{PartKind::spheres, 3};
    std::optional<SphereStep> step_;
};

using Vectors = std::vector<Vector<double, 3>>;

double largest(const Vectors& values) {
    double most = 0;
    for (const auto& v : values) most = std::max(most, std::sqrt(dot(v, v)));
    return most;
}
void expect_near(const Vectors& found, const Vectors& expected, double tolerance, const char* what) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(found[i][axis], expected[i][axis], tolerance) << what << " of sphere " << i;
}

TEST(SphereEngine, forces_torques_and_a_thousand_steps_are_those_lammps_found) {
    const LammpsSpheres peer =
        read_lammps_spheres(std::filesystem::path(DMP_SOURCE_DIR) / "tests/data/spheres_lammps.txt");
    Vectors first;
    for (const VectorUnit unit : units())
        for (const int threads : {1, 3}) {
            LammpsCrowd crowd(peer, unit, threads);
            for (std::size_t i = 0; i < peer.size(); ++i)
                for (int axis = 0; axis < 3; ++axis) {
                    const auto size = [&](const Vectors& of) { return std::sqrt(dot(of[i], of[i])); };
                    EXPECT_NEAR(crowd.forces()[i][axis], peer.start.force[i][axis], 1e-9 * size(peer.start.force));
                    EXPECT_NEAR(crowd.torques()[i][axis], peer.start.torque[i][axis], 1e-9 * size(peer.start.torque));
                }
            for (int k = 0; k < peer.steps; ++k) crowd.step().advance(k * peer.dt, peer.dt);
            expect_near(crowd.positions(), peer.end.position, 1e-6 * peer.radius[0], "position");
            expect_near(crowd.velocities(), peer.end.velocity, 1e-6 * largest(peer.end.velocity), "velocity");
            expect_near(crowd.spins(), peer.end.spin, 1e-6 * largest(peer.end.spin), "spin");
            expect_near(crowd.forces(), peer.end.force, 1e-6 * largest(peer.end.force), "force");
            EXPECT_GT(crowd.step().neighbours().renewals(), 1);
            if (first.empty()) first = crowd.positions();
            for (std::size_t i = 0; i < first.size(); ++i)
                for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(crowd.positions()[i][axis], first[i][axis]);
        }
}

RunSummary run(const SphereScene& made, const Resources& resources = Resources(1)) {
    SphereRun engine(made.scene, made.set, resources);
    return engine.run({});
}

TEST(SphereEngine, a_crowd_gives_the_same_bits_on_any_threads_and_units) {
    const SphereScene made = crowd(150, 4);
    ASSERT_GT(made.set.size(), 120U);
    std::set<std::string> hashes;
    for (const VectorUnit unit : units())
        for (const int threads : {1, 2, 3}) {
            Resources resources(threads);
            resources.vector_unit = unit;
            const RunSummary summary = run(made, resources);
            hashes.insert(summary.state_hash);
            EXPECT_LT(summary.momentum_residual, 1e-11);
            EXPECT_LT(summary.spheres->end.kinetic(), summary.spheres->start.kinetic());
        }
    EXPECT_EQ(hashes.size(), 1U);
}

TEST(SphereEngine, elastic_spheres_without_friction_keep_energy_and_momentum) {
    SphereScene made = crowd(250, 3);
    made.set.wall_planes.clear();
    made.set.periodic = {true, true, true};
    made.scene.contact_pairs[0].restitution = given(1);
    made.scene.contact_pairs[0].friction = given(0);
    made.scene.numerics.steps_per_contact = 50;
    const SphereSetup setup = sphere_setup(made.scene, made.set);
    const PositionQuantum quantum(made.set);
    const ParticleSpace space = with_whole_periods(made.set, quantum);
    ParticleGroup group = sphere_group(made.set, quantum, Ranks::alone());
    SphereStep step(made.scene, made.set, space, group, setup, Resources(1));
    step.start(true, 0);
    const auto energy = [&] {
        double sum = kinetic_energy(step, Ranks::alone()).kinetic();
        const ContactList& list = step.neighbours().list();
        list.for_each([&](std::size_t k, std::int16_t kind) {
            if (list.low()[k] >= static_cast<std::int32_t>(group.owned())) return;  // the other image counts
            const SphereMotion &a = step.rows().motion()[list.low()[k]], &b = step.rows().motion()[list.high()[k]];
            const double distance = Vec(a.position.c[0] - b.position.c[0], a.position.c[1] - b.position.c[1],
                                        a.position.c[2] - b.position.c[2])
                                        .norm();
            sum += HertzContact::energy(a.radius() + b.radius() - distance,
                                        a.radius() * b.radius() / (a.radius() + b.radius()),
                                        setup.pairs[static_cast<std::size_t>(kind)].constants);
        });
        return sum;
    };
    const auto momentum = [&] {
        Vec sum = Vec::Zero();
        for (const SphereMotion& sphere : step.rows().motion().first(group.owned()))
            sum += sphere.velocity.c[3] * Vec(sphere.velocity.c[0], sphere.velocity.c[1], sphere.velocity.c[2]);
        return sum;
    };
    const double at_first = energy(), kinetic = kinetic_energy(step, Ranks::alone()).kinetic();
    const Vec momentum_at_first = momentum();
    const double dt = ruling_limit(sphere_step_limits(made.scene, setup, space, 4.0)).dt;
    double least_kinetic = kinetic;
    for (int k = 0; k < 1500; ++k) {
        step.advance(k * dt, dt);
        least_kinetic = std::min(least_kinetic, kinetic_energy(step, Ranks::alone()).kinetic());
    }
    EXPECT_NEAR(energy() / at_first, 1, 1e-4);
    EXPECT_LT(least_kinetic, 0.99 * kinetic);  // contacts held some of it
    EXPECT_LT((momentum() - momentum_at_first).norm(), 1e-13 * kinetic);
}

/// Normal velocity after an impact on a plane over that before.
double bounce(double restitution) {
    SphereScene made;
    made.scene.numerics.steps_per_contact = 200;
    const int ball = made.part("ball", PartKind::spheres), floor = made.part("floor", PartKind::plane, 0);
    made.contact(restitution, 0.3);
    made.plane(floor, Vec::Zero(), Vec::UnitZ());
    made.sphere(ball, Vec(0, 0, 1.01e-3), 1e-3, Vec(0, 0, -1));
    made.scene.run.duration = given(4e-4);
    return run(made).end.momentum[2] / run(made).start.mass;
}
TEST(SphereEngine, restitution_asked_comes_out) {
    for (const double restitution : {0.1, 0.3, 0.5, 0.7, 0.9, 0.98})
        EXPECT_NEAR(bounce(restitution), restitution, 0.005 * restitution);
}

/// A ball thrown on a floor at an angle, so that it bounces, slides, and then rolls.
SphereScene thrown_ball() {
    SphereScene made;
    const int ball = made.part("ball", PartKind::spheres);
    made.part("floor", PartKind::plane, 0);
    made.contact(0.4, 0.3);
    made.sphere(ball, Vec(0.1e-3, 0.2e-3, 1e-3), 1e-3, Vec(0.4, 0.17, -0.1));
    made.scene.flow.acceleration[2] = Expression("-40", "-40");
    made.scene.run.duration = given(0.02);
    made.scene.output.every = 0.02;
    Measure velocity;
    velocity.name = std::string("v");
    velocity.kind = MeasureKind::velocity;
    velocity.part = Value<std::string>("ball", SourceLocation{"scene.toml", 3, 1});
    Measure spin = velocity;
    spin.name = std::string("w");
    spin.kind = MeasureKind::spin;
    made.scene.measures = {velocity, spin};
    made.scene.output.measure_every = 5e-4;
    return made;
}

TEST(SphereWalls, a_ball_that_rolls_over_triangles_feels_no_edges) {
    SphereScene flat = thrown_ball(), tiled = thrown_ball();
    flat.plane(1, Vec::Zero(), Vec::UnitZ());
    // Triangles smaller than the ball, whose edges lie across its way; corners are not shared.
    const double side = 0.7e-3;
    for (int i = -2; i < 14; ++i)
        for (int j = -2; j < 8; ++j) {
            const Vec a(i * side, j * side, 0), b((i + 1) * side, j * side, 0), c((i + 1) * side, (j + 1) * side, 0),
                d(i * side, (j + 1) * side, 0);
            tiled.triangle(1, a, b, c);
            tiled.triangle(1, c, d, a);
        }
    const MeasureSeries on_plane = run(flat).measures, on_tiles = run(tiled).measures;
    ASSERT_EQ(on_plane.rows.size(), on_tiles.rows.size());
    for (std::size_t k = 0; k < on_plane.rows.size(); ++k)
        for (std::size_t c = 0; c < 6; ++c)
            EXPECT_NEAR(on_tiles.rows[k][c], on_plane.rows[k][c], c < 3 ? 1e-8 : 1e-5) << "row " << k;
    // Slid at first, rolls in the end: v = w R; 5/7 of the tangential speed at least.
    const auto& last = on_plane.rows.back();
    EXPECT_NEAR(last[0], last[4] * 1e-3, 2e-3);
    EXPECT_GT(last[0], 0.4 * 5 / 7 - 0.01);
    EXPECT_LT(last[0], 0.4);
}

/// The force of walls on a ball at rest, pressed into them by a micrometre.
Vec force_in(const std::vector<std::array<Vec, 3>>& triangles, const Vec& position) {
    SphereScene made;
    const int ball = made.part("ball", PartKind::spheres);
    made.part("walls", PartKind::surface, 0);
    made.contact(1, 0);
    made.sphere(ball, position, 1e-3);
    for (const auto& [a, b, c] : triangles) made.triangle(1, a, b, c);
    const SphereSetup setup = sphere_setup(made.scene, made.set);
    ParticleGroup group = sphere_group(made.set, PositionQuantum(made.set), Ranks::alone());
    SphereStep step(made.scene, made.set, made.set, group, setup, Resources(1));
    step.start(true, 0);
    const double* force = step.rows().loads()[0].force.c;
    return {force[0], force[1], force[2]};
}

TEST(SphereWalls, faces_edges_and_corners_push_once_each) {
    const double r = 1e-3, d = 1e-6;
    const Vec o = Vec::Zero(), x = 0.01 * Vec::UnitX(), y = 0.01 * Vec::UnitY(), z = 0.01 * Vec::UnitZ();
    const double once = force_in({{o, x, y}}, Vec(0.2 * r, 0.2 * r, r - d))[2];
    EXPECT_GT(once, 0);
    // On an edge and a corner that several triangles share, in a plane.
    const std::vector<std::array<Vec, 3>> star{{o, x, y}, {o, y, -x}, {o, -x, -y}, {o, -y, x}};
    for (const Vec& above : {Vec(0, 0, 0), Vec(0.3 * r, 0, 0), Vec(1e-12, -1e-12, 0), Vec(0.001 * r, 0.0005 * r, 0)}) {
        const Vec force = force_in(star, above + Vec(0, 0, r - d));
        EXPECT_NEAR(force[2] / once, 1, 1e-9) << above.transpose();
        EXPECT_NEAR(force.head<2>().norm() / once, 0, 1e-6);
    }
    // A roof's edge: once, along the bisector.
    const Vec left = -0.01 * Vec::UnitX() - z, right = 0.01 * Vec::UnitX() - z;
    const Vec ridge = force_in({{o, y, left}, {o, y, right}}, Vec(0, 0.002, r - d));
    EXPECT_NEAR(ridge[2] / once, 1, 1e-9);
    // A corner of three walls at right angles: each of them.
    const Vec corner = force_in({{o, x, y}, {o, y, z}, {o, z, x}}, Vec::Constant(r - d));
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(corner[axis] / once, 1, 1e-9);
}

TEST(SphereWalls, a_floor_that_rises_gives_its_velocity) {
    SphereScene made;
    const int ball = made.part("ball", PartKind::spheres), floor = made.part("floor", PartKind::plane, 0);
    made.contact(1, 0);
    made.scene.parts[1].velocity = std::array{Expression(), Expression(), Expression("0.5", "0.5")};
    made.plane(floor, Vec::Zero(), Vec::UnitZ());
    made.sphere(ball, Vec(0, 0, 1.05e-3), 1e-3);
    made.scene.run.duration = given(1e-3);
    const RunSummary summary = run(made);
    EXPECT_NEAR(summary.end.momentum[2] / summary.end.mass, 1, 2e-3);  // an elastic impact: twice the floor's
    EXPECT_NEAR(summary.impulse_of_fixed[2], summary.end.momentum[2], 1e-12 * summary.end.momentum[2]);
}

TEST(SphereEngine, ends_when_nothing_changes_any_more) {
    SphereScene made = thrown_ball();
    made.plane(1, Vec::Zero(), Vec::UnitZ());
    made.scene.flow.acceleration[2] = Expression();
    made.scene.run.until_steady = 1e-3;
    const RunSummary summary = run(made);
    EXPECT_LT(summary.simulated_s, 3e-3);  // one impact, then free flight
    EXPECT_GT(summary.spheres->still_since, 0);
    EXPECT_GT(summary.end.momentum[2], 0);
}

TEST(SphereEngine, counts_what_detaches_by_halves) {
    SphereScene made;
    const int carrier = made.part("carrier", PartKind::spheres), fines = made.part("fines", PartKind::spheres);
    made.contact(1, 0.3);
    made.sphere(carrier, Vec::Zero(), 1e-3);
    made.sphere(fines, Vec(0, 0, 1.0999e-3), 1e-4);
    made.sphere(fines, Vec(0, 0, 1.2998e-3), 1e-4);  // hangs on by the first
    made.sphere(fines, Vec(0, 1.0999e-3, 1e-6), 1e-4);
    made.sphere(fines, Vec(0, 0, -1.15e-3), 1e-4);
    made.sphere(fines, Vec(0, 0, 3e-3), 1e-4);
    Measure detached;
    detached.name = std::string("gone");
    detached.kind = MeasureKind::detached;
    detached.part = Value<std::string>("carrier", SourceLocation{"scene.toml", 3, 1});
    made.scene.measures = {detached};
    made.scene.run.duration = given(1e-9);
    const MeasureSeries series = run(made).measures;
    EXPECT_EQ(series.names, (std::vector<std::string>{"gone", "gone_upper", "gone_lower"}));
    EXPECT_EQ(series.rows.front(), (std::vector<double>{2, 1, 1}));
}

TEST(SphereEngine, refuses_what_it_cannot_do) {
    SphereScene both = thrown_ball();
    both.set.parts.push_back({"water", PartKind::fluid});
    both.set.part.back() = 2;
    EXPECT_THROW(run(both), InputError);
    SphereScene tight = thrown_ball();
    tight.set.periodic = {true, false, false};
    tight.set.box = {Vec::Zero(), Vec::Constant(3.9e-3)};
    EXPECT_THROW(run(tight), InputError);
    SphereScene soft = thrown_ball();
    soft.plane(1, Vec::Zero(), Vec::UnitZ());
    soft.scene.parts[0].youngs_modulus = given(1e2);
    EXPECT_THROW(run(soft), DivergenceError);
}

}  // namespace
}  // namespace dmp::tests::solver_spheres_tests
