// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/frame_file.hpp"

#include <stdexcept>
#include <string>

#include "base/errors.hpp"
#include "base/numbered_files.hpp"
#include "base/sealed_file.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/results/frame_check.hpp"

namespace dmp::solver {

namespace fs = std::filesystem;

namespace {

constexpr SealedKind frame_kind{"frame", 1};

const NumberedFiles& files() {
    static const NumberedFiles kind("frame_", 6, ".h5");
    return kind;
}

const NumberedFiles& folders() {
    static const NumberedFiles kind("frame_", 6, "");
    return kind;
}

const NumberedFiles& piece_files() {
    static const NumberedFiles kind("piece_", 3, ".h5");
    return kind;
}

/// Removes the files of one kind from `number` on and the unfinished ones; returns how many.
std::size_t remove_files(const NumberedFiles& kind, const fs::path& folder, long number) {
    std::vector<fs::path> all = kind.unfinished_in(folder);
    for (const auto& [its_number, file] : kind.in(folder))
        if (its_number >= number) all.push_back(file);
    for (const fs::path& file : all) remove_file(file);
    return all.size();
}

/// Names become datasets and groups: a slash would make more of them.
void check_name(const std::string& name) {
    if (name.empty() || name == "." || name.find('/') != std::string::npos)
        throw std::invalid_argument("'" + name + "' cannot be the name of a field or group in a file");
}

void write_fields(Hdf5Writer& to, const std::string& prefix, const std::vector<FrameField>& fields) {
    std::vector<std::string> names;
    const std::string group = prefix + "/";
    for (const FrameField& field : fields) {
        check_name(field.name);
        names.push_back(field.name);
        const std::string dataset = group + field.name;
        to.write_array<float>(dataset, field.values);
        to.set_attribute(dataset, "unit", field.unit);
        to.set_attribute<std::int32_t>(dataset, "components", field.components);
    }
    to.write_texts(prefix + "_names", names);
}

void write_group(Hdf5Writer& to, const FrameGroup& group) {
    const std::string problem = problem_with(group);
    if (!problem.empty()) throw std::invalid_argument(problem);
    check_name(group.name);
    const std::string prefix = "group/" + group.name + "/";
    to.write_array<float>(prefix + "position", group.position);
    to.set_attribute(prefix + "position", "unit", "m");
    to.write_array<std::int64_t>(prefix + "id", group.id);
    to.write_array<std::int32_t>(prefix + "part", group.part);
    to.write_array<std::int32_t>(prefix + "bond_ends", group.bond_ends);
    if (!group.triangles.empty()) to.write_array<std::int32_t>(prefix + "triangles", group.triangles);
    write_fields(to, prefix + "field", group.fields);
    write_fields(to, prefix + "bond_field", group.bond_fields);
}

std::vector<FrameField> read_fields(const Hdf5Reader& from, const std::string& prefix) {
    std::vector<FrameField> fields;
    const std::string group = prefix + "/";
    for (const std::string& name : from.texts(prefix + "_names")) {
        const std::string dataset = group + name;
        fields.push_back({name, from.text_attribute(dataset, "unit"),
                          from.number_attribute<std::int32_t>(dataset, "components"), from.array<float>(dataset)});
    }
    return fields;
}

FrameGroup read_group(const Hdf5Reader& from, const std::string& name) {
    const std::string prefix = "group/" + name + "/";
    FrameGroup group;
    group.name = name;
    group.position = from.array<float>(prefix + "position");
    group.id = from.array<std::int64_t>(prefix + "id");
    group.part = from.array<std::int32_t>(prefix + "part");
    group.bond_ends = from.array<std::int32_t>(prefix + "bond_ends");
    if (from.has(prefix + "triangles")) group.triangles = from.array<std::int32_t>(prefix + "triangles");
    group.fields = read_fields(from, prefix + "field");
    group.bond_fields = read_fields(from, prefix + "bond_field");
    const std::string problem = problem_with(group);
    if (!problem.empty()) from.refuse(problem);
    return group;
}

}  // namespace

fs::path frame_folder(const fs::path& folder) { return folder / "frames"; }

fs::path frame_path(const fs::path& folder, long number) { return frame_folder(folder) / files().name(number); }

fs::path piece_folder(const fs::path& folder, long number) { return frame_folder(folder) / folders().name(number); }

std::string piece_name(int rank) { return piece_files().name(rank); }

std::size_t remove_frames(const fs::path& folder, long number) {
    std::size_t removed = remove_files(files(), frame_folder(folder), number);
    for (const auto& [its_number, pieces] : folders().in(frame_folder(folder))) {
        if (its_number < number || !fs::is_directory(pieces)) continue;
        removed += remove_files(piece_files(), pieces, 0);
        if (fs::is_empty(pieces)) remove_file(pieces);
    }
    return removed;
}

void write_frame(const fs::path& file, const Frame& frame, const RunLabel& label) {
    SealedWriter writer(file, frame_kind);
    Hdf5Writer& to = writer.contents();
    to.write_text("label/title", label.title);
    to.write_text("label/scene_hash", label.scene_hash);
    to.write_text("label/dmp_version", label.version);
    to.write_number<double>("time", frame.time);
    to.write_number<std::int64_t>("step", frame.step);
    to.write_number<double>("spacing", frame.spacing);
    to.set_attribute("time", "unit", "s");
    to.set_attribute("spacing", "unit", "m");
    to.write_texts("parts", frame.parts);
    std::vector<std::string> groups;
    for (const FrameGroup& group : frame.groups) {
        groups.push_back(group.name);
        write_group(to, group);
    }
    to.write_texts("group_names", groups);
    writer.finish();
}

StoredFrame read_frame(const fs::path& file) {
    const SealedReader reader(file, frame_kind);
    const Hdf5Reader& from = reader.contents();
    StoredFrame stored;
    stored.label = {from.text("label/title"), from.text("label/scene_hash"), from.text("label/dmp_version")};
    stored.frame.time = from.number<double>("time");
    stored.frame.step = from.number<std::int64_t>("step");
    stored.frame.spacing = from.number<double>("spacing");
    stored.frame.parts = from.texts("parts");
    for (const std::string& name : from.texts("group_names")) stored.frame.groups.push_back(read_group(from, name));
    return stored;
}

StoredFrame read_frame(const std::vector<fs::path>& pieces) {
    StoredFrame whole = read_frame(pieces.at(0));
    if (pieces.size() == 1) return whole;
    const auto refuse = [&](const fs::path& piece, const std::string& problem) {
        throw InputError(SourceLocation{piece.string(), 0, 0}, problem, "Restore the frame's pieces from a copy.");
    };
    for (std::size_t n = 1; n < pieces.size(); ++n) {
        StoredFrame piece = read_frame(pieces[n]);
        std::string problem = piece.label.scene_hash == whole.label.scene_hash ? "" : "of another scene";
        if (problem.empty()) problem = add_piece(whole.frame, std::move(piece.frame));
        if (!problem.empty()) refuse(pieces[n], "not a piece of the frame of " + pieces[0].string() + ": " + problem);
    }
    const std::string problem = finish_pieces(whole.frame);
    if (!problem.empty()) refuse(pieces[0].parent_path(), problem);
    return whole;
}

}  // namespace dmp::solver
