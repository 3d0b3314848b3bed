// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/summary_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/length_text.hpp"
#include "base/shell_word.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "postproc/paraview_script.hpp"
#include "report/write_report.hpp"
#include "solver/output/frame_index.hpp"

namespace dmp::cli {

namespace {

std::string stages_text(const RunSummary& summary) {
    std::vector<std::pair<double, std::string>> stages;
    for (const auto& [stage, seconds] : summary.seconds_by_stage) stages.emplace_back(seconds, stage);
    std::ranges::sort(stages, std::greater());
    std::string text;
    for (std::size_t k = 0; k < std::min<std::size_t>(stages.size(), 4); ++k) {
        if (summary.wall_s <= 0) break;
        text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", stages[k].second,
                            100 * stages[k].first / summary.wall_s);
    }
    return text;
}

std::string density_text(const Scene& scene, const RunSummary& summary) {
    if (summary.density_low > summary.density_high) return "of no fluid: all of it turned solid";
    std::string text = fmt::format("{:.2f} to {:.2f} kg/m^3", summary.density_low, summary.density_high);
    const auto fluids = scene.parts_of(PartKind::fluid);
    if (fluids.size() == 1) {
        const double rest = fluids.front()->density;
        text += fmt::format(" ({} to {} of {:.4g})", percent_text(summary.density_low / rest - 1),
                            percent_text(summary.density_high / rest - 1), rest);
    }
    if (std::abs(summary.density_drift) >= 0.001)
        text += fmt::format("; a drift of the mean by {} was corrected", percent_text(summary.density_drift));
    return text;
}

std::string measures_text(const MeasureSeries& measures) {
    if (measures.rows.empty()) return "";
    Listing list(4);
    for (std::size_t k = 0; k < measures.names.size(); ++k) {
        double low = INFINITY;
        double high = -INFINITY;
        for (const auto& row : measures.rows) {
            if (!std::isfinite(row[k])) continue;
            low = std::min(low, row[k]);
            high = std::max(high, row[k]);
        }
        const std::string unit = measures.units[k] == "1" ? "" : " " + measures.units[k];
        list.add(measures.names[k],
                 low > high ? "no value at any time" : fmt::format("{:.4g} to {:.4g}{}", low, high, unit));
    }
    return measures.names.empty() ? "" : "  measures, smallest to largest\n" + list.text();
}

}  // namespace

std::string summary_text(const Scene& scene, const RunSummary& summary) {
    const Style style(Stream::output);
    Listing list;
    list.add("steps",
             fmt::format("{} of {} on average, ruled by {}", count_text(static_cast<std::size_t>(summary.steps)),
                         quantity_text(summary.simulated_s / static_cast<double>(std::max(1L, summary.steps)), "s"),
                         summary.ruling_limit));
    list.add("speed", fmt::format("{:.3g} million particle steps a second on {}", summary.particle_steps_per_s / 1e6,
                                  count_text(static_cast<std::size_t>(summary.threads), "thread")));
    if (const std::string stages = stages_text(summary); !stages.empty()) list.add("spent on", stages);
    if (summary.viscous_solves.solves > 0)
        list.add("viscosity",
                 fmt::format("{:.3g} iterations a step on average, {} at most",
                             summary.viscous_solves.mean_iterations(), summary.viscous_solves.most_iterations));
    for (const SpeciesBalance& species : summary.species)
        list.add(species.name,
                 fmt::format("{:.6g} {} at the start, {:.6g} from walls, {:.6g} taken up, {:.6g} at the end; {:.2g} of "
                             "it is unaccounted for",
                             species.start, species.unit, species.from_walls, species.taken_up, species.end,
                             species.residual()));
    if (summary.species_solves.solves > 0)
        list.add("diffusion",
                 fmt::format("{:.3g} iterations a solve on average, {} at most",
                             summary.species_solves.mean_iterations(), summary.species_solves.most_iterations));
    for (const Aggregate& of : summary.aggregates) {
        const std::string bonds = fmt::format("{} bonds made, {} broken", of.bonds_made, of.bonds_broken);
        list.add(of.name,
                 of.particles == 0
                     ? bonds  // a join, or a rule that bound nobody
                     : fmt::format("{} in {}, {}", count_text(static_cast<std::size_t>(of.particles), "particle"),
                                   count_text(static_cast<std::size_t>(of.pieces), "piece"), bonds));
    }
    const double mass_change = summary.start.mass > 0 ? summary.end.mass / summary.start.mass - 1 : 0;
    list.add("mass", fmt::format("{} kg moving, changed by {:.2g} of it", fmt::format("{:.6g}", summary.end.mass),
                                 mass_change));
    std::string momentum = fmt::format("{:.4g}, {:.4g}", summary.end.momentum[0], summary.end.momentum[1]);
    if (scene.dimension == 3) momentum += fmt::format(", {:.4g}", summary.end.momentum[2]);
    list.add("momentum", fmt::format("({}) kg m/s; {:.2g} of what the forces gave is unaccounted for", momentum,
                                     summary.momentum_residual));
    if (summary.spheres) {
        const SphereEnergy &start = summary.spheres->start, &end = summary.spheres->end;
        list.add("energy",
                 fmt::format("{:.4g} J at the start, {:.4g} J at the end: {:.4g} translation, {:.4g} rotation, "
                             "{:.4g} in contacts",
                             start.total(), end.total(), end.translation, end.rotation, end.contacts));
    }
    if (!scene.parts_of(PartKind::fluid).empty()) list.add("density", density_text(scene, summary));
    for (const LargestStrain& strain : summary.strains)
        list.add("strain", fmt::format("{} to {} in '{}'", percent_text(strain.compressed),
                                       percent_text(strain.stretched), strain.name));
    if (summary.contact)
        list.add("contact", fmt::format("surfaces up to {} in each other ({:.2g} spacings), at {:.4g} s",
                                        length_text(summary.contact->depth),
                                        summary.contact->depth / scene.particles.spacing, summary.contact->time));
    list.add("lost", count_text(summary.lost, "particle"));
    const std::string first = fmt::format("{}: {:.4g} s simulated in {}", summary.interrupted ? "Interrupted" : "Done",
                                          summary.simulated_s, duration_text(summary.wall_s));
    return (summary.interrupted ? style.warning(first) : style.good(first)) + "\n" + list.text() +
           measures_text(summary.measures);
}

std::string results_text(const std::filesystem::path& folder, const std::vector<std::string>& files) {
    Listing list;
    std::string pictures;
    std::string others;
    bool script = false, to_convert = false;
    for (const auto& file : files) {
        if (file == paraview_script_name) {
            script = true;
            continue;
        }
        if (file == report_file_name) continue;
        if (file == frame_index_name) to_convert = true;
        std::string& kind = file.ends_with(".png") ? pictures : others;
        kind += (kind.empty() ? "" : ", ") + file;
    }
    if (script) list.add("look", "paraview " + shell_word("--script=" + (folder / paraview_script_name).string()));
    if (to_convert)
        list.add("look", fmt::format("dmp convert {}   makes ParaView's files, where dmp has VTK",
                                     shell_word(folder.string())));
    if (std::ranges::find(files, report_file_name) != files.end())
        list.add("look", shell_word((folder / report_file_name).string()) + "   the page of the run, for a browser");
    if (!pictures.empty()) list.add("pictures", pictures);
    if (!others.empty()) list.add("files", others);
    return Style(Stream::output).strong("Results in " + folder.string()) + "\n" + list.text();
}

}  // namespace dmp::cli
