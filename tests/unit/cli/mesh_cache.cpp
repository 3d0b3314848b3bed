// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_cache.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::mesh_cache_tests {

using namespace cli;
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// A scene in a folder of its own, with a cache beside it.
class MeshCacheTest : public ::testing::Test {
  protected:
    MeshCacheTest() {
        Folder::write(flap_channel.scene);
        Folder::write(flap_channel.cad_geometry, "channel.geo");
    }
    [[nodiscard]] static Scene scene(const std::vector<std::string>& overrides = {}) {
        return read_scene("scene.toml", overrides);
    }
    [[nodiscard]] static ParticlesWithOrigin made() {
        return {mesh_file("scene.toml").particles,
                {"geometry", "channel.geo", {{"flap", "k_b 3 N/m"}}, {"lattice stretched"}}};
    }
    /// Kept as if it had taken three seconds.
    void keep(double seconds = 3) {
        ParticlesWithOrigin particles = made();
        cache_.keep(scene(), particles, seconds);
    }
    [[nodiscard]] std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> found;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator("cache", none)) found.push_back(entry.path());
        return found;
    }

    Folder folder_;
    MeshCache cache_{std::filesystem::path("cache")};
};

TEST_F(MeshCacheTest, finds_what_it_kept) {
    EXPECT_FALSE(cache_.find(scene()));
    keep();
    EXPECT_THAT(files(), SizeIs(2));
    const auto found = cache_.find(scene());
    ASSERT_TRUE(found);
    const ParticlesWithOrigin fresh = made();
    EXPECT_EQ(found->particles.position, fresh.particles.position);
    EXPECT_EQ(found->particles.bonds.size(), fresh.particles.bonds.size());
    EXPECT_EQ(found->origin.springs, fresh.origin.springs);
    EXPECT_EQ(found->origin.what, "geometry");
    EXPECT_EQ(found->origin.file, "channel.geo");
    EXPECT_THAT(found->origin.notes, Contains("lattice stretched"));
    EXPECT_THAT(found->origin.notes, Contains(HasSubstr("made in an earlier run, which took 3 s")));
    // What particles do not depend on may change.
    EXPECT_TRUE(cache_.find(scene({"run.duration=\"2 s\"", "part.water.viscosity=\"2 mPa*s\""})));
}

TEST_F(MeshCacheTest, does_not_find_what_has_changed) {
    keep();
    EXPECT_FALSE(cache_.find(scene({"particles.spacing=\"0.25 m\""})));
    EXPECT_FALSE(cache_.find(scene({"part.flap.axial_stiffness=\"200 N\""})));
    Folder::write(flap_channel.with("{2, 1, 0}", "{2.5, 1, 0}").cad_geometry, "channel.geo");
    EXPECT_FALSE(cache_.find(scene()));
    Folder::write(flap_channel.cad_geometry, "channel.geo");
    EXPECT_TRUE(cache_.find(scene()));
}

TEST_F(MeshCacheTest, damaged_files_are_not_there) {
    keep();
    for (const auto& file : files())
        if (file.extension() == ".h5") std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    EXPECT_FALSE(cache_.find(scene()));
    keep();
    EXPECT_TRUE(cache_.find(scene()));
    for (const auto& file : files())
        if (file.extension() == ".json") std::ofstream(file) << "{";
    EXPECT_FALSE(cache_.find(scene()));
}

TEST_F(MeshCacheTest, keeps_only_what_took_long_and_what_it_knows_whole) {
    keep(1);
    EXPECT_THAT(files(), SizeIs(0));
    Folder::write("Include \"channel.inc\";\n", "channel.geo");
    Folder::write(flap_channel.cad_geometry, "channel.inc");
    keep();
    EXPECT_THAT(files(), SizeIs(0));
    EXPECT_FALSE(cache_.find(scene()));
}

TEST_F(MeshCacheTest, a_cache_that_cannot_be_written_to_is_noted) {
    Folder::write("a file", "cache");
    ParticlesWithOrigin particles = made();
    cache_.keep(scene(), particles, 3);
    EXPECT_THAT(particles.origin.notes, Contains(HasSubstr("could not be kept for the next run")));
    EXPECT_FALSE(cache_.find(scene()));
    EXPECT_FALSE(MeshCache(std::nullopt).find(scene()));
}

TEST_F(MeshCacheTest, several_processes_may_keep_the_same_particles_at_once) {
    const ParticlesWithOrigin particles = made();
    const Scene kept = scene();
    std::vector<pid_t> processes;
    for (int process = 0; process < 4; ++process) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            int faults = 0;
            for (int time = 0; time < 10; ++time) {
                ParticlesWithOrigin mine = particles;
                cache_.keep(kept, mine, 3);
                faults += mine.origin.notes == particles.origin.notes ? 0 : 1;
            }
            _exit(faults);
        }
        processes.push_back(child);
    }
    for (const pid_t process : processes) {
        int status = -1;
        ASSERT_EQ(waitpid(process, &status, 0), process);
        EXPECT_EQ(status, 0) << "one of them could not keep its particles";
    }
    EXPECT_THAT(files(), SizeIs(2));
    EXPECT_TRUE(cache_.find(kept));
}

}  // namespace
}  // namespace dmp::tests::mesh_cache_tests
