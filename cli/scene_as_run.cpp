// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_as_run.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "base/safe_file.hpp"
#include "cli/output_folder.hpp"
#include "cli/terminal.hpp"
#include "scene/read_scene.hpp"
#include "scene/scene_difference.hpp"
#include "solver/results/expected_steps.hpp"
#include "solver/run/setup.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// A file of the scene as it is found from `folder`: an absolute path stays one.
void refer_from(const fs::path& folder, const std::string& directory, Value<std::string>& file) {
    if (file->empty() || fs::path(*file).is_absolute()) return;
    file.value = fs::proximate(fs::path(directory) / *file, folder).string();
}

/// Where the line with this number begins, from 1 on.
std::size_t start_of_line(const std::string& text, int number) {
    std::size_t at = 0;
    for (int line = 1; line < number && at != std::string::npos; ++line) {
        at = text.find('\n', at);
        if (at != std::string::npos) ++at;
    }
    return at;
}

/// Makes comments of the lines that a scene may not have: reading the file names them, one at a time. Leaves the file
/// as it was where they are not defaults, so that the scene without them would be another.
void comment_out_what_may_not_be_given(const fs::path& file, const std::string& text, const Scene& as_run) {
    std::string changed = text;
    for (auto tries = std::ranges::count(text, '\n'); tries > 0; --tries) {
        write_file(file, changed);
        try {
            if (resolved_scene(read_scene(file.string())) != resolved_scene(as_run)) break;
            return;
        } catch (const InputError& error) {
            const SourceLocation& at = error.where();
            if (at.line == 0 || at.file != file.string()) break;
            const std::size_t start = start_of_line(changed, at.line);
            if (start == std::string::npos) break;
            if (changed.compare(start, 1, "#") == 0 || changed.compare(start, 1, "[") == 0) break;
            changed.insert(start, "# ");
        }
    }
    write_file(file, text);
}

/// A unit that was not given may be one that the geometry's file states itself, which must not be given again.
std::string without_unit(std::string text) {
    const auto table = text.find("\n[geometry]\n"), line = text.find("\nunit = ", table);
    if (line != std::string::npos) text.insert(line + 1, "# ");
    return text;
}

/// A line that is no value of the scene.
std::string remark_on(const StartedFrom& start) {
    std::string file = printable(start.checkpoint, false);
    std::ranges::replace(file, '\n', ' ');
    return fmt::format("## Started from the state of {}, step {}, {} s: dmp run --from\n", file, start.step,
                       number_text(start.time, 17));
}

void write(const fs::path& folder, const Scene& written, Scene as_run, const std::string& remark) {
    refer_from(folder, as_run.directory, as_run.geometry.file);
    for (Part& part : as_run.parts) {
        refer_from(folder, as_run.directory, part.positions);
        refer_from(folder, as_run.directory, part.file);
    }
    for (Reference& reference : as_run.references) refer_from(folder, as_run.directory, reference.file);
    const std::string text = remark + with_values_of(resolved_scene(written), resolved_scene(as_run));
    comment_out_what_may_not_be_given(folder / resolved_scene_name,
                                      written.geometry.unit.given() ? text : without_unit(text), as_run);
}

}  // namespace

void write_scene(const fs::path& folder, const Scene& scene) { write(folder, scene, scene, ""); }

void write_scene_of_run(const fs::path& folder, const Scene& scene, const Plan& plan, const Resources& resources,
                        double until, const std::optional<StartedFrom>& started_from) {
    Scene as_run = scene;
    as_run.run.duration.value = until;
    as_run.output.measure_every.value = time_between_rows(scene);
    if (plan.sound.value > 0) as_run.numerics.sound_speed.value = plan.sound.value;
    if (plan.sound.value > 0 && *as_run.contact.strength == 0)
        as_run.contact.strength.value = pair_settings(as_run, resources).repulsion_strength;
    write(folder, scene, std::move(as_run), started_from ? remark_on(*started_from) : "");
}

}  // namespace dmp::cli
