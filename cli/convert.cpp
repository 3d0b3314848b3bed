// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/results_folder.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "postproc/vtk_sink.hpp"
#include "solver/output/frame_file.hpp"
#include "solver/output/frame_index.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// The frames of a run: those that are there, and the numbers of the others, "3, 7 to 9".
struct Found {
    std::vector<FrameEntry> frames;
    std::string missing;
};

/// The frames that the run's index names. One of which a piece is missing is none.
Found find_frames(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw InputError(SourceLocation{folder.string(), 0, 0}, "there is no such folder",
                         "Name the folder that a run left, the one with frames/ in it.");
    Found found;
    if (fs::exists(folder / frame_index_name)) {
        long number = 0, first_missing = -1;
        const auto note_missing = [&] {
            if (first_missing < 0) return;
            found.missing += (found.missing.empty() ? "" : ", ") + std::to_string(first_missing);
            if (number - first_missing > 1) found.missing += " to " + std::to_string(number - 1);
            first_missing = -1;
        };
        for (FrameEntry& entry : read_frame_index(folder)) {
            if (entry.is_there(folder)) {
                note_missing();
                found.frames.push_back(std::move(entry));
            } else if (first_missing < 0) {
                first_missing = number;
            }
            ++number;
        }
        note_missing();
    }
    if (found.frames.empty())
        throw InputError(SourceLocation{folder.string(), 0, 0},
                         std::string("there are no frames in it to convert (") + frame_index_name + ")",
                         "Name the folder that a run left. Runs that write ParaView's files need no converting.");
    return found;
}

StoredFrame read(const std::vector<fs::path>& files, long converted) {
    try {
        return read_frame(files);
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
    static_cast<void>(find_frames(folder));  // no folder but a run's gets a lock
    const ResultsFolder results = ResultsFolder::of_run(folder);
    if (!results.note().empty()) print(results.note() + "\n");
    const auto [frames, missing] = find_frames(folder);
    if (!missing.empty())
        print(Style(Stream::output).warning("warning: ") + "frames that are not there are left out: " + missing + "\n");
    flush_output();

    // Before the sink: it clears away what an earlier conversion left, which is not to happen for nothing.
    StoredFrame stored = read(frames.front().files(folder), 0);
    VtkSink sink(folder, stored.label);
    ProgressLine line;
    for (auto next = frames.begin();;) {
        results.check();
        sink.write(stored.frame);
        line.show(fmt::format("converted {} of {}", sink.frames(), count_text(frames.size(), "frame")));
        if (++next == frames.end()) break;
        stored = read(next->files(folder), sink.frames());
    }
    line.clear();
    print(fmt::format("Converted {}.\n\n", count_text(frames.size(), "frame")) + results_text(folder, sink.files()));
    return exit_done;
}

}  // namespace dmp::cli
