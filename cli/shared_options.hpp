// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/commands.hpp"
#include "cli/uses.hpp"

namespace dmp::cli {

// Options that several commands have, with the values they fill.
void add_unit(CLI::App& app, std::string& unit);
void add_scene(CLI::App& app, SceneChoice& scene);
void add_reading(CLI::App& app, GeometryReading& reading);
void add_set(CLI::App& app, std::vector<std::string>& overrides);
void add_threads(CLI::App& app, int& threads);
void add_particles(CLI::App& app, SceneChoice& scene);
void add_frames(CLI::App& app, std::optional<FrameFormat>& format);
/// --leave-out
void add_leave_out(CLI::App& app, study::LeftOut& left_out);
void add_vector_unit(CLI::App& app, VectorUnit& unit);

/// --slurm, which is returned, and what its jobs have.
CLI::Option* add_slurm(CLI::App& app, bool& slurm, SlurmOptions& options);

/// Those of `dmp trade`.
void add_trade_options(CLI::App& app, TradeCommand& trade);
/// Those of `dmp limits`.
void add_limits_options(CLI::App& app, LimitsCommand& limits);

/// What is wrong with a number of threads or runs; "": nothing.
[[nodiscard]] std::string at_least_one(const std::string& text);

}  // namespace dmp::cli
