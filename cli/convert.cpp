// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "postproc/vtk_sink.hpp"
#include "solver/output/frame_file.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

using Frames = std::map<long, fs::path>;

Frames find_frames(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw InputError(Place{folder.string(), 0, 0}, "there is no such folder",
                         "Name the folder that a run left, the one with frames/ in it.");
    Frames frames = frame_files(folder);
    if (frames.empty())
        throw InputError(Place{folder.string(), 0, 0},
                         "there are no frames in it to convert (" + frame_path("", 0).string() + " and on)",
                         "Name the folder that a run left. Runs that write ParaView's files need no converting.");
    return frames;
}

/// The numbers that are not there, up to the last one that is: "3, 7 to 9"; empty when there is none.
std::string missing_text(const Frames& frames) {
    std::string text;
    long expected = 0;
    for (const auto& [number, file] : frames) {
        if (number > expected) text += (text.empty() ? "" : ", ") + std::to_string(expected);
        if (number > expected + 1) text += " to " + std::to_string(number - 1);
        expected = number + 1;
    }
    return text;
}

StoredFrame read(const fs::path& file, long converted) {
    try {
        return read_frame(file);
    } catch (const InputError& error) {
        throw InputError(error.where(), error.problem(),
                         fmt::format("Restore it from a copy, or move it away to convert the others.\n"
                                     "Converted before it: {}.",
                                     count_text(static_cast<std::size_t>(converted), "frame")));
    }
}

}  // namespace

int execute(const ConvertCommand& command) {
    refuse_several_ranks();
    const fs::path folder = command.folder;
    const Frames frames = find_frames(folder);
    const std::string missing = missing_text(frames);
    if (!missing.empty())
        print(Style(Stream::output).warning("warning: ") + "frames that are not there are left out: " + missing + "\n");
    flush_output();

    // Before the sink: it clears away what an earlier conversion left, which is not to happen for nothing.
    StoredFrame stored = read(frames.begin()->second, 0);
    VtkSink sink(folder, stored.label);
    ProgressLine line;
    for (auto next = frames.begin();;) {
        sink.write(stored.frame);
        line.show(fmt::format("converted {} of {}", sink.frames(), count_text(frames.size(), "frame")));
        if (++next == frames.end()) break;
        stored = read(next->second, sink.frames());
    }
    line.clear();
    print(fmt::format("Converted {}.\n\n", count_text(frames.size(), "frame")) + results_text(folder, sink.files()));
    return exit_done;
}

}  // namespace dmp::cli
