// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/tables.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/safe_file.hpp"

namespace dmp::postproc {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

void check(const MeasureSeries& measures) {
    const auto fits = [&](const std::vector<double>& row) { return row.size() == measures.names.size(); };
    if (measures.units.size() != measures.names.size() || measures.time.size() != measures.rows.size() ||
        !std::all_of(measures.rows.begin(), measures.rows.end(), fits))
        throw std::invalid_argument("measures: the numbers of names, units, times and values do not match");
}

double number_in(const std::string& cell, const SourceLocation& location) {
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size())
        throw InputError(location, "'" + cell + "' is not a number", "Restore the file or run the simulation again.");
    return value;
}

Json summary_of_measure(const MeasureSeries& measures, std::size_t column) {
    std::vector<double> finite;
    for (const auto& row : measures.rows)
        if (std::isfinite(row[column])) finite.push_back(row[column]);
    Json json{{"unit", measures.units[column]},
              {"last", nullptr},
              {"min", nullptr},
              {"max", nullptr},
              {"mean", nullptr},
              {"missing", measures.rows.size() - finite.size()}};
    if (finite.empty()) return json;
    json["last"] = measures.rows.back()[column];
    json["min"] = *std::min_element(finite.begin(), finite.end());
    json["max"] = *std::max_element(finite.begin(), finite.end());
    double sum = 0;
    for (const double value : finite) sum += value;
    json["mean"] = sum / static_cast<double>(finite.size());
    return json;
}

/// The rows from `first` on, a line each.
std::string rows_text(const MeasureSeries& measures, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < measures.rows.size(); ++i) {
        text += csv_number(measures.time[i]);
        for (const double value : measures.rows[i]) {
            text += ',' + csv_number(value);
        }
        text += '\n';
    }
    return text;
}

Json summary_of_measures(const MeasureSeries& measures) {
    check(measures);
    Json json = Json::object();
    for (std::size_t column = 0; column < measures.names.size(); ++column)
        json[measures.names[column]] = summary_of_measure(measures, column);
    return json;
}

Json conserved(const RunSummary& summary) {
    const auto state = [](const Conserved& c) { return Json{{"mass", c.mass}, {"momentum", c.momentum}}; };
    return {{"start", state(summary.start)},
            {"end", state(summary.end)},
            {"impulse_of_body_forces", summary.impulse_of_body_forces},
            {"impulse_of_fixed", summary.impulse_of_fixed},
            {"impulse_of_drag", summary.impulse_of_drag},
            {"momentum_residual", summary.momentum_residual}};
}

template <class Map>
Json object_of(const Map& values) {
    Json json = Json::object();
    for (const auto& [key, value] : values) json[key] = value;
    return json;
}

/// The first line.
std::string heading_of(const MeasureSeries& measures) {
    std::string text = "time [s]";
    for (std::size_t i = 0; i < measures.names.size(); ++i)
        text += "," + csv_cell(csv_heading(measures.names[i], measures.units[i]));
    return text + '\n';
}

}  // namespace

void write_measures_csv(const fs::path& folder, const MeasureSeries& measures, const std::string& name) {
    check(measures);
    make_folder(folder);
    write_file(folder / name, heading_of(measures) + rows_text(measures, 0));
}

std::string keep_other_measures(const fs::path& folder, const MeasureSeries& measures) {
    const fs::path table = folder / measures_file_name;
    if (!fs::exists(table) || read_file(table).starts_with(heading_of(measures))) return "";
    for (int number = 1;; ++number) {
        const std::string name = "measures_" + std::to_string(number) + ".csv";
        if (fs::exists(folder / name)) continue;
        rename_durably(table, folder / name);
        return name;
    }
}

void MeasuresFile::write(const MeasureSeries& measures) {
    if (!rows_) {
        write_measures_csv(folder_, measures, name_);
    } else if (measures.rows.size() > *rows_) {
        check(measures);
        append_to_file(folder_ / name_, rows_text(measures, *rows_));
    }
    rows_ = measures.rows.size();
}

MeasureSeries read_measures_csv(const fs::path& folder, const std::string& name) {
    SourceLocation location{(folder / name).string(), 1, 0};
    const std::string text = read_file(location.file);
    MeasureSeries measures;
    for (std::size_t start = 0; start < text.size(); ++location.line) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::vector<std::string> cells = csv_cells(std::string_view(text).substr(start, end - start));
        start = end + 1;
        if (location.line == 1) {
            for (std::size_t i = 1; i < cells.size(); ++i) {
                auto [column, unit] = name_and_unit(cells[i]);
                measures.names.push_back(std::move(column));
                measures.units.push_back(std::move(unit));
            }
            continue;
        }
        if (cells.size() != measures.names.size() + 1)
            throw InputError(location,
                             "found " + std::to_string(cells.size()) + " values, expected " +
                                 std::to_string(measures.names.size() + 1),
                             "Restore the file or run the simulation again.");
        measures.time.push_back(number_in(cells[0], location));
        std::vector<double>& row = measures.rows.emplace_back();
        for (std::size_t i = 1; i < cells.size(); ++i) row.push_back(number_in(cells[i], location));
    }
    return measures;
}

void write_summary(const fs::path& folder, const RunSummary& summary, const SummaryExtra& extra) {
    Json limits = Json::object();
    Json formulas = Json::object();
    for (const StepLimit& limit : summary.limits) {
        limits[limit.model] = limit.dt;
        formulas[limit.model] = limit.formula;
    }
    std::vector<std::string> warnings;  // each once
    const auto add = [&](const std::string& warning) {
        if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
    };
    for (const std::string& warning : extra.warnings) add(warning);
    for (const Warning& warning : summary.warnings) add(warning.text());
    Json json{{"title", extra.label.title},
              {"version", extra.label.version},
              {"scene_hash", extra.label.scene_hash},
              {"interrupted", summary.interrupted},
              {"warnings", warnings},
              {"particles", object_of(summary.particles)},
              {"steps", summary.steps},
              {"simulated_s", summary.simulated_s},
              {"wall_s", summary.wall_s},
              {"processor_s", summary.processor_s},
              {"particle_steps_per_s", summary.particle_steps_per_s},
              {"threads", summary.threads},
              {"ranks", summary.ranks},
              {"vector_unit", summary.vector_unit},
              {"rank_shares",
               {{"imbalance", summary.shares.imbalance},
                {"copies_per_owned", summary.shares.ghosts_per_owned},
                {"messages_per_step", summary.shares.messages_per_step},
                {"bytes_per_step", summary.shares.bytes_per_step}}},
              {"dt_limits", limits},
              {"dt_formulas", formulas},
              {"ruling_limit", summary.ruling_limit},
              {"sound_speed", summary.sound_speed},
              {"largest_speed", summary.largest_speed},
              {"density_low", summary.density_low},
              {"density_high", summary.density_high},
              {"density_drift", summary.density_drift},
              {"conserved", conserved(summary)},
              {"contact", summary.contact ? Json{{"deepest", summary.contact->depth},
                                                 {"time", summary.contact->time},
                                                 {"place", summary.contact->place}}
                                          : Json()},
              {"lost", summary.lost},
              {"measures", summary_of_measures(summary.measures)},
              {"state_hash", summary.state_hash},
              {"seconds_by_stage", object_of(summary.seconds_by_stage)},
              {"files", extra.files}};
    for (const auto& [name, value] : extra.chosen) json["chosen"].push_back({{"name", name}, {"value", value}});
    for (const ModelUse& use : extra.models)
        json["models"].push_back({{"model", use.model}, {"source", use.source}, {"why", use.reason}});
    for (const ReferenceDistance& from : extra.references)
        json["references"].push_back(
            {{"measure", from.measure},
             {"column", from.column},
             {"source", from.source},
             {"error", from.largest},
             {"distance",
              {{"whole", from.whole}, {"end", from.end}, {"peak", from.peak}, {"integral", from.integral}}}});
    if (const auto& start = extra.started_from)
        json["started_from"] = {{"checkpoint", start->checkpoint}, {"step", start->step}, {"time_s", start->time}};
    for (const ChamberDrift& chamber : summary.chambers)
        json["chambers"].push_back(
            {{"mass", chamber.mass}, {"density_drift", chamber.drift}, {"place", chamber.place}});
    if (summary.velocity_change) json["velocity_change_per_spacing"] = *summary.velocity_change;
    for (const LargestStrain& strain : summary.strains)
        json["strain_of_bonds"][strain.name] = {{"lowest", strain.compressed}, {"highest", strain.stretched}};
    const ViscousSolves& viscous = summary.viscous_solves;
    if (viscous.solves > 0)
        json["implicit_viscosity"] = {{"solves", viscous.solves},
                                      {"iterations_mean", viscous.mean_iterations()},
                                      {"iterations_most", viscous.most_iterations}};
    for (const SpeciesBalance& species : summary.species)
        json["species"][species.name] = {{"unit", species.unit},         {"start", species.start},
                                         {"end", species.end},           {"from_walls", species.from_walls},
                                         {"taken_up", species.taken_up}, {"residual", species.residual()}};
    const ViscousSolves& diffusion = summary.species_solves;
    if (diffusion.solves > 0)
        json["implicit_diffusion"] = {{"solves", diffusion.solves},
                                      {"iterations_mean", diffusion.mean_iterations()},
                                      {"iterations_most", diffusion.most_iterations}};
    if (summary.spheres) {
        const auto energy = [](const SphereEnergy& of) {
            return Json{{"translation", of.translation}, {"rotation", of.rotation}, {"contacts", of.contacts}};
        };
        json["energy"] = {{"start", energy(summary.spheres->start)}, {"end", energy(summary.spheres->end)}};
    }
    for (const Aggregate& of : summary.aggregates)
        json["aggregates"][of.name] = {{"particles", of.particles},   {"mass", of.mass},
                                       {"pieces", of.pieces},         {"largest", of.largest},
                                       {"bonds_made", of.bonds_made}, {"bonds_broken", of.bonds_broken}};
    make_folder(folder);
    write_file(folder / summary_file_name, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<RunEnd> read_run_end(const fs::path& folder) {
    std::ifstream file(folder / summary_file_name);
    const Json json = Json::parse(file, nullptr, false);
    if (!json.is_object() || !json.contains("interrupted") || !json["interrupted"].is_boolean()) return {};
    const auto number = [&](const char* key) {
        return json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0;
    };
    return RunEnd{json["interrupted"], number("simulated_s"), number("processor_s")};
}

}  // namespace dmp::postproc
