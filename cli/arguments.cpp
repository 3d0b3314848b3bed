// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "cli/shared_options.hpp"
#include "cli/version.hpp"

namespace dmp::cli {

namespace {

/// The name to show in help: as dmp was called when that is short enough to be typed again, else "dmp".
std::string shown_name(const std::string& called_as) {
    const bool relative = called_as.starts_with("./") || called_as.starts_with("../");
    return relative ? called_as : "dmp";
}

std::string version_text() {
    const BuildFacts facts = build_facts();
    return "dmp " + facts.version +
           "\nDiscrete Multi-Physics, from a geometry to a simulated valve.\n"
           "Copyright the dmp developers. Licence: GPL-3.0-or-later. There is no warranty.\n";
}

/// `line` for each example, with the program's name put in.
std::string examples(const std::string& program, std::initializer_list<const char*> lines) {
    std::string text = "Examples:";
    for (const char* line : lines) text += "\n  " + program + " " + line;
    return text;
}

/// CLI11's parser with dmp's commands, and the values it fills.
class Parser {
  public:
    explicit Parser(const std::string& program) : program_(program), app_("", program) {
        app_.description(
            "dmp turns a geometry and one scene file into particles, runs Discrete Multi-Physics on them\n"
            "(SPH fluid, elastic solids) and leaves ParaView files, tables and pictures.");
        app_.footer(examples(program, {"run cases/vein_valve", "run cases/vein_valve --dry-run",
                                       "run cases/vein_valve --until \"0.5 s\" --set particles.spacing=\"0.4 mm\"",
                                       "explain particles.spacing"}) +
                    "\n\n'" + program + " COMMAND --help' tells more about a command.\n" +
                    "Exit codes: 0 done, 2 bad input, 3 the simulation diverged, 4 out of disk or memory, 5 at its "
                    "wall-time limit,\n"
                    "129 and more: stopped by a signal.");
        app_.set_version_flag("--version", version_text, "Print the version and end");
        app_.set_help_flag("-h,--help", "Print this help and end");
        app_.require_subcommand(0, 1);
        app_.get_formatter()->label("SUBCOMMAND", "COMMAND");
        app_.get_formatter()->label("OPTIONS", "OPTION...");
        app_.get_formatter()->column_width(26);
        add_run();
        add_sweep();
        add_trade();
        add_limits();
        add_mesh();
        add_inspect();
        add_new();
        add_convert();
        add_pictures();
        add_report();
        add_explain();
        add_escape();
        doctor_app_ = app_.add_subcommand("doctor", "Is this machine all right? What is slow, small or missing");
        for (CLI::App* command : app_.get_subcommands({})) command->group("Commands");
    }

    Command read(std::span<const char* const> argv) {
        if (argv.size() == 2 && std::string_view(argv[1]) == read_geometry_command) return ReadGeometryCommand{};
        if (argv.size() == 2 && std::string_view(argv[1]) == start_runs_command) return StartRunsCommand{};
        try {
            app_.parse(static_cast<int>(argv.size()), argv.data());
        } catch (const CLI::CallForHelp&) {
            return PrintCommand{help_of(chosen())};
        } catch (const CLI::CallForVersion&) {
            return PrintCommand{version_text()};
        } catch (const CLI::ExtrasError&) {
            throw_unknown(chosen());
        } catch (const CLI::ParseError& error) {
            throw InputError(plain(error), "'" + name_of(chosen()) + " --help' shows how it goes.");
        }
        run_.typed = sweep_.typed = trade_.typed = limits_.typed = mesh_.typed = inspect_.typed = new_.typed =
            TypedCommand({argv.begin(), argv.end()});
        if (*run_app_) return run_;
        if (*sweep_app_) return sweep_;
        if (*trade_app_) return trade_;
        if (*limits_app_) return limits_;
        if (*mesh_app_) return mesh_;
        if (*inspect_app_) return inspect_;
        if (*new_app_) return new_;
        if (*convert_app_) return convert_;
        if (*pictures_app_) return pictures_;
        if (*report_app_) return report_;
        if (*explain_app_) return explain_;
        if (*escape_app_) return finished(escape_);
        if (*doctor_app_) return DoctorCommand{};
        return PrintCommand{help_of(app_)};
    }

  private:
    void add_run() {
        run_app_ = app_.add_subcommand("run", "Run a scene: particles, simulation, ParaView files, tables, pictures");
        add_scene(*run_app_, run_.scene);
        run_app_->add_option("--out", run_.out, "Folder for the results; default: out/NAME OF THE SCENE")
            ->type_name("DIR");
        run_app_->add_option("--until", run_.until, "Stop at this time instead of the scene's duration, e.g. \"0.2 s\"")
            ->type_name("TIME");
        run_app_->add_option("--tolerance", run_.tolerance, "Take the cheapest setting for this error, by 'dmp trade'")
            ->type_name("ERROR");
        run_app_->add_option("--trade", run_.trade, "Folder of the trade for --tolerance; default: that of the scene")
            ->type_name("DIR");
        add_threads(*run_app_, run_.threads);
        add_vector_unit(*run_app_, run_.vector_unit);
        add_particles(*run_app_, run_.scene);
        add_reading(*run_app_, run_.scene.reading);
        add_frames(*run_app_, run_.frames);
        add_leave_out(*run_app_, run_.left_out);
        auto* resume =
            run_app_->add_flag("--resume", run_.resume, "Go on from the last checkpoint in the folder of the results");
        auto* from = run_app_
                         ->add_option("--from", run_.from,
                                      "Start from the state of another run of the scene: of its last checkpoint, or "
                                      "of that at or before a time; --set may change what drives it, viscosities, "
                                      "stiffness and the like")
                         ->type_name("DIR[@TIME]")
                         ->excludes(resume);
        run_app_
            ->add_flag("--overwrite", run_.overwrite,
                       "Remove the results that are in the folder, once nothing else keeps the run from starting")
            ->excludes(resume);
        run_app_
            ->add_option("--checkpoint-every", run_.checkpoint_every,
                         "Wall time between checkpoints; default: \"10 min\"; \"0 s\": only when stopped")
            ->type_name("TIME");
        run_app_
            ->add_option("--wall-limit", run_.wall_limit,
                         "Wall time after which to write a checkpoint and leave, e.g. \"11.5 h\"")
            ->type_name("TIME");
        run_app_
            ->add_flag("--dry-run", run_.dry_run,
                       "Only say what the run would take: particles, memory, time steps, measured time")
            ->excludes(from);
        run_app_
            ->add_option("--trial", run_.trial, "Wall time for which a dry run tries the scene out; default: \"1 s\"")
            ->type_name("TIME");
        run_app_->footer(examples(
            program_, {"run cases/vein_valve", "run cases/vein_valve --dry-run",
                       R"(run cases/vein_valve --out soft --set part.leaflets.bending_stiffness="1e-6 N*m^2")",
                       "run my_scene.toml --until \"0.2 s\" --threads 1", "run my_scene.toml --resume",
                       R"(run my_scene.toml --out soft --from "out/my_scene@1 s" --set contact.strength="1 uJ")",
                       "run my_scene.toml --particles my_scene.h5 --frames hdf5"}));
    }

    void add_trade() {
        trade_app_ = app_.add_subcommand("trade", "Costs and errors of a scene's spacings and quality levels");
        add_trade_options(*trade_app_, trade_);
        trade_app_->footer(examples(program_, {"trade cases/vein_valve --until \"1.2 s\" --budget \"20 min\"",
                                               "trade my_scene.toml --measures flow --tolerance \"2 %\"",
                                               "trade my_scene.toml --resume --reference out/finer",
                                               "trade my_scene.toml --slurm --partition long --time \"8 h\""}));
    }

    void add_limits() {
        limits_app_ =
            app_.add_subcommand("limits", "Where the models of a scene end: step, sound, stiffness and others");
        add_limits_options(*limits_app_, limits_);
        limits_app_->footer(examples(program_, {"limits cases/vein_valve --budget \"10 min\"",
                                                "limits my_scene.toml --dials numerics.step_factor viscosity",
                                                "limits my_scene.toml --resume --budget \"1 h\""}));
    }

    void add_sweep() {
        sweep_app_ = app_.add_subcommand("sweep", "Run a study: one scene with many values, and a table of results");
        sweep_app_->add_option("STUDY", sweep_.study, "A study file, or a folder with a study.toml (docs/studies.md)")
            ->required()
            ->type_name("");
        add_set(*sweep_app_, sweep_.overrides);
        sweep_app_->add_option("--out", sweep_.out, "Folder for the runs; default: out/NAME OF THE STUDY")
            ->type_name("DIR");
        sweep_app_->add_option("--jobs", sweep_.jobs, "Runs at a time; default: as many as there are processors for")
            ->type_name("N")
            ->check(CLI::Validator(at_least_one, ""));
        sweep_app_->add_option("--only", sweep_.only, "Only the runs that have this value; may be given several times")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        auto* resume = sweep_app_->add_flag("--resume", sweep_.resume, "Go on with the study in the folder");
        sweep_app_->add_flag("--overwrite", sweep_.overwrite, "Remove the study that is in the folder")
            ->excludes(resume);
        sweep_app_->add_flag("--dry-run", sweep_.dry_run, "Only say which runs there are, and what they would take");
        add_slurm(*sweep_app_, sweep_.slurm, sweep_.slurm_options)
            ->excludes(sweep_app_
                           ->add_option("--run", sweep_.runs,
                                        "Do these runs only, by name or number: what a job of a queueing system does")
                           ->type_name("RUN"));
        sweep_app_
            ->add_option_function<std::string>(
                "--launcher",
                [this](const std::string& text) {
                    sweep_.slurm_options.launcher = text == "srun" ? study::Launcher::srun : study::Launcher::mpirun;
                },
                "What starts the ranks of --run, mpirun or srun; default: mpirun")
            ->type_name("NAME")
            ->check(CLI::IsMember({"mpirun", "srun"}));
        sweep_app_->footer(
            examples(program_, {"sweep cases/vein_valve", "sweep cases/vein_valve --dry-run",
                                "sweep my_study.toml --jobs 4 --out out/soft", "sweep my_study.toml --resume",
                                "sweep my_study.toml --slurm --partition long --time \"8 h\""}));
    }

    void add_mesh() {
        mesh_app_ = app_.add_subcommand("mesh", "Make the particles only, with a quality report and a file to look at");
        add_scene(*mesh_app_, mesh_.scene);
        mesh_app_->add_option("--out", mesh_.out, "Folder for the particles; default: out/NAME OF THE SCENE_mesh")
            ->type_name("DIR");
        mesh_app_
            ->add_option("--particles", mesh_.particles,
                         "Also write them into a file for 'run --particles', e.g. on a "
                         "cluster")
            ->type_name("FILE");
        add_reading(*mesh_app_, mesh_.scene.reading);
        mesh_app_->add_flag("--settle", mesh_.rest_test,
                            "Run the particles for 500 steps with nothing that drives them: none may leave");
        mesh_app_->footer(
            examples(program_, {"mesh cases/vein_valve", "mesh cases/vein_valve --set particles.spacing=\"0.1 mm\"",
                                "mesh cases/vein_valve --particles valve.h5"}));
    }

    void add_inspect() {
        inspect_app_ = app_.add_subcommand("inspect", "What a geometry holds: parts, sizes, unit, closed or not");
        inspect_app_->add_option("FILE", inspect_.file, "A CAD file, a mesh or a gmsh script (docs/cad.md)")
            ->required()
            ->type_name("");
        add_unit(*inspect_app_, inspect_.unit);
        add_reading(*inspect_app_, inspect_.reading);
        inspect_app_->add_flag("--json", inspect_.json, "Say it in JSON, for programs");
        inspect_app_
            ->add_option("--bad-triangles", inspect_.bad_triangles,
                         "Write the triangles at the open edges of surfaces that make no solid, for ParaView (.vtp)")
            ->type_name("FILE");
        inspect_app_->footer(
            examples(program_, {"inspect stent.step", "inspect artery.stl --unit mm", "inspect valve.geo --json",
                                "inspect artery.stl --bad-triangles open.vtp"}));
    }

    void add_new() {
        new_app_ = app_.add_subcommand("new", "Make a first scene for a geometry, which runs");
        new_app_->add_option("NAME", new_.folder, "The folder to make, for the scene and the geometry")
            ->required()
            ->type_name("");
        new_app_->add_option("--from", new_.cad_geometry, "The geometry: any file that 'inspect' reads")
            ->required()
            ->type_name("FILE");
        add_unit(*new_app_, new_.unit);
        add_reading(*new_app_, new_.reading);
        new_app_->footer(examples(program_, {"new my_pipe --from pipe.step", "new my_pipe --from pipe.stl --unit mm"}));
    }

    void add_convert() {
        convert_app_ = app_.add_subcommand("convert", "Make ParaView's files of the HDF5 frames that a run left");
        convert_app_
            ->add_option("DIR", convert_.folder, "The run's folder, the one with frames/ in it; the files go there")
            ->required()
            ->type_name("");
        convert_app_->footer(examples(program_, {"convert out/vein_valve"}));
    }

    void add_pictures() {
        pictures_app_ = app_.add_subcommand("pictures", "Draw the pictures of a run again, or a film of it");
        pictures_app_->add_option("DIR", pictures_.folder, "The run's folder; the pictures go there")
            ->required()
            ->type_name("");
        add_set(*pictures_app_, pictures_.overrides);
        pictures_app_->add_flag("--film", pictures_.film, "Also film.png, an animated PNG, which browsers show");
        pictures_app_->footer(examples(program_, {"pictures out/vein_valve", "pictures out/vein_valve --film",
                                                  "pictures out/vein_valve --set output.picture_field=pressure"}));
    }

    void add_report() {
        report_app_ =
            app_.add_subcommand("report", "Write the page of a run or of a study again: report.html, for any browser");
        report_app_->add_option("DIR", report_.folder, "The folder of the run or of the study; the page goes there")
            ->required()
            ->type_name("");
        report_app_->footer(examples(program_, {"report out/vein_valve", "report out/vein_valve_study"}));
    }

    void add_explain() {
        explain_app_ = app_.add_subcommand("explain", "What a scene will run and why, or what a key of a scene means");
        explain_app_
            ->add_option("SCENE|KEY", explain_.subject.path, "A scene file, a folder with a scene.toml, or a key")
            ->required()
            ->type_name("");
        add_set(*explain_app_, explain_.subject.overrides);
        add_threads(*explain_app_, explain_.threads);
        add_particles(*explain_app_, explain_.subject);
        add_reading(*explain_app_, explain_.subject.reading);
        explain_app_->add_flag("!--no-measure", explain_.measure,
                               "Do not time the scene's first steps, which takes up to two seconds");
        explain_app_->footer(
            examples(program_, {"explain cases/vein_valve", "explain particles.spacing", "explain numerics.support"}));
    }

    void add_escape() {
        escape_app_ =
            app_.add_subcommand("escape", "How many particles a carrier loses when it hits a wall: a simple model");
        const auto add = [&](const char* name, auto& value, const char* meaning, const char* type) {
            return escape_app_->add_option(name, value, meaning)->type_name(type)->capture_default_str();
        };
        escape_app_->add_option("--out", escape_.out, "CSV file to write; default: print it")->type_name("FILE");
        escape_app_->add_flag("--printed", escape_.printed, "The model as it was printed, instead of corrected");
        escape_app_->add_flag("--thesis-stiffness", escape_.thesis_stiffness,
                              "Stiffness 2 E / (1 - nu^2) of the particle, instead of Hertz' of both materials");
        add("--speed", escape_.speeds, "Speed of the carrier; may be given several times; default: 1 to 20 m/s",
            "SPEED")
            ->allow_extra_args(false);
        add("--angle", escape_.angles,
            "Angle between its path and the wall; may be given several times; default: 5 to 90 deg in eight steps",
            "ANGLE")
            ->allow_extra_args(false);
        add("--friction", escape_.friction, "Coefficient of friction; may be given several times", "MU")
            ->allow_extra_args(false);
        add("--carrier-radius", escape_.carrier_radius, "Radius of the carrier", "LENGTH");
        add("--particle-radius", escape_.particle_radius, "Radius of the particles", "LENGTH");
        add("--particle-mass", escape_.particle_mass, "Mass of a particle", "MASS");
        add("--pull-off-force", escape_.pull_off_force, "Force that parts a particle from the carrier", "FORCE");
        add("--equilibrium-distance", escape_.equilibrium_distance, "z0 of Bradley's adhesion", "LENGTH");
        add("--cutoff", escape_.cutoff, "Range of the adhesion in the printed form", "LENGTH");
        add("--carrier-youngs-modulus", escape_.carrier_youngs_modulus, "Young's modulus of the carrier", "E");
        add("--particle-youngs-modulus", escape_.particle_youngs_modulus, "Young's modulus of the particles", "E");
        add("--carrier-poisson-ratio", escape_.carrier_poisson_ratio, "Poisson's ratio of the carrier", "NU");
        add("--particle-poisson-ratio", escape_.particle_poisson_ratio, "Poisson's ratio of the particles", "NU");
        escape_app_->footer(
            examples(program_, {"escape --out eta.csv", "escape --printed --friction 0.3 --speed \"5 m/s\"",
                                "escape --speed \"0.3 m/s\" --angle \"90 deg\" --pull-off-force \"3 nN\""}));
    }

    /// With the sweep of the paper where none was asked for.
    static EscapeCommand finished(EscapeCommand command) {
        if (command.speeds.empty())
            for (int v = 1; v <= 20; ++v) command.speeds.push_back(std::to_string(v) + " m/s");
        if (command.angles.empty())
            command.angles = {"5 deg", "10 deg", "20 deg", "30 deg", "45 deg", "60 deg", "75 deg", "90 deg"};
        return command;
    }

    /// The command given, or dmp itself.
    [[nodiscard]] const CLI::App& chosen() const {
        const auto given = app_.get_subcommands();
        return given.empty() ? app_ : *given.front();
    }

    [[nodiscard]] std::string name_of(const CLI::App& app) const {
        return &app == &app_ ? program_ : program_ + " " + app.get_name();
    }

    [[nodiscard]] std::string help_of(const CLI::App& app) const { return app.help(&app == &app_ ? "" : program_); }

    static std::string plain(const CLI::ParseError& error) {
        std::string text = error.what();
        if (text.starts_with("SCENE is required")) return "a scene is missing";
        if (text.starts_with("STUDY is required")) return "a study is missing";
        if (text.starts_with("DIR is required")) return "a folder is missing";
        if (text.starts_with("FILE is required")) return "a geometry is missing";
        if (text.starts_with("NAME is required")) return "a name for the new folder is missing";
        if (text.starts_with("SCENE|KEY is required")) return "a scene or a key is missing";
        return text;
    }

    [[noreturn]] void throw_unknown(const CLI::App& app) const {
        const std::string unknown = app_.remaining(true).front();
        const bool is_option = unknown.starts_with("-");
        const std::string word = is_option ? unknown.substr(0, unknown.find('=')) : unknown;
        std::vector<std::string> known;
        if (is_option) {
            for (const CLI::Option* option : app.get_options()) {
                for (const auto& name : option->get_lnames()) known.push_back("--" + name);
            }
        } else {
            for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
        }
        if (known.empty()) {
            throw InputError(
                "'" + name_of(app) + "' does not know what to do with '" + word + "'",
                "Does a value with a space lack its quotes? '" + name_of(app) + " --help' shows how it goes.");
        }
        const std::string nearest = nearest_name(word, known);
        const std::string hint =
            nearest.empty() ? "It knows " + quoted_list(known) + "." : "Did you mean '" + nearest + "'?";
        throw InputError((is_option ? "'" + name_of(app) + "' has no option '" : "there is no command '") + word + "'",
                         hint + " '" + name_of(app) + " --help' tells more.");
    }

    std::string program_;
    CLI::App app_;
    CLI::App* run_app_ = nullptr;
    CLI::App* sweep_app_ = nullptr;
    CLI::App* mesh_app_ = nullptr;
    CLI::App* inspect_app_ = nullptr;
    CLI::App* new_app_ = nullptr;
    CLI::App* convert_app_ = nullptr;
    CLI::App* pictures_app_ = nullptr;
    CLI::App* report_app_ = nullptr;
    CLI::App* explain_app_ = nullptr;
    CLI::App* escape_app_ = nullptr;
    CLI::App* doctor_app_ = nullptr;
    RunCommand run_;
    SweepCommand sweep_;
    CLI::App* trade_app_ = nullptr;
    TradeCommand trade_;
    CLI::App* limits_app_ = nullptr;
    LimitsCommand limits_;
    MeshCommand mesh_;
    InspectCommand inspect_;
    NewCommand new_;
    ConvertCommand convert_;
    PicturesCommand pictures_;
    ReportCommand report_;
    ExplainCommand explain_;
    EscapeCommand escape_;
};

}  // namespace

Command read_arguments(std::span<const char* const> argv) {
    return Parser(shown_name(argv.empty() ? "dmp" : argv.front())).read(argv);
}

}  // namespace dmp::cli
