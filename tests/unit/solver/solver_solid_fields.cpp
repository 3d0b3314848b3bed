// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>

#include "solver/output/fluid_fields.hpp"
#include "solver/output/solid_fields.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/ladder_body.hpp"

namespace dmp::tests::solver_solid_fields_tests {
namespace {

using ::testing::ElementsAre;

const Ranks alone = Ranks::alone();
constexpr int cells = 20;

/// Virial stress of the nodes of a column halfway along a clamped ladder that is loaded at its end [Pa]: rows of one
/// spacing each and 1 m deep, so that a section is 2 m^2; nodes of 1 m^3.
std::array<std::array<double, 6>, 2> stress_halfway(const V2& load, double hinge_stiffness = 0.5) {
    const ParticleSet set = ladder({cells, hinge_stiffness, true});
    PlaneBody body(set, part_with(0), 0);
    body.positions() = statics(body, set, end_load(set, load));
    const auto virial = body.virial();
    std::array<std::array<double, 6>, 2> stress{};
    for (std::size_t row = 0; row < 2; ++row)
        for (std::size_t c = 0; c < 6; ++c) stress[row][c] = -virial[cells + row][c] / 1.0;
    return stress;
}

TEST(VirialStress, of_a_stretched_bar_is_force_over_area) {
    constexpr double force = 1e-4;
    for (const auto& [xx, yy, zz, xy, yz, xz] : stress_halfway({{force, 0}})) {
        EXPECT_NEAR(xx, force / 2, 1e-3 * force);  // the bar is longer by force / EA, the section is not narrower
        EXPECT_NEAR(yy, 0, 1e-3 * force);
        EXPECT_NEAR(xy, 0, 1e-9);
        EXPECT_EQ(std::abs(zz) + std::abs(yz) + std::abs(xz), 0) << "all is in 2-D";
    }
    for (const auto& stress : stress_halfway({{-force, 0}})) EXPECT_NEAR(stress[0], -force / 2, 1e-3 * force);
}

TEST(VirialStress, of_a_bent_bar_is_tension_on_one_side_and_shear_over_the_section) {
    constexpr double force = 1e-7, moment = force * cells / 2;
    for (const double k_a : {0.01, 0.1, 0.5}) {
        const auto stress = stress_halfway({{0, force}}, k_a);  // upwards: the lower row is stretched
        const auto& [upper, lower] = stress;
        // EI = 1 + 2 k_a: the bonds hold 1 of it, on arms of half a spacing, the hinges 2 k_a.
        EXPECT_NEAR(upper[0] + lower[0], 0, 1e-3 * moment);
        EXPECT_NEAR(lower[0], moment / bending_stiffness(k_a), 0.02 * moment);
        // Thirds of hinges that hold more and more of a moment leave out a third of its gradient.
        const double of_hinges = 2 * k_a / bending_stiffness(k_a);
        EXPECT_NEAR(upper[3] + lower[3], (1 - of_hinges / 3) * force, 0.01 * force) << k_a;
    }
}

TEST(VirialStress, of_a_body_at_rest_is_nothing) {
    const ParticleSet set = ladder({cells, 0.5, true});
    for (const auto& virial : PlaneBody(set, part_with(0), 0).virial())
        for (const double component : virial) EXPECT_NEAR(component, 0, 1e-15);
}

TEST(VonMises, of_plain_states) {
    EXPECT_DOUBLE_EQ(von_mises({7, 0, 0, 0, 0, 0}), 7);
    EXPECT_DOUBLE_EQ(von_mises({0, -7, 0, 0, 0, 0}), 7);
    EXPECT_NEAR(von_mises({5, 5, 5, 0, 0, 0}), 0, 1e-12);
    EXPECT_DOUBLE_EQ(von_mises({0, 0, 0, 2, 0, 0}), 2 * std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(von_mises({0, 0, 0, 0, 2, 0}), 2 * std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(von_mises({0, 0, 0, 0, 0, 2}), 2 * std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(von_mises({3, 1, 0, 0, 0, 0}), std::sqrt(7.0));
}

/// A ladder whose ends are pulled for some steps, and a frame's group of it with its particles in another order.
class SolidFields : public ::testing::Test {
  protected:
    explicit SolidFields(double average_from = 0) : set_(ladder({4, 0.5, true})) {
        scene_ = scene_with(part_with(0.2), SpringStepping::implicit);
        scene_.output.solid_fields = {SolidField::mean_displacement,  SolidField::stress, SolidField::displacement,
                                      SolidField::von_mises,          SolidField::strain, SolidField::force,
                                      SolidField::principal_stretches};
        scene_.output.average_from = average_from;
    }
    void run() {
        SpringBodies springs(set_, scene_, alone);
        ParticleStore particles(set_, {1000}, alone);
        springs.find_nodes(particles);
        MeanDisplacement mean(scene_, springs);
        constexpr double dt = 0.5;
        std::vector<Vec> sum(set_.size(), Vec::Zero());
        double duration = 0;
        for (int step = 0; step < 8; ++step) {
            particles.of(PartKind::elastic).data(Field::force, 0)[set_.size() - 1] = 0.01 * (step + 1);
            springs.advance(particles, dt, 1);
            mean.add(springs, step * dt, dt);
            const double counted = std::min(dt, (step + 1) * dt - *scene_.output.average_from);
            if (counted <= 0) continue;
            duration += counted;
            for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += counted * springs.bodies()[0]->displacement(n);
        }
        for (Vec& each : sum) each *= duration > 0 ? 1 / duration : 0;
        expected_mean_ = sum;
        expected_ = springs.bodies()[0]->virial();
        for (std::size_t n = set_.size(); n-- > 0;) {
            group_.id.push_back(static_cast<std::int64_t>(n));
            volume_.push_back(2.0F);
        }
        add_solid_fields(group_, scene_.output.solid_fields, volume_, {springs, &mean, nullptr});
    }
    [[nodiscard]] float value(std::size_t field, std::size_t node, int component) const {
        const FrameField& found = group_.fields.at(field);
        return found.values.at(static_cast<std::size_t>(found.components) * (set_.size() - 1 - node) +
                               static_cast<std::size_t>(component));
    }

    ParticleSet set_;
    Scene scene_;
    FrameGroup group_;
    std::vector<float> volume_;
    std::vector<Vec> expected_mean_;
    std::vector<std::array<double, 6>> expected_;
};

TEST_F(SolidFields, are_those_asked_for_in_the_order_of_the_group) {
    run();
    std::vector<std::string> names;
    for (const FrameField& field : group_.fields) names.push_back(field.name);
    EXPECT_THAT(names, ElementsAre("mean_displacement", "stress", "displacement", "von_mises", "principal_stretches"));
    EXPECT_EQ(group_.fields[1].components, 6);
    EXPECT_EQ(group_.fields[1].unit, "Pa");
    ASSERT_EQ(group_.bond_fields.size(), 2U);
    EXPECT_EQ(group_.bonds(), set_.bonds.size());
    const FrameField& strain = group_.bond_fields.at(0);
    ASSERT_EQ(strain.name, "strain");
    std::vector<std::array<float, 2>> stretches(set_.size(), {2, 0});
    for (std::size_t b = 0; b < group_.bonds(); ++b)
        for (const std::size_t end : {2 * b, 2 * b + 1}) {
            auto& [least, most] = stretches.at(static_cast<std::size_t>(group_.id[group_.bond_ends[end]]));
            least = std::min(least, 1 + strain.values[b]);
            most = std::max(most, 1 + strain.values[b]);
        }
    float largest = 0;
    for (std::size_t node = 0; node < set_.size(); ++node) {
        EXPECT_NEAR(value(4, node, 0), stretches[node][0], 1e-6F);
        EXPECT_NEAR(value(4, node, 1), stretches[node][1], 1e-6F);
        std::array<double, 6> stress = expected_[node];
        for (double& component : stress) component /= -2;
        for (int c = 0; c < 6; ++c) EXPECT_FLOAT_EQ(value(1, node, c), static_cast<float>(stress[c])) << node;
        EXPECT_FLOAT_EQ(value(3, node, 0), static_cast<float>(von_mises(stress)));
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_FLOAT_EQ(value(0, node, axis), static_cast<float>(expected_mean_[node][axis]));
        largest = std::max(largest, value(3, node, 0));
    }
    EXPECT_GT(largest, 1e-3F) << "else nothing was tested";
}

class AverageFromTheMiddle : public SolidFields {
  protected:
    AverageFromTheMiddle() : SolidFields(1.75) {}
};

TEST_F(AverageFromTheMiddle, of_a_step_counts_what_is_later) {
    run();
    for (std::size_t node = 0; node < set_.size(); ++node)
        EXPECT_FLOAT_EQ(value(0, node, 0), static_cast<float>(expected_mean_[node][0]));
    EXPECT_GT(std::abs(value(2, set_.size() - 1, 0) - value(0, set_.size() - 1, 0)), 1e-4F);
}

class AverageFromLater : public SolidFields {
  protected:
    AverageFromLater() : SolidFields(100) {}
};

TEST_F(AverageFromLater, is_the_displacement_until_then) {
    run();
    for (std::size_t node = 0; node < set_.size(); ++node) EXPECT_EQ(value(0, node, 0), value(2, node, 0));
}

}  // namespace
}  // namespace dmp::tests::solver_solid_fields_tests
