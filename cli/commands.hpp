// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/typed_command.hpp"
#include "cli/uses.hpp"
#include "solver/parallel/resources.hpp"
#include "study/run_output.hpp"
#include "study/slurm.hpp"

namespace dmp::cli {

/// How a geometry is read, which no scene can say (docs/security.md).
struct GeometryReading {
    bool trusted = false;  ///< its script may do all that gmsh's scripts can
    std::string time;      ///< the most that it may take; empty: ten minutes
};

/// The scene a command works on and what --set changes in it.
struct SceneChoice {
    std::string path;                    ///< a scene file, or a folder with a scene.toml
    std::vector<std::string> overrides;  ///< "key=value", as given
    std::string particles;               ///< file to take them from; empty: they are made of the scene's geometry
    GeometryReading reading;             ///< of that
};

/// What a run's frames are written as.
enum class FrameFormat { vtk, hdf5 };

/// `dmp run`: everything from the scene to the pictures.
struct RunCommand {
    SceneChoice scene;
    std::string out;        ///< empty: out/NAME below the current folder
    std::string until;      ///< a time with its unit; empty: the scene's duration
    std::string tolerance;  ///< error to take the setting for from a trade of the scene; empty: as the scene says
    std::string trade;      ///< folder of that trade; empty: that of the scene
    int threads = 0;        ///< 0: as the scene says
    VectorUnit vector_unit = VectorUnit::widest;
    std::optional<FrameFormat> frames;  ///< none: vtk, or hdf5 where dmp was built without VTK
    study::LeftOut left_out;            ///< what it does not write
    bool dry_run = false;
    std::string trial;             ///< of a dry run: wall time with its unit; empty: a second
    bool resume = false;           ///< go on with the run in the folder
    std::string from;              ///< start from the state of the run in DIR or DIR@TIME; empty: from the beginning
    bool overwrite = false;        ///< remove what an earlier run has left in the folder
    std::string checkpoint_every;  ///< wall time with its unit; empty: ten minutes
    std::string wall_limit;        ///< wall time with its unit; empty: none
    TypedCommand typed;            ///< for lines to paste
};

/// `dmp mesh`: the particles and their quality report.
struct MeshCommand {
    SceneChoice scene;
    std::string out;         ///< empty: out/NAME_mesh below the current folder
    std::string particles;   ///< file for 'dmp run --particles'; empty: none
    bool rest_test = false;  ///< then run them at rest for a while
    TypedCommand typed;      ///< for lines to paste
};

/// What the command line says of a study's jobs, in place of [slurm] in the study.
struct SlurmOptions {
    std::string partition, account, time;  ///< as given; empty: as the study says
    int ranks = 0, threads = 0;            ///< 0: as the study says
    study::Launcher launcher = study::Launcher::mpirun;
    std::string form;  ///< file of the job script; empty: dmp's own
};

/// `dmp sweep`: the runs of a study (docs/studies.md).
struct SweepCommand {
    std::string study;                   ///< a study file, or a folder with a study.toml
    std::vector<std::string> overrides;  ///< "key=value", as given: of the scene in all runs
    std::string out;                     ///< empty: out/NAME below the current folder
    int jobs = 0;                        ///< runs at a time; 0: as many as there are processors for
    std::vector<std::string> only;       ///< "key=value", as given: the runs that have this value
    bool dry_run = false;
    bool resume = false;     ///< go on with the study in the folder
    bool overwrite = false;  ///< remove what an earlier study has left in the folder
    bool slurm = false;      ///< in jobs of Slurm
    SlurmOptions slurm_options;
    std::vector<std::string> runs;  ///< do these in this job of a queueing system, by name or number; empty: the study
    TypedCommand typed;             ///< for lines to paste
};

/// `dmp trade`: costs and errors of a scene's spacings and quality levels (docs/trade.md).
struct TradeCommand {
    std::string scene;                    ///< a scene file, or a folder with a scene.toml
    std::vector<std::string> overrides;   ///< "key=value", as given
    std::string out;                      ///< empty: out/NAME_trade below the current folder
    std::string until;                    ///< a time with its unit; empty: the scene's duration
    std::vector<std::string> measures;    ///< that are compared; empty: all
    std::string reference;                ///< folder of a run to compare with; empty: the finest one
    std::string budget;                   ///< wall time with its unit; empty: any
    std::vector<std::string> tolerances;  ///< errors to advise for; empty: 1, 5 and 10 %
    int jobs = 0;                         ///< runs at a time; 0: as many as there are processors for
    bool dry_run = false;
    bool resume = false;     ///< go on with the trade in the folder
    bool overwrite = false;  ///< remove what an earlier trade has left in the folder
    bool slurm = false;      ///< in jobs of Slurm
    SlurmOptions slurm_options;
    TypedCommand typed;  ///< for lines to paste
};

/// `dmp limits`: where the models of a scene end (docs/limits.md).
struct LimitsCommand {
    std::string scene;                   ///< a scene file, or a folder with a scene.toml
    std::vector<std::string> overrides;  ///< "key=value", as given
    std::string out;                     ///< empty: out/NAME_limits below the current folder
    std::string until;                   ///< a time with its unit; empty: what takes some seconds
    std::vector<std::string> dials;      ///< names of those to turn; empty: all
    std::string budget;                  ///< wall time with its unit; empty: any
    std::string tolerance;               ///< error from which on a measure departs; empty: 5 %
    int jobs = 0;                        ///< runs at a time; 0: as many as there are processors for
    bool dry_run = false;
    bool resume = false;     ///< go on with the limits in the folder
    bool overwrite = false;  ///< remove what earlier limits have left in the folder
    bool slurm = false;      ///< refused, with the reason
    TypedCommand typed;      ///< for lines to paste
};

/// `dmp convert`: ParaView's files from the HDF5 frames of a run.
struct ConvertCommand {
    std::string folder;  ///< of the run; the files go there
};

/// `dmp pictures`: draws the pictures of a run again.
struct PicturesCommand {
    std::string folder;                  ///< of the run; the pictures go there
    std::vector<std::string> overrides;  ///< of its scene: "output.picture_field=pressure"
    bool film = false;                   ///< also one of all frames
};

/// `dmp report`: writes the page of a run or of a study again.
struct ReportCommand {
    std::string folder;  ///< of the run or the study; the page goes there
};

/// `dmp explain`: what a scene will run and why, or what a key means.
struct ExplainCommand {
    SceneChoice subject;  ///< path: the scene or the key
    int threads = 0;
    bool measure = true;  ///< time the scene's first steps
};

/// `dmp escape`: how many particles come off a carrier that hits a wall, by a simple model (docs/escape.md).
struct EscapeCommand {
    std::string out;                ///< CSV file; empty: standard output
    bool printed = false;           ///< the model as printed; else corrected
    bool thesis_stiffness = false;  ///< 2 E / (1 - nu^2) of the particle; else Hertz'
    std::vector<std::string> speeds, angles;
    std::vector<double> friction{0.1, 0.3, 0.5, 1};
    std::string carrier_radius = "50 um", particle_radius = "2.5 um", particle_mass = "84.4 pg";
    std::string pull_off_force = "258 nN", equilibrium_distance = "0.4 nm", cutoff = "1 nm";
    std::string carrier_youngs_modulus = "63 GPa", particle_youngs_modulus = "2.15 GPa";
    double carrier_poisson_ratio = 0.24, particle_poisson_ratio = 0.3;
};

/// `dmp inspect`: what a geometry holds (docs/cad.md).
struct InspectCommand {
    std::string file;
    std::string unit;           ///< length of one unit of the geometry, "mm" or "1 mm"; empty: what the file says
    bool json = false;          ///< for programs
    TypedCommand typed;         ///< for lines to paste
    std::string bad_triangles;  ///< VTP file for the triangles at the open edges of what is no solid; empty: none
    GeometryReading reading;
};

/// `dmp new`: a first scene for a geometry, which runs (docs/cad.md).
struct NewCommand {
    std::string folder;        ///< to make
    std::string cad_geometry;  ///< goes there, too
    std::string unit;          ///< as for `dmp inspect`
    TypedCommand typed;        ///< for lines to paste
    GeometryReading reading;
};

/// What dmp starts itself with to read a geometry in another process (geometry/geometry_process.hpp); no help tells of
/// it.
struct ReadGeometryCommand {};
inline constexpr const char* read_geometry_command = "read-geometry";

/// What `dmp sweep` starts itself with to start runs (cli/sweep/run_starter.hpp); no help tells of it.
struct StartRunsCommand {};
inline constexpr const char* start_runs_command = "start-runs";

/// `dmp doctor`: is this machine all right?
struct DoctorCommand {};

/// --help and --version: text for stdout.
struct PrintCommand {
    std::string text;
};

using Command = std::variant<RunCommand, SweepCommand, TradeCommand, LimitsCommand, MeshCommand, InspectCommand,
                             NewCommand, ConvertCommand, PicturesCommand, ReportCommand, ExplainCommand, EscapeCommand,
                             DoctorCommand, ReadGeometryCommand, StartRunsCommand, PrintCommand>;

/// Each does its command and returns the exit code; what goes wrong is thrown.
int execute(const RunCommand& command);
int execute(const SweepCommand& command);
int execute(const TradeCommand& command);
int execute(const LimitsCommand& command);
int execute(const MeshCommand& command);
int execute(const InspectCommand& command);
int execute(const NewCommand& command);
int execute(const ReadGeometryCommand& command);
int execute(const StartRunsCommand& command);
int execute(const ConvertCommand& command);
int execute(const PicturesCommand& command);
int execute(const ReportCommand& command);
int execute(const ExplainCommand& command);
int execute(const EscapeCommand& command);
int execute(const DoctorCommand& command);
int execute(const PrintCommand& command);

}  // namespace dmp::cli
