// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/frame_file.hpp"

#include <stdexcept>
#include <string>

#include "base/numbered_files.hpp"
#include "base/sealed_file.hpp"
#include "solver/frame_check.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

constexpr SealedKind frame_kind{"frame", 1};

const NumberedFiles& files() {
    static const NumberedFiles kind("frame_", 6, ".h5");
    return kind;
}

/// Names become datasets and groups: a slash would make more of them.
void check_name(const std::string& name) {
    if (name.empty() || name == "." || name.find('/') != std::string::npos)
        throw std::invalid_argument("'" + name + "' cannot be the name of a field or group in a file");
}

void write_fields(Hdf5Writer& to, const std::string& place, const std::vector<FrameField>& fields) {
    std::vector<std::string> names;
    const std::string group = place + "/";
    for (const FrameField& field : fields) {
        check_name(field.name);
        names.push_back(field.name);
        const std::string dataset = group + field.name;
        to.write_array<float>(dataset, field.values);
        to.set_attribute(dataset, "unit", field.unit);
        to.set_attribute<std::int32_t>(dataset, "components", field.components);
    }
    to.write_texts(place + "_names", names);
}

void write_group(Hdf5Writer& to, const FrameGroup& group) {
    const std::string problem = problem_with(group);
    if (!problem.empty()) throw std::invalid_argument(problem);
    check_name(group.name);
    const std::string place = "group/" + group.name + "/";
    to.write_array<float>(place + "position", group.position);
    to.set_attribute(place + "position", "unit", "m");
    to.write_array<std::int64_t>(place + "id", group.id);
    to.write_array<std::int32_t>(place + "part", group.part);
    to.write_array<std::int32_t>(place + "bond_ends", group.bond_ends);
    write_fields(to, place + "field", group.fields);
    write_fields(to, place + "bond_field", group.bond_fields);
}

std::vector<FrameField> read_fields(const Hdf5Reader& from, const std::string& place) {
    std::vector<FrameField> fields;
    const std::string group = place + "/";
    for (const std::string& name : from.texts(place + "_names")) {
        const std::string dataset = group + name;
        fields.push_back({name, from.text_attribute(dataset, "unit"),
                          from.number_attribute<std::int32_t>(dataset, "components"), from.array<float>(dataset)});
    }
    return fields;
}

FrameGroup read_group(const Hdf5Reader& from, const std::string& name) {
    const std::string place = "group/" + name + "/";
    FrameGroup group;
    group.name = name;
    group.position = from.array<float>(place + "position");
    group.id = from.array<std::int64_t>(place + "id");
    group.part = from.array<std::int32_t>(place + "part");
    group.bond_ends = from.array<std::int32_t>(place + "bond_ends");
    group.fields = read_fields(from, place + "field");
    group.bond_fields = read_fields(from, place + "bond_field");
    const std::string problem = problem_with(group);
    if (!problem.empty()) from.refuse(problem);
    return group;
}

}  // namespace

fs::path frame_folder(const fs::path& folder) { return folder / "frames"; }

fs::path frame_path(const fs::path& folder, long number) { return frame_folder(folder) / files().name(number); }

std::map<long, fs::path> frame_files(const fs::path& folder) { return files().in(frame_folder(folder)); }

void remove_frames(const fs::path& folder, long number) {
    for (const auto& [its_number, file] : frame_files(folder))
        if (its_number >= number) remove_file(file);
    for (const fs::path& file : files().unfinished_in(frame_folder(folder))) remove_file(file);
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

}  // namespace dmp
