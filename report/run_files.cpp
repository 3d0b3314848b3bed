// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/run_files.hpp"

#include <algorithm>
#include <array>
#include <regex>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "postproc/paraview_script.hpp"
#include "postproc/pictures.hpp"
#include "postproc/tables.hpp"
#include "report/hdf5_frames.hpp"
#include "report/particle_section.hpp"
#include "solver/output/frame_index.hpp"

namespace dmp::report {

namespace {

namespace fs = std::filesystem;

constexpr const char* run_log_file = "run.log";
constexpr const char* resolved_scene_file = "scene.resolved.toml";
constexpr std::size_t most_log_bytes = 100'000;

/// The file's text; without the file none, and a note of what the page lacks.
std::string text_of(const fs::path& file, const std::string& lacks, std::vector<std::string>& notes) {
    if (fs::is_regular_file(file)) return read_file(file);
    notes.push_back(file.filename().string() + " is not in the folder: " + lacks);
    return "";
}

void read_pictures(RunFiles& run) {
    std::vector<std::string> names;
    for (const JsonValue& file : run.facts()["files"].elements())
        if (const std::string name = file.text(); name.ends_with(".png") && fs::path(name) == fs::path(name).filename())
            names.push_back(name);
    if (fs::is_regular_file(run.folder / film_file_name) && std::ranges::find(names, film_file_name) == names.end())
        names.emplace_back(film_file_name);
    std::size_t bytes = 0;
    for (const std::string& name : names) {
        const fs::path file = run.folder / name;
        if (!fs::is_regular_file(file)) {
            run.notes.push_back(name + " is not in the folder");
        } else if (bytes + fs::file_size(file) > most_picture_bytes) {
            run.notes.push_back(
                fmt::format("{} ({:.1f} MB) is left out, as the pictures of a page are limited to {} MB", name,
                            static_cast<double>(fs::file_size(file)) / 1e6, most_picture_bytes / 1'000'000));
        } else if (auto found = read_picture(file)) {
            bytes += found->bytes.size();
            run.pictures.push_back(std::move(*found));
        } else {
            run.notes.push_back(name + " is not a whole PNG file and is left out");
        }
    }
}

void read_measures(RunFiles& run) {
    const fs::path file = run.folder / measures_file_name;
    if (!fs::is_regular_file(file)) {
        if (!run.facts()["measures"].members().empty())
            run.notes.push_back(std::string(measures_file_name) +
                                " is not in the folder: the measures over time are missing");
        return;
    }
    MeasureSeries series;
    try {
        series = read_measures_csv(run.folder);
    } catch (const InputError& error) {
        if (!run.has_no_end()) throw;
        run.notes.push_back("measures.csv is damaged: " + error.problem());  // a killed run may leave half a line
        return;
    }
    if (series.names.empty())
        throw InputError(SourceLocation{file.string(), 1, 0}, "no heading with the names of measures",
                         "Restore the file or run the simulation again.");
    run.measures = std::move(series);
}

/// A run without them has none; damaged ones are left out.
void read_references(RunFiles& run) {
    if (!run.measures || !fs::is_regular_file(run.folder / references_file_name)) return;
    try {
        run.references = read_measures_csv(run.folder, references_file_name);
    } catch (const InputError& error) {
        run.notes.push_back(fmt::format("{} is damaged: {}", references_file_name, error.problem()));
    }
}

bool has_paraview_frames(const fs::path& folder) {
    return std::ranges::any_of(std::array{"fluid.pvd", "solid.pvd", "spheres.pvd"},
                               [&](const char* name) { return fs::is_regular_file(folder / name); });
}

/// The frames that the run has left; null where there are none, or none that can be read, with a note.
std::unique_ptr<FrameSource> open_frames(RunFiles& run, const OpenParaviewFrames& open_paraview) {
    try {
        if (fs::is_regular_file(run.folder / frame_index_name)) return std::make_unique<Hdf5Frames>(run.folder);
        if (!has_paraview_frames(run.folder)) return nullptr;
        auto found = open_paraview(run.folder);
        if (!found)
            run.notes.emplace_back(
                "the particles are left out: the frames are ParaView files, and this dmp was built for clusters, "
                "without VTK; dmp "
                "report on a workstation shows them");
        return found;
    } catch (const InputError& error) {
        run.notes.push_back("the particles are left out: " + error.problem() + " (" + error.where().text() + ")");
        return nullptr;
    }
}

void read_particles(RunFiles& run, const OpenParaviewFrames& open_paraview) {
    const auto frames = open_frames(run, open_paraview);
    if (!frames) return;
    run.frames = static_cast<long>(frames->times().size());
    run.particles = read_shown_particles(*frames, bytes_for_particles(run));
    run.notes.insert(run.notes.end(), run.particles.notes.begin(), run.particles.notes.end());
}

}  // namespace

LoggedRun logged_run(std::string_view text) {
    static const std::regex start(R"((\d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC)  dmp (\S+))");
    constexpr std::string_view error = "error: ", more = "  ";
    LoggedRun result;
    bool started = false;
    std::string* goes_on = nullptr;  // what an indented line belongs to
    while (!text.empty()) {
        const std::string line(text.substr(0, text.find('\n')));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        std::smatch match;
        if (goes_on != nullptr && line.starts_with(more)) {
            *goes_on += "\n" + line.substr(more.size());
            continue;
        }
        goes_on = nullptr;
        if (started) {
            result.starts.back().command = line;
            started = false;
        } else if (std::regex_match(line, match, start)) {
            result.starts.push_back({match[1], match[2], ""});
            result.error.clear();
            started = true;
        } else if (line.starts_with("warning: ") || line.starts_with("warning at ")) {
            goes_on = &result.warnings.emplace_back(line.substr(line[7] == ':' ? 9 : 8));
        } else if (line.starts_with(error)) {
            result.error = line.substr(error.size());
            goes_on = &result.error;
        }
    }
    std::vector<std::string> once;
    for (std::string& warning : result.warnings)
        if (std::ranges::find(once, warning) == once.end()) once.push_back(std::move(warning));
    result.warnings = std::move(once);
    return result;
}

JsonValue RunFiles::facts() const { return {&summary, folder / summary_file_name}; }

RunFiles read_run_files(const fs::path& folder, const OpenParaviewFrames& open_paraview) {
    const SourceLocation where{folder.string(), 0, 0};
    if (!fs::is_directory(folder))
        throw InputError(where, "there is no such folder", "Name the folder that a run left, e.g. out/vein_valve.");
    const bool ended = fs::is_regular_file(folder / summary_file_name);
    if (!ended && !(fs::is_regular_file(folder / run_log_file) && fs::is_regular_file(folder / resolved_scene_file)))
        throw InputError(where,
                         fmt::format("there is no {} in it, and no {} with a {} of a run that was ended before",
                                     summary_file_name, run_log_file, resolved_scene_file),
                         "Name the folder that a run or a study left, e.g. out/vein_valve.");
    RunFiles run;
    run.folder = folder;
    run.summary = ended ? read_json_object(folder / summary_file_name) : JsonValue::Json::object();
    const std::string log =
        text_of(folder / run_log_file, "when and with which command it ran is not known", run.notes);
    run.log = logged_run(log);
    if (run.has_no_end()) run.log_text = log.size() > most_log_bytes ? log.substr(log.size() - most_log_bytes) : log;
    run.resolved_scene = text_of(folder / resolved_scene_file, "the scene as it was run is missing", run.notes);
    read_measures(run);
    read_references(run);
    read_pictures(run);
    read_particles(run, open_paraview);
    run.has_paraview_script = fs::is_regular_file(folder / paraview_script_name);
    return run;
}

}  // namespace dmp::report
