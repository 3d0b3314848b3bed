// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "scene/scene_difference.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::cli {

/// The state that a run is to start from.
struct StateChoice {
    std::filesystem::path folder;  ///< of the run that had it
    std::optional<double> time;    ///< [s]; none: its last
};

/// Of "DIR" or "DIR@TIME"; a folder whose name has an @ in it counts as a folder. Throws InputError.
[[nodiscard]] StateChoice read_state_choice(const std::string& text);

/// A state that was found.
struct StartingState {
    FoundCheckpoint checkpoint;
    std::vector<ValueDifference> changed;  ///< values of the scene that are others than the state's run had
};

/// The state from which a run of this scene to `until` [s] starts that goes into the folder `out`. Throws InputError if
/// there is none, or the scene cannot go on from it.
[[nodiscard]] StartingState starting_state(const StateChoice& choice, const Scene& scene,
                                           const std::filesystem::path& out, double until);

/// "Starting from the state of FILE, step 1234, t = 0.5 s: time goes on from there, to 1 s", and what is changed.
[[nodiscard]] std::string text_of(const StartingState& state, double until);

/// Throws InputError where a checkpoint's run had other particles than these, made now: their geometry has changed, or
/// what makes them.
void check_particles(const FoundCheckpoint& checkpoint, const ParticleSet& particles);

/// What to tell where another version of dmp wrote the checkpoint; "": the same one did, or one that did not say.
[[nodiscard]] std::string version_note(const FoundCheckpoint& checkpoint);

}  // namespace dmp::cli
