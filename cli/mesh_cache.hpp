// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/particles_with_origin.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::cli {

/// Particles that took long to make, kept for the next run of the same scene: in $XDG_CACHE_HOME/dmp/particles, or
/// ~/.cache/dmp/particles, as files of particles with what is worth knowing of them beside it. They are found by a hash
/// of the geometry's file, of the scene's values that particles depend on, and of the program. Scenes of spheres are
/// not kept, nor geometries that include other files.
class MeshCache {
  public:
    /// In this folder, or where the user's caches are; nowhere when there is no such place.
    explicit MeshCache(std::optional<std::filesystem::path> folder = users_folder()) : folder_(std::move(folder)) {}

    /// None when they are not there, or damaged.
    [[nodiscard]] std::optional<ParticlesWithOrigin> find(const Scene& scene) const;
    /// Makes them anew, in the way given, and keeps them.
    [[nodiscard]] ParticlesWithOrigin make(const Scene& scene, const std::function<ParticlesWithOrigin()>& how) const;
    /// Keeps what took at least `worth_keeping` seconds to make, and removes what was used longest ago until all
    /// together have at most `largest` bytes. A cache that cannot be written to is noted in `made`, no error.
    void keep(const Scene& scene, ParticlesWithOrigin& made, double seconds) const;

    static constexpr double worth_keeping = 2;
    static constexpr std::uintmax_t largest = 4ULL << 30U;

    [[nodiscard]] static std::optional<std::filesystem::path> users_folder();

  private:
    /// Of a scene whose particles depend on these lines, without ending; none for those that are not kept.
    [[nodiscard]] std::optional<std::filesystem::path> name_of(const std::vector<std::string>& lines) const;
    void make_room() const;

    std::optional<std::filesystem::path> folder_;
};

}  // namespace dmp::cli
