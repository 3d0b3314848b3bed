// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/hdf5_sink.hpp"

#include <iterator>
#include <utility>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "solver/output/frame_file.hpp"

namespace dmp::solver {

namespace fs = std::filesystem;

Hdf5Sink::Hdf5Sink(fs::path folder, RunLabel label, Ranks ranks)
    : folder_(std::move(folder)), label_(std::move(label)), ranks_(std::move(ranks)) {
    if (!ranks_.is_first()) return;
    make_folder(folder_);
    make_folder(frame_folder(folder_));
}

void Hdf5Sink::go_on(long frames) {
    frames_ = frames;
    entries_.clear();
    // A run that was stopped before its first frame may have left no index.
    if (frames == 0 || !ranks_.is_first()) return;
    if (!fs::exists(folder_ / frame_index_name))
        throw InputError(SourceLocation{folder_.string(), 0, 0}, "the run to be continued has written no HDF5 frames",
                         "Continue it with the same --frames with which it was started.");
    entries_ = read_frame_index(folder_);
    if (std::ssize(entries_) > frames) entries_.resize(static_cast<std::size_t>(frames));
    for (long number = 0; number < frames; ++number)
        if (number >= std::ssize(entries_) || !entries_[static_cast<std::size_t>(number)].is_there(folder_))
            throw InputError(SourceLocation{folder_.string(), 0, 0},
                             "frame " + std::to_string(number) + " of the run to go on with is missing",
                             "Restore the folder from a copy, or run the scene from its start.");
}

void Hdf5Sink::start() {
    if (ranks_.is_first()) {
        // The index first: it may not name a file that is gone.
        write_frame_index(folder_, label_, entries_);
        remove_frames(folder_, frames_);
    }
    wait_for_all();
    started_ = true;
}

void Hdf5Sink::write(const Frame& frame) {
    if (!started_) start();
    const bool in_pieces = ranks_.size() > 1;
    const fs::path position = in_pieces ? piece_folder(folder_, frames_) : frame_path(folder_, frames_);
    if (in_pieces) make_folder(position);
    write_frame(in_pieces ? position / piece_name(ranks_.rank()) : position, frame, label_);
    // Those who could not write it have ended the run before they got here.
    wait_for_all();
    ++frames_;
    if (!ranks_.is_first()) return;
    entries_.push_back(
        {position.lexically_relative(folder_).string(), in_pieces ? ranks_.size() : 0, frame.time, frame.step});
    write_frame_index(folder_, label_, entries_);
}

std::vector<std::string> Hdf5Sink::files() const {
    std::vector<std::string> names;
    if (!entries_.empty()) names = {frame_folder("").string(), frame_index_name};
    return names;
}

void Hdf5Sink::wait_for_all() const { (void)ranks_.any(false); }

}  // namespace dmp::solver
