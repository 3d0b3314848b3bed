// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shared_options.hpp"

#include "cli/version.hpp"

namespace dmp::cli {

namespace {

/// What is wrong with the name of a format; empty: nothing.
std::string a_frame_format(const std::string& text) {
    if (text != "vtk" && text != "hdf5") return "'" + text + "' is no format of frames; there are 'vtk' and 'hdf5'";
    return text == "vtk" && build_facts().libraries.empty()
               ? "this dmp was built for clusters, without VTK; leave it out for frames in HDF5"
               : "";
}

std::optional<VectorUnit> vector_unit_called(const std::string& text) {
    for (const VectorUnit unit : {VectorUnit::avx2, VectorUnit::avx512}) {
        if (to_string(unit) == text) return unit;
    }
    return std::nullopt;
}

/// What is wrong with the name of a vector unit; empty: nothing.
std::string a_vector_unit(const std::string& text) {
    return vector_unit_called(text) ? "" : "'" + text + "' is no vector unit; there are 'avx2' and 'avx512'";
}

/// What is wrong with the name of an output.
std::string an_output(const std::string& text) {
    return study::run_output_called(text)
               ? ""
               : "'" + text + "' is nothing to leave out; there are 'frames', 'pictures', 'page' and 'checkpoint'";
}

}  // namespace

std::string at_least_one(const std::string& text) {
    const bool digits = !text.empty() && text.size() < 6 && text.find_first_not_of("0123456789") == std::string::npos;
    return digits && std::stoi(text) > 0 ? "" : "'" + text + "' is not a whole number from 1 on";
}

void add_unit(CLI::App& app, std::string& unit) {
    app.add_option("--unit", unit, "Length of one unit of the geometry, e.g. mm, where the file does not say it")
        ->type_name("LENGTH");
}

void add_scene(CLI::App& app, SceneChoice& scene) {
    app.add_option("SCENE", scene.path, "A scene file, or a folder with a scene.toml")->required()->type_name("");
    add_set(app, scene.overrides);
}

void add_reading(CLI::App& app, GeometryReading& reading) {
    app.add_flag("--trust-geometry", reading.trusted,
                 "Let the geometry's gmsh script do all it says as you: run programs, read and write files");
    app.add_option("--geometry-time", reading.time,
                   "The most time that reading the geometry may take; default: \"10 min\"")
        ->type_name("TIME");
}

void add_set(CLI::App& app, std::vector<std::string>& overrides) {
    app.add_option("--set", overrides, "Change a value of the scene; may be given several times")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void add_threads(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "Threads to run on; default: run.threads of the scene, else all there are")
        ->type_name("N")
        ->check(CLI::Validator(at_least_one, ""));
}

void add_particles(CLI::App& app, SceneChoice& scene) {
    app.add_option("--particles", scene.particles,
                   "File of 'mesh --particles' to take them from, instead of making them of the geometry")
        ->type_name("FILE");
}

void add_frames(CLI::App& app, std::optional<FrameFormat>& format) {
    const std::string otherwise = build_facts().libraries.empty() ? "hdf5" : "vtk";
    app.add_option_function<std::string>(
           "--frames",
           [&format](const std::string& text) { format = text == "vtk" ? FrameFormat::vtk : FrameFormat::hdf5; },
           "Write frames for ParaView, vtk, or for 'convert', hdf5; default: " + otherwise)
        ->type_name("FORMAT")
        ->check(CLI::Validator(a_frame_format, ""));
}

void add_leave_out(CLI::App& app, study::LeftOut& left_out) {
    const auto add = [&left_out](const std::vector<std::string>& names) {
        for (const std::string& name : names) left_out.insert(*study::run_output_called(name));
    };
    app.add_option_function<std::vector<std::string>>(
           "--leave-out", add,
           "Do not write frames, pictures, page or the checkpoint of a run that is done; may be a list")
        ->type_name("WHAT,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::Validator(an_output, ""));
}

void add_vector_unit(CLI::App& app, VectorUnit& unit) {
    const auto choose = [&unit](const std::string& text) { unit = *vector_unit_called(text); };
    app.add_option_function<std::string>("--vector-unit", choose,
                                         "Vector instructions to use, avx2 or avx512; default: the widest there are")
        ->type_name("UNIT")
        ->check(CLI::Validator(a_vector_unit, ""));
}

CLI::Option* add_slurm(CLI::App& app, bool& slurm, SlurmOptions& options) {
    CLI::Option* chosen = app.add_flag("--slurm", slurm, "In jobs of Slurm, instead of on this machine");
    const auto add = [&app](const char* name, std::string& value, const char* meaning, const char* type) {
        app.add_option(name, value, meaning)->type_name(type);
    };
    add("--partition", options.partition, "Of Slurm; default: as [slurm] of the study says, like those below", "NAME");
    add("--account", options.account, "That Slurm charges", "NAME");
    add("--time", options.time, "Limit of a job, e.g. \"2 h\"; a run that takes longer goes on in another one", "TIME");
    add("--job-template", options.form, "A job script of your own (docs/studies.md)", "FILE");
    for (const auto& [name, value, meaning] :
         {std::tuple{"--ranks", &options.ranks, "MPI ranks of a run in a job"},
          std::tuple{"--threads", &options.threads, "Threads of each rank of a run in a job"}})
        app.add_option(name, *value, meaning)->type_name("N")->check(CLI::Validator(at_least_one, ""));
    return chosen;
}

void add_trade_options(CLI::App& app, TradeCommand& trade) {
    app.add_option("SCENE", trade.scene, "A scene file, or a folder with a scene.toml")->required()->type_name("");
    add_set(app, trade.overrides);
    app.add_option("--out", trade.out, "Folder for the runs; default: out/NAME OF THE SCENE_trade")->type_name("DIR");
    app.add_option("--until", trade.until, "Run to this time instead of the scene's duration, e.g. \"0.2 s\"")
        ->type_name("TIME");
    app.add_option("--measures", trade.measures, "Names of the measures that count; default: all of the scene")
        ->type_name("NAME");
    app.add_option("--reference", trade.reference,
                   "Compare with this finer run of the scene; default: with the finest of the trade")
        ->type_name("DIR");
    auto* budget = app.add_option("--budget", trade.budget, "Wall time that the runs may take in all, e.g. \"30 min\"")
                       ->type_name("TIME");
    app.add_option("--tolerance", trade.tolerances, "Error to find a setting for; default: \"1 %\" \"5 %\" \"10 %\"")
        ->type_name("ERROR");
    app.add_option("--jobs", trade.jobs, "Runs at a time; default: as many as there are processors for")
        ->type_name("N")
        ->check(CLI::Validator(at_least_one, ""));
    auto* resume = app.add_flag("--resume", trade.resume, "Go on with the trade in the folder");
    app.add_flag("--overwrite", trade.overwrite, "Remove the trade that is in the folder")->excludes(resume);
    app.add_flag("--dry-run", trade.dry_run, "Only say which settings there are, and what the cheapest would take");
    add_slurm(app, trade.slurm, trade.slurm_options)->excludes(budget);
}

void add_limits_options(CLI::App& app, LimitsCommand& limits) {
    app.add_option("SCENE", limits.scene, "A scene file, or a folder with a scene.toml")->required()->type_name("");
    add_set(app, limits.overrides);
    app.add_option("--out", limits.out, "Folder for the runs; default: out/NAME OF THE SCENE_limits")->type_name("DIR");
    app.add_option("--until", limits.until, "Run to this time, e.g. \"0.2 s\"; default: what takes some seconds")
        ->type_name("TIME");
    app.add_option("--dials", limits.dials, "Keys to vary, e.g. numerics.step_factor; default: all that dmp knows of")
        ->type_name("KEY");
    app.add_option("--budget", limits.budget, "Wall time that the runs may take in all, e.g. \"10 min\"")
        ->type_name("TIME");
    app.add_option("--tolerance", limits.tolerance, "By how much a measure may deviate; default: \"5 %\"")
        ->type_name("ERROR");
    app.add_option("--jobs", limits.jobs, "Runs at a time; default: as many as there are processors for")
        ->type_name("N")
        ->check(CLI::Validator(at_least_one, ""));
    auto* resume = app.add_flag("--resume", limits.resume, "Go on with the limits in the folder");
    app.add_flag("--overwrite", limits.overwrite, "Remove the limits that are in the folder")->excludes(resume);
    app.add_flag("--dry-run", limits.dry_run, "Only say which values are varied, and what their runs would take");
    app.add_flag("--slurm", limits.slurm, "Refused: each run depends on those before");
}

}  // namespace dmp::cli
