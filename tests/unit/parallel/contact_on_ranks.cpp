// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that touch as their surfaces, with friction, on several ranks: the bits of one, also through a checkpoint.
#include <atomic>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "solver/state/checkpoint_folder.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::contact_on_ranks_tests {
namespace {

/// A disc that falls onto a floor beside a wall, through liquid, with a spin.
Meshed falling_disc(const std::string& viscosity_stepping) {
    return mesh_texts(
        {"schema = 1\ntitle = \"disc\"\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = \"1 "
         "mm\"\n[[part]]\nname = \"water\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"5 "
         "mPa*s\"\n[[part]]\nname = \"disc\"\nkind = \"elastic\"\ndensity = \"3000 kg/m^3\"\nyoungs_modulus = \"0.1 "
         "MPa\"\npoisson_ratio = 0.25\ninitial_velocity = [\"0.3 m/s\", \"-0.4 m/s\"]\n[[part]]\nname = \"wall\"\nkind "
         "= "
         "\"rigid\"\n[flow]\nacceleration = [0, \"-10 m/s^2\"]\nlargest_speed = \"0.4 m/s\"\n[contact]\nfriction = "
         "0.4\n[numerics]\nviscosity_stepping = \"" +
             viscosity_stepping + "\"\n[run]\nduration = \"20 ms\"\n[output]\nevery = \"5 ms\"\n",
         "Point(1) = {0, 0, 0};\nPoint(2) = {30e-3, 0, 0};\nPoint(3) = {30e-3, 20e-3, 0};\nPoint(4) = {0, 20e-3, 0};\n"
         "Point(5) = {24.3e-3, 5.4e-3, 0};\nPoint(6) = {29.3e-3, 5.4e-3, 0};\nPoint(7) = {24.3e-3, 10.4e-3, 0};\n"
         "Point(8) = {19.3e-3, 5.4e-3, 0};\nPoint(9) = {24.3e-3, 0.4e-3, 0};\nLine(1) = {1, 2};\nLine(2) = {2, 3};\n"
         "Line(3) = {3, 4};\nLine(4) = {4, 1};\nCircle(5) = {6, 5, 7};\nCircle(6) = {7, 5, 8};\nCircle(7) = {8, 5, "
         "9};\n"
         "Circle(8) = {9, 5, 6};\nCurve Loop(1) = {1, 2, 3, 4};\nCurve Loop(2) = {5, 6, 7, 8};\nPlane Surface(1) = {1, "
         "2};\n"
         "Plane Surface(2) = {2};\nPhysical Surface(\"water\") = {1};\nPhysical Surface(\"disc\") = {2};\nPhysical "
         "Curve(\"wall\") = {1, 2, 3, 4};\n"});
}

/// A ball that is driven onto a floor, through liquid.
Meshed falling_ball() {
    return mesh_texts(
        {"schema = 1\ntitle = \"ball\"\ndimension = 3\n[geometry]\nfile = \"channel.geo\"\nunit = \"1 "
         "mm\"\n[particles]\nspacing = \"1 mm\"\n[[part]]\nname = \"water\"\nkind = \"fluid\"\ndensity = \"1000 "
         "kg/m^3\"\nviscosity = \"2 mPa*s\"\n[[part]]\nname = \"ball\"\nkind = \"elastic\"\nmodel = "
         "\"cells\"\ndensity = \"3000 kg/m^3\"\nyoungs_modulus = \"0.1 MPa\"\npoisson_ratio = "
         "0.25\ninitial_velocity = [\"0.3 m/s\", 0, \"-0.4 m/s\"]\n[[part]]\nname = \"wall\"\nkind = "
         "\"rigid\"\n[flow]\nperiodic = [\"x\", \"y\"]\nlargest_speed = \"0.4 m/s\"\n[contact]\nfriction = "
         "0.4\n[run]\nduration = \"6 ms\"\n[output]\nevery = \"2 ms\"\n",
         "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 10, 10, 8};\nSphere(2) = {5.2, 5.1, 3.1, "
         "2.8};\nBooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; };\nBox(4) = {0, 0, -3, 10, 10, "
         "3};\nBox(5) = {0, 0, 8, 10, 10, 3};\nPhysical Volume(\"water\") = {3};\nPhysical Volume(\"ball\") = "
         "{2};\nPhysical Volume(\"wall\") = {4, 5};\nMesh.MeshSizeMax = 0.8;\n"});
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

RunSummary run_on(const Meshed& made, const Ranks& ranks, const std::filesystem::path& resumed = {}) {
    Resources resources(1);
    resources.ranks = ranks;
    Simulation simulation(made.scene, made.particles, resources);
    if (!resumed.empty()) simulation.resume(resumed);
    return simulation.run({});
}

class ContactOnRanks : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(With, ContactOnRanks, ::testing::Values("explicit", "implicit", "in_space"),
                         [](const auto& of) { return of.param; });

TEST_P(ContactOnRanks, has_the_same_bits_on_any_number_of_ranks_and_resumed) {
    const Ranks ranks = Ranks::world();
    Meshed made;
    for (int rank = 0; rank < ranks.size(); ++rank) {  // one after another, as they write the same files
        if (rank == ranks.rank()) made = GetParam() == "in_space" ? falling_ball() : falling_disc(GetParam());
        (void)ranks.any(false);
    }
    const RunSummary alone = run_on(made, Ranks::alone());
    ASSERT_TRUE(alone.contact);
    EXPECT_GT(alone.contact->depth, 0);
    EXPECT_LT(alone.momentum_residual, 1e-12);
    const RunSummary shared = run_on(made, ranks);
    if (ranks.is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }

    const TemporaryFolder on_each;
    std::string folder = on_each.path().string();
    ranks.broadcast(folder);
    Resources resources(1);
    resources.ranks = ranks;
    StopAtSecondFrame sink;
    RunOptions options;
    options.sink = ranks.is_first() ? &sink : nullptr;
    options.stop = &sink.stop;
    options.checkpoints.folder = folder;
    options.checkpoints.every = 0;
    EXPECT_TRUE(Simulation(made.scene, made.particles, resources).run(options).interrupted);
    const auto checkpoint = CheckpointFolder(folder).newest_good()->file;
    for (const Ranks& on : {ranks, Ranks::alone()}) {
        const RunSummary resumed = run_on(made, on, checkpoint);
        if (ranks.is_first()) {
            EXPECT_EQ(resumed.state_hash, alone.state_hash);
        }
        ASSERT_TRUE(resumed.contact);
        EXPECT_EQ(resumed.contact->depth, alone.contact->depth);
        EXPECT_EQ(resumed.contact->time, alone.contact->time);
    }
}

}  // namespace
}  // namespace dmp::tests::contact_on_ranks_tests
