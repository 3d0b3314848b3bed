// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_as_run.hpp"

#include <utility>

#include "scene/read_scene.hpp"
#include "scene/scene_difference.hpp"
#include "solver/run/setup.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// A file of the scene as it is found from `folder`: an absolute path stays one.
void refer_from(const fs::path& folder, const std::string& directory, Value<std::string>& file) {
    if (file->empty() || fs::path(*file).is_absolute()) return;
    file.value = fs::proximate(fs::path(directory) / *file, folder).string();
}

/// A unit that was not given may be one that the geometry's file states itself, which must not be given again.
std::string without_unit(std::string text) {
    const std::string line = "\nunit = ";
    const auto from = text.find(line, text.find("\n[geometry]\n"));
    if (from == std::string::npos || from > text.find("\n[", text.find("\n[geometry]\n") + 1)) return text;
    return text.erase(from, text.find('\n', from + 1) - from);
}

std::string text_in(const fs::path& folder, const Scene& written, Scene as_run) {
    refer_from(folder, as_run.directory, as_run.geometry.file);
    for (Part& part : as_run.parts) {
        refer_from(folder, as_run.directory, part.positions);
        refer_from(folder, as_run.directory, part.file);
    }
    const std::string text = with_values_of(resolved_scene(written), resolved_scene(as_run));
    return written.geometry.unit.given() ? text : without_unit(text);
}

}  // namespace

std::string scene_text_in(const fs::path& folder, const Scene& scene) { return text_in(folder, scene, scene); }

std::string scene_text_of_run(const fs::path& folder, const Scene& scene, const Plan& plan, const Resources& resources,
                              double until) {
    Scene as_run = scene;
    as_run.run.duration.value = until;
    if (*as_run.output.measure_every == 0) as_run.output.measure_every.value = as_run.output.every / 4;
    if (plan.sound.value > 0) as_run.numerics.sound_speed.value = plan.sound.value;
    if (plan.sound.value > 0 && *as_run.contact.strength == 0)
        as_run.contact.strength.value = pair_settings(as_run, resources).repulsion_strength;
    return text_in(folder, scene, std::move(as_run));
}

}  // namespace dmp::cli
