// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/run_page.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "report/conservation.hpp"
#include "report/embedded.hpp"
#include "report/html.hpp"
#include "report/page_frame.hpp"
#include "report/particle_data.hpp"
#include "report/particle_section.hpp"
#include "report/plots.hpp"

namespace dmp::report {

namespace {

using Items = std::vector<std::pair<std::string, std::string>>;

std::string title_of(const RunFiles& run) {
    const std::string title = run.facts()["title"].text();
    return title.empty() ? run.folder.lexically_normal().filename().string() : title;
}

/// summary.json's and those that the run said, each once.
std::vector<std::string> warnings_of(const RunFiles& run) {
    std::vector<std::string> warnings = run.log.warnings;
    for (const JsonValue& warning : run.facts()["warnings"].elements())
        if (std::ranges::find(warnings, warning.text()) == warnings.end()) warnings.push_back(warning.text());
    return warnings;
}

std::string version_of(const RunFiles& run) {
    if (run.has_no_end()) return run.log.starts.empty() ? "not known" : run.log.starts.back().version;
    return or_unknown(run.facts()["version"].text());
}

/// How far a run without a summary has come, as its measures tell.
std::string measured_until(const RunFiles& run) {
    if (!run.measures || run.measures->time.empty()) return "";
    return "; its measures end at " + number_text(run.measures->time.back(), "s");
}

/// A class of page.css, and what to say.
std::pair<std::string, std::string> state_of(const RunFiles& run) {
    const JsonValue facts = run.facts();
    if (!run.has_no_end()) {
        const std::string time = number_text(facts["simulated_s"].number(), "s simulated");
        if (facts["interrupted"].truth()) return {"interrupted", "Interrupted: stopped before its end, at " + time};
        return {"complete", "Complete: " + time};
    }
    if (!run.log.error.empty()) return {"failed", "Failed: ended by an error" + measured_until(run)};
    return {"interrupted", "Not complete: killed before its end, or it runs still" + measured_until(run)};
}

/// Of a run without a summary.
std::string how_it_failed(const RunFiles& run) {
    if (!run.has_no_end()) return "";
    if (run.log.error.empty())
        return "<p>It has left no summary. Where it has a checkpoint, the same command with --resume goes on from it; "
               "else "
               "--overwrite starts it again.</p>\n";
    return "<pre class=\"error\">" + escaped(run.log.error) + "</pre>\n";
}

std::string head(const RunFiles& run) {
    const JsonValue facts = run.facts();
    Items items{{"dmp version", version_of(run)},
                {"scene hash", or_unknown(facts["scene_hash"].text())},
                {"started", run.log.starts.empty() ? "not known" : run.log.starts.front().when}};
    for (std::size_t k = 1; k < run.log.starts.size(); ++k) items.emplace_back("resumed", run.log.starts[k].when);
    items.emplace_back("wall time", wall_time_text(facts["wall_s"].number()));
    items.emplace_back("folder", run.folder.lexically_normal().filename().string());
    const auto [kind, state] = state_of(run);
    return fmt::format("<header><h1>{}</h1>\n<p class=\"state {}\">{}</p>\n{}{}</header>\n", escaped(title_of(run)),
                       kind, escaped(state), how_it_failed(run), list(items));
}

std::string what_was_run(const RunFiles& run) {
    const JsonValue facts = run.facts();
    std::string particles;
    for (const auto& [kind, count] : facts["particles"].members())
        particles += fmt::format("{}{:.0f} {}", particles.empty() ? "" : ", ", count.number(), kind);
    std::string text = list({{"particles", or_unknown(particles)}});
    Items chosen;
    for (const JsonValue& line : facts["chosen"].elements())
        chosen.emplace_back(line["name"].text(), line["value"].text());
    text +=
        "<h3>Values in force</h3>\n<p>In parentheses: the key of the scene, and whether the scene gave the value or "
        "dmp chose it.</p>\n";
    text += chosen.empty() ? "<p>Not kept in summary.json by the dmp that ran this.</p>\n" : list(chosen);
    std::vector<std::vector<std::string>> models;
    for (const JsonValue& model : facts["models"].elements())
        models.push_back({model["model"].text(), model["why"].text(), model["source"].text()});
    if (!models.empty()) text += "<h3>Models</h3>\n" + table("Models that ran", {"model", "why", "source"}, models, 3);
    return section("what", "What was run", text);
}

std::string alternative_text(const std::string& name) {
    if (name == "last_frame.png") return "The last frame";
    if (name == "cycle.png") return "Frames over the run, with one range of colours";
    if (name == "measures.png") return "The measures over time";
    if (name == "film.png") return "Film of the run";
    return name;
}

std::string image(const Picture& picture) {
    const std::string name = alternative_text(picture.name);
    return fmt::format("<figure>{}<figcaption>{}{}</figcaption></figure>\n", image_element(picture, name),
                       escaped(name), name == picture.name ? "" : " (" + escaped(picture.name) + ")");
}

/// The picture of the measures only stands in for the plots.
std::string pictures_section(const RunFiles& run) {
    std::string text, instead_of_plots;
    for (const Picture& picture : run.pictures)
        (picture.name == "measures.png" ? instead_of_plots : text) += image(picture);
    if (text.empty()) text = "<p>The run left no pictures.</p>\n";
    if (!instead_of_plots.empty()) text += "<noscript>" + instead_of_plots + "</noscript>\n";
    return section("pictures", "Pictures", "<div class=\"pictures\">\n" + text + "</div>\n");
}

std::string stages_table(const JsonValue& facts) {
    const double wall = facts["wall_s"].number();
    std::vector<std::pair<double, std::string>> stages;
    double sum = 0;
    for (const auto& [stage, seconds] : facts["seconds_by_stage"].members()) {
        if (!std::isfinite(seconds.number())) continue;
        stages.emplace_back(seconds.number(), stage);
        sum += seconds.number();
    }
    std::ranges::sort(stages, std::greater());
    if (!stages.empty() && wall > sum) stages.emplace_back(wall - sum, "everything else");
    std::vector<std::vector<std::string>> rows;
    for (const auto& [seconds, stage] : stages)
        rows.push_back(
            {stage, fmt::format("{:.3g}", seconds), wall > 0 ? fmt::format("{:.1f}", 100 * seconds / wall) : ""});
    return rows.empty() ? "" : table("Wall time by stage", {"stage", "time [s]", "share [%]"}, rows);
}

std::string limits_table(const JsonValue& facts) {
    const std::string ruling = facts["ruling_limit"].text();
    std::vector<std::vector<std::string>> rows;
    for (const auto& [model, dt] : facts["dt_limits"].members())
        rows.push_back({model + (model == ruling ? " (ruled the step)" : ""), number_text(dt.number()),
                        facts["dt_formulas"][model].text()});
    return rows.empty() ? "" : table("Largest time steps", {"limited by", "step [s]", "how it is found"}, rows, 3);
}

std::string time_section(const RunFiles& run) {
    const JsonValue facts = run.facts();
    const double steps = facts["steps"].number();
    Items items{{"steps", std::isfinite(steps)
                              ? fmt::format("{:.0f}, ruled by {}", steps, or_unknown(facts["ruling_limit"].text()))
                              : "not known"}};
    if (steps > 0) items.emplace_back("mean time step", number_text(facts["simulated_s"].number() / steps, "s"));
    items.emplace_back("speed", number_text(facts["particle_steps_per_s"].number(), "particle steps a second"));
    const double ranks = facts["ranks"].number(), threads = facts["threads"].number();
    items.emplace_back("ran on", fmt::format("{} {}{}, {}", number_text(threads), threads == 1 ? "thread" : "threads",
                                             ranks > 1 ? " on each of " + number_text(ranks) + " ranks" : "",
                                             or_unknown(facts["vector_unit"].text())));
    if (std::isfinite(facts["sound_speed"].number()) && facts["sound_speed"].number() > 0)
        items.emplace_back("speed of sound", number_text(facts["sound_speed"].number(), "m/s"));
    if (std::isfinite(facts["largest_speed"].number()))
        items.emplace_back("largest speed reached", number_text(facts["largest_speed"].number(), "m/s"));
    return section("time", "Time steps and time spent", list(items) + stages_table(facts) + limits_table(facts));
}

std::string reproduce_section(const RunFiles& run) {
    const JsonValue facts = run.facts();
    std::string text;
    for (const LoggedRun::Start& start : run.log.starts)
        text += fmt::format("<p>{}, dmp {}:</p>\n<pre><code>{}</code></pre>\n", escaped(start.when),
                            escaped(start.version), escaped(start.command));
    Items items{{"dmp version", version_of(run)},
                {"hash of the resolved scene", or_unknown(facts["scene_hash"].text())},
                {"hash of the final state", or_unknown(facts["state_hash"].text())}};
    if (const JsonValue from = facts["started_from"]; from.is_there())
        items.emplace_back("started from",
                           fmt::format("{}, step {}, t = {}", from["checkpoint"].text(),
                                       number_text(from["step"].number()), number_text(from["time_s"].number(), "s")));
    if (run.frames > 0) items.emplace_back("frames", std::to_string(run.frames));
    if (run.has_paraview_script)
        items.emplace_back("to look at the frames", "paraview --script=open_in_paraview.py, in the run's folder");
    text += list(items) +
            "<p>The same scene and version give the same final state, to the last bit, on any number of ranks and "
            "threads.</p>\n";
    if (!run.resolved_scene.empty())
        text += "<details><summary>The scene as it was run (scene.resolved.toml)</summary>\n<pre><code>" +
                escaped(run.resolved_scene) + "</code></pre></details>\n";
    return section("reproduce", "How to run it again", text);
}

/// Of a run that has left no summary there is nothing else to tell.
std::string sections_without_summary(const RunFiles& run) {
    return navigation({{"pictures", "Pictures"},
                       {"particles", "Particles"},
                       {"measures", "Measures"},
                       {"log", "What it said"},
                       {"reproduce", "How to run it again"}}) +
           pictures_section(run) + particle_section(run) + measures_section(run) +
           section("log", "What it said", "<pre><code>" + escaped(run.log_text) + "</code></pre>\n") +
           reproduce_section(run);
}

PageScripts scripts_of(const RunFiles& run) {
    PageScripts found;
    if (run.measures && !run.measures->rows.empty()) {
        found.data.emplace_back("page-data", plot_data(*run.measures, run.references));
        found.scripts.push_back(plotting_library());
        found.scripts.emplace_back(page_script);
    }
    if (!run.particles.times.empty() && !run.particles.groups.empty()) {
        found.data.emplace_back("particle-data", particle_data(run.particles));
        found.scripts.push_back(drawing_library());
        found.scripts.emplace_back(particle_script);
    }
    return found;
}

}  // namespace

std::string run_page(const RunFiles& run) {
    std::string text =
        head(run) + box("warnings", "Warnings", warnings_of(run)) + box("missing", "Not on this page", run.notes);
    if (run.has_no_end()) {
        text += sections_without_summary(run);
    } else {
        text += navigation({{"pictures", "Pictures"},
                            {"particles", "Particles"},
                            {"measures", "Measures"},
                            {"what", "What was run"},
                            {"conservation", "What was conserved"},
                            {"time", "Time"},
                            {"reproduce", "How to run it again"}});
        text += pictures_section(run) + particle_section(run) + measures_section(run) + what_was_run(run) +
                conservation_section(run) + time_section(run) + reproduce_section(run);
    }
    return page_text(title_of(run), text, scripts_of(run));
}

}  // namespace dmp::report
