// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/prepare.hpp"

#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "cli/particle_input.hpp"
#include "cli/scene_name.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "cli/version.hpp"
#include "cli/workstation.hpp"
#include "scene/read_scene.hpp"
#include "solver/store/share_particles.hpp"

namespace dmp::cli {

namespace {

std::string particles_text(const ParticleSet& particles) {
    constexpr std::array kinds{PartKind::fluid, PartKind::rigid, PartKind::elastic, PartKind::spheres};
    constexpr std::array names{"fluid", "rigid", "elastic", "spheres"};
    std::string text;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const std::size_t count = particles.count(kinds.at(k));
        if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count_text(count), names.at(k));
    }
    if (particles.has_spheres()) return text;
    return fmt::format("{} ({}), {} apart", count_text(particles.size()), text, length_text(particles.spacing));
}

}  // namespace

Prepared prepare(const SceneChoice& choice) {
    return prepare(read_scene(choice.path, choice.overrides), choice, Ranks::alone());
}

Prepared prepare(Scene scene, const SceneChoice& choice, const Ranks& ranks) {
    ParticlesWithOrigin made;
    if (ranks.is_first())
        made = choice.particles.empty() ? particles_from_geometry(scene, choice.reading)
                                        : particles_from_file(choice.particles, scene);
    share_particles(made.particles, ranks);
    return {std::move(scene), std::move(made.particles), std::move(made.origin)};
}

int threads_for(const Scene& scene, int asked) { return asked > 0 ? asked : *scene.run.threads; }

RunLabel label_of(const Scene& scene) { return {scene.title, scene.hash, build_facts().version}; }

std::string heading(const Prepared& prepared) {
    const Scene& scene = prepared.scene;
    Listing facts;
    facts.add("scene", scene.file);
    if (!prepared.origin.file.empty()) facts.add(prepared.origin.what, prepared.origin.file);
    facts.add("particles", particles_text(prepared.particles));
    const std::string title = scene.title->empty() ? scene_name(scene) : *scene.title;
    return Style(Stream::output).strong(title) + "\n" + facts.text();
}

void refuse_several_ranks() {
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
        const char* ranks = std::getenv(variable);
        if (ranks != nullptr && std::atoi(ranks) > 1) {
            throw InputError(
                fmt::format("this command was started on {} MPI ranks, and only 'dmp run' makes use of them", ranks),
                "Start it without mpirun.");
        }
    }
}

}  // namespace dmp::cli
