// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/hdf5_sink.hpp"

#include <iterator>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "solver/output/frame_file.hpp"

namespace dmp {

namespace fs = std::filesystem;

Hdf5Sink::Hdf5Sink(fs::path folder, RunLabel label) : folder_(std::move(folder)), label_(std::move(label)) {
    make_folder(folder_);
    make_folder(frame_folder(folder_));
}

void Hdf5Sink::go_on(long frames) {
    entries_.clear();
    if (frames == 0) return;  // a run that was stopped before its first frame may have left no index
    const fs::path file = folder_ / frame_index_name;
    try {
        const auto index = nlohmann::json::parse(read_file(file));
        for (const auto& entry : index.at("frames")) {
            if (std::ssize(entries_) == frames) break;
            entries_.push_back({entry.at("file"), entry.at("time"), entry.at("step")});
        }
    } catch (const nlohmann::json::exception& error) {
        throw InputError(Place{file.string(), 0, 0}, std::string("not an index of frames: ") + error.what(),
                         "Restore it from a copy, or run the scene from its start.");
    }
    for (long number = 0; number < frames; ++number)
        if (number >= std::ssize(entries_) || !fs::exists(frame_path(folder_, number)))
            throw InputError(Place{folder_.string(), 0, 0},
                             "frame " + std::to_string(number) + " of the run to go on with is missing",
                             "Restore the folder from a copy, or run the scene from its start.");
}

void Hdf5Sink::write(const Frame& frame) {
    if (!started_) {
        // The index first: it may not name a file that is gone.
        write_index();
        remove_frames(folder_, frames());
        started_ = true;
    }
    const fs::path file = frame_path(folder_, frames());
    write_frame(file, frame, label_);
    entries_.push_back({file.lexically_relative(folder_).string(), frame.time, frame.step});
    write_index();
}

std::vector<std::string> Hdf5Sink::files() const {
    std::vector<std::string> names;
    if (!entries_.empty()) names = {frame_folder("").string(), frame_index_name};
    return names;
}

void Hdf5Sink::write_index() const {
    nlohmann::ordered_json index;
    index["title"] = label_.title;
    index["scene_hash"] = label_.scene_hash;
    index["dmp_version"] = label_.version;
    index["frames"] = nlohmann::ordered_json::array();
    for (const Entry& entry : entries_)
        index["frames"].push_back({{"file", entry.file}, {"time", entry.time}, {"step", entry.step}});
    write_file(folder_ / frame_index_name, index.dump(1) + "\n");
}

}  // namespace dmp
