// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/json_value.hpp"
#include "report/picture.hpp"
#include "report/shown_particles.hpp"
#include "report/uses.hpp"
#include "solver/results/run_summary.hpp"

namespace dmp::report {

/// What run.log says.
struct LoggedRun {
    /// Each time that the run was started or resumed.
    struct Start {
        std::string when, version, command;
    };
    std::vector<Start> starts;
    std::vector<std::string> warnings;  ///< each once, without the word "warning"; may have several lines
    std::string error;                  ///< what ended it, since it was last started; "": nothing did
};

/// Reads the text of a run.log.
[[nodiscard]] LoggedRun logged_run(std::string_view text);

/// What a run left in its folder.
struct RunFiles {
    std::filesystem::path folder;
    JsonValue::Json summary;  ///< empty: the run did not reach an end that leaves one
    LoggedRun log;
    std::string log_text;  ///< of a run without a summary: the end of run.log
    std::string resolved_scene;
    std::optional<MeasureSeries> measures;
    MeasureSeries references;  ///< what columns of the measures should be, as far as that is known
    std::vector<Picture> pictures;
    ShownParticles particles;  ///< no times: there are no frames, or none can be read
    long frames = 0;           ///< of those that can be read
    bool has_paraview_script = false;
    std::vector<std::string> notes;  ///< files that are not there, or cannot be shown

    [[nodiscard]] JsonValue facts() const;
    /// Whether it was killed, diverged, or runs still.
    [[nodiscard]] bool has_no_end() const { return summary.empty(); }
};

/// The most that the pictures of a page may take [bytes]; those beyond are named instead.
inline constexpr std::size_t most_picture_bytes = 2'500'000;

/// Opens the frames that a folder has in ParaView's files: postproc does, which clusters lack. Null: this dmp cannot.
/// Throws InputError.
using OpenParaviewFrames = std::function<std::unique_ptr<FrameSource>(const std::filesystem::path&)>;

/// Throws InputError where the folder is missing or no run has begun in it, or a file is damaged; of damaged frames
/// there is a note.
[[nodiscard]] RunFiles read_run_files(const std::filesystem::path& folder, const OpenParaviewFrames& open_paraview);

}  // namespace dmp::report
