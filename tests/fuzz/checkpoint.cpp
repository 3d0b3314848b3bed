// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Checkpoints that hold anything. The contents of one that a run has written are changed, number by number and dataset
// by dataset, as the input says; a run of the same scene then goes on from it, or starts from it, up to its first step.
// It does, or refuses it by an error. HDF5 itself has no part in it (hdf5_in_memory.hpp).
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <vector>

#include <unistd.h>

#include "base/errors.hpp"
#include "solver/simulation.hpp"
#include "tests/fuzz/hdf5_in_memory.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/clot_scenes.hpp"
#include "tests/unit/solver/dissolved.hpp"
#include "tests/unit/solver/sphere_scenes.hpp"

namespace {

using namespace dmp;
using namespace dmp::tests;

/// A scene and the checkpoint that a run of it has left.
struct Saved {
    solver::Scene scene;
    particles::ParticleSet set;
    StoredFile file;
};

/// A clot grows in a channel: a liquid, walls, and bodies that change.
SceneAndParticles clot() {
    SceneAndParticles made = blood_channel(8);
    made.scene.regions = {middle_of(made)};
    Solidify rule = clot_of("blood");
    rule.seed_region = std::string("nidus");
    made.scene.solidify = {rule};
    made.scene.measures = {size_of_clot()};
    made.scene.output.solid_fields.push_back(SolidField::mean_displacement);
    return made;
}

/// Spheres that are pushed, on a floor that moves.
SphereScene spheres() {
    SphereScene made = crowd(20, 2);
    made.force("small", {"1e-4", "0", "-1e-3"}, ForceAmount::per_particle);
    made.scene.parts[2].velocity =
        std::array{SphereScene::expression("0.1"), Expression(), SphereScene::expression("-0.1")};
    return made;
}

Saved saved(const solver::Scene& scene, const particles::ParticleSet& set) {
    const auto folder = std::filesystem::temp_directory_path() / ("dmp_fuzz_" + std::to_string(getpid()));
    solver::RunOptions options;
    options.until = scene.run.duration / 2;
    options.checkpoints.folder = folder;
    options.checkpoints.every = 0;
    solver::Simulation(scene, set, 1).run(options);
    std::filesystem::remove_all(folder);
    return {scene, set, stored_file()};
}

const std::vector<Saved>& all_saved() {
    static const std::vector<Saved> all = [] {
        const SceneAndParticles of_fluid = clot();
        const SphereScene of_spheres = spheres();
        const SceneAndParticles mixture = stirred_mixture();
        return std::vector{saved(of_fluid.scene, of_fluid.particles), saved(of_spheres.scene, of_spheres.set),
                           saved(mixture.scene, mixture.particles)};
    }();
    return all;
}

/// One change of the contents.
struct Edit {
    std::uint16_t dataset, position;
    std::uint32_t what;
    std::uint64_t value;
};

double remarkable(std::uint64_t which) {
    using Limits = std::numeric_limits<double>;
    constexpr double infinity = Limits::infinity();
    constexpr std::array values{0.0,         -0.0,   1.0,       -1.0,     2.5,
                                1e9,         -1e9,   1e18,      1e19,     1e300,
                                -1e300,      1e-300, -infinity, infinity, Limits::quiet_NaN(),
                                4294967296.0};
    return values.at(which % values.size());
}

void change(const Edit& edit, StoredFile& file) {
    if (file.empty()) return;
    const auto found = std::next(file.begin(), edit.dataset % static_cast<std::ptrdiff_t>(file.size()));
    StoredDataset& data = found->second;
    switch (edit.what % 6) {
        case 0:
        case 1:
        case 2: {
            if (data.bytes.size() < data.width()) return;
            const std::size_t at = edit.position % (data.bytes.size() / data.width());
            const std::uint64_t bits =
                edit.what % 6 == 0 ? edit.value : std::bit_cast<std::uint64_t>(remarkable(edit.value));
            std::memcpy(data.bytes.data() + at * data.width(), &bits, data.width());
            return;
        }
        case 3:
            data.bytes.resize(edit.value % 4096 * data.width());
            return;
        case 4:
            data.type = static_cast<Hdf5Type>(edit.value % 8);
            data.bytes.resize(data.bytes.size() / data.width() * data.width());
            return;
        case 5:
            file.erase(found);
            return;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const Saved& of = all_saved().at(data[0] % all_saved().size());
    stored_file() = of.file;
    for (std::size_t at = 1; at + sizeof(Edit) <= size; at += sizeof(Edit)) {
        Edit edit{};
        std::memcpy(&edit, data + at, sizeof(Edit));
        change(edit, stored_file());
    }
    try {
        solver::Simulation simulation(of.scene, of.set, 1);
        if ((data[0] & 0x80U) != 0)
            simulation.start_from("checkpoint");
        else
            simulation.resume("checkpoint");
        const std::atomic<bool> stop{true};
        solver::RunOptions options;
        options.stop = &stop;
        static_cast<void>(simulation.run(options));
    } catch (const Error&) {
        return 0;
    }
    return 0;
}
