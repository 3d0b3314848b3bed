// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "cli/commands.hpp"
#include "cli/particles_with_origin.hpp"
#include "cli/uses.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/run_label.hpp"

namespace dmp::cli {

/// A scene, read and checked, with the particles it asks for.
struct Prepared {
    Scene scene;
    ParticleSet particles;
    Origin origin;
};

/// Scene to particles, of its geometry or of the file named. Throws InputError.
[[nodiscard]] Prepared prepare(const SceneChoice& choice);
/// The same under mpirun of a scene that every rank has read: the first rank makes the particles, or reads them from
/// the file that was chosen, all have them; their origin is known to the first rank only.
[[nodiscard]] Prepared prepare(Scene scene, const SceneChoice& choice, const Ranks& ranks);

/// Threads to use: as asked for on the command line, else as the scene says (0: all the machine has).
[[nodiscard]] int threads_for(const Scene& scene, int asked);

/// What the files of a run say about it.
[[nodiscard]] RunLabel label_of(const Scene& scene);

/// Title, file and particles of a scene, as every command opens with them.
[[nodiscard]] std::string heading(const Prepared& prepared);

/// Throws InputError when an MPI launcher started several of us: each would do the same work over again.
void refuse_several_ranks();

}  // namespace dmp::cli
