// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/frame_index.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "solver/output/frame_file.hpp"

namespace dmp::solver {

namespace fs = std::filesystem;

namespace {

constexpr const char* one_file = "file";
constexpr const char* some_pieces = "folder";
constexpr const char* count = "pieces";

FrameEntry entry_of(const nlohmann::json& json) {
    FrameEntry entry;
    const bool in_pieces = json.contains(some_pieces);
    entry.path = json.at(in_pieces ? some_pieces : one_file);
    if (in_pieces) entry.pieces = json.at(count);
    entry.time = json.at("time");
    entry.step = json.at("step");
    return entry;
}

nlohmann::ordered_json json_of(const FrameEntry& entry) {
    nlohmann::ordered_json json;
    json[entry.pieces > 0 ? some_pieces : one_file] = entry.path;
    if (entry.pieces > 0) json[count] = entry.pieces;
    json["time"] = entry.time;
    json["step"] = entry.step;
    return json;
}

}  // namespace

std::vector<fs::path> FrameEntry::files(const fs::path& folder) const {
    if (pieces == 0) return {folder / path};
    std::vector<fs::path> paths;
    paths.reserve(static_cast<std::size_t>(pieces));
    for (int rank = 0; rank < pieces; ++rank) paths.push_back(folder / path / piece_name(rank));
    return paths;
}

bool FrameEntry::is_there(const fs::path& folder) const {
    return std::ranges::all_of(files(folder), [](const fs::path& file) { return fs::exists(file); });
}

void write_frame_index(const fs::path& folder, const RunLabel& label, const std::vector<FrameEntry>& frames) {
    nlohmann::ordered_json index;
    index["title"] = label.title;
    index["scene_hash"] = label.scene_hash;
    index["dmp_version"] = label.version;
    index["frames"] = nlohmann::ordered_json::array();
    for (const FrameEntry& entry : frames) index["frames"].push_back(json_of(entry));
    write_file(folder / frame_index_name, index.dump(1) + "\n");
}

std::vector<FrameEntry> read_frame_index(const fs::path& folder) {
    const fs::path file = folder / frame_index_name;
    std::vector<FrameEntry> frames;
    try {
        const auto index = nlohmann::json::parse(read_file(file));
        for (const auto& entry : index.at("frames")) frames.push_back(entry_of(entry));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(SourceLocation{file.string(), 0, 0}, std::string("not an index of frames: ") + error.what(),
                         "Restore it from a copy, or run the scene from its start.");
    }
    return frames;
}

}  // namespace dmp::solver
