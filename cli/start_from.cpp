// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/start_from.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/version.hpp"
#include "particles/fingerprint.hpp"
#include "scene/read_scene.hpp"
#include "scene/start_from_state.hpp"
#include "solver/state/checkpoints.hpp"

namespace dmp::cli {

namespace fs = std::filesystem;

StateChoice read_state_choice(const std::string& text) {
    const auto at = text.rfind('@');
    if (at == std::string::npos || fs::is_directory(text)) return {text, {}};
    const SourceLocation location{"--from", 0, 0};
    const double time = read_quantity(text.substr(at + 1), "s", location);
    if (!(time >= 0))
        throw InputError(location, "'" + text.substr(at + 1) + "' is no time of a run",
                         "Give one from 0 on, e.g. --from \"out/valve@0.5 s\", or none for the last checkpoint.");
    return {text.substr(0, at), time};
}

StartingState starting_state(const StateChoice& choice, const Scene& scene, const fs::path& out, double until) {
    std::error_code not_there;
    if (fs::equivalent(choice.folder, out, not_there))
        throw InputError({choice.folder.string()}, "it is the folder that the results of this run go to",
                         "Give the new run another folder with --out, or go on with the old one by --resume.");
    StartingState state{checkpoint_to_start_from(choice.folder, choice.time, until), {}};
    const std::string& before = state.checkpoint.label.scene;
    if (const auto fixed = fixed_in_start(before, scene); !fixed.empty())
        throw InputError(
            {state.checkpoint.file.string()},
            "this scene cannot start from that state, for which these values must be the same:" + fixed_text(fixed),
            "Give them as they were, or run the scene from its beginning, without --from.");
    state.changed = differences(before, resolved_scene(scene));
    return state;
}

std::string text_of(const StartingState& state, double until) {
    const FoundCheckpoint& found = state.checkpoint;
    return fmt::format("Starting from the state of {}, step {}, t = {:.9g} s: time goes on from there, to {:.9g} s{}\n",
                       found.file.string(), found.step, found.time, until,
                       state.changed.empty() ? "" : ", with other values:" + differences_text(state.changed));
}

void check_particles(const FoundCheckpoint& checkpoint, const ParticleSet& particles) {
    const std::string& before = checkpoint.label.particles;
    if (before.empty() || before == fingerprint(particles)) return;
    const std::string version = version_note(checkpoint);
    throw InputError({checkpoint.file.string()},
                     "the particles of this run are others than those that this state belongs to: a file of the "
                     "geometry was changed, or its particles are made in another way now" +
                         (version.empty() ? "" : "\n" + version),
                     "Put the geometry back as it was (or give the particles that the run had, with --particles), or "
                     "start a new run.");
}

std::string version_note(const FoundCheckpoint& checkpoint) {
    const std::string now = build_facts().version, &before = checkpoint.label.dmp_version;
    if (before.empty() || before == now) return "";
    return "The checkpoint is of dmp " + before + ", and this is dmp " + now +
           ": what follows may differ in its last digits from what that one would have given, or by what was changed "
           "(CHANGELOG.md).";
}

}  // namespace dmp::cli
