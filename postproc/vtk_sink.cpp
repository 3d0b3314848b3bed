// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/vtk_sink.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <regex>
#include <string_view>

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "base/allocation.hpp"
#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "postproc/paraview_script.hpp"
#include "postproc/polydata.hpp"
#include "postproc/vtk_messages.hpp"

namespace dmp::postproc {

namespace fs = std::filesystem;

namespace {

constexpr const char* frames_folder = "frames";
constexpr std::array series_names{"fluid", "solid", "spheres", "moving_walls"};

/// The shortest text that reads back as the same number.
std::string exact_text(double value) {
    std::array<char, 32> buffer{};
    auto* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string frame_file(const std::string& group, long number) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "_%06ld.vtp", number);
    return std::string(frames_folder) + "/" + group + digits.data();
}

/// Removes array ranges that VTK writes but cannot read back: those with NaN or infinity, which the last frame of a
/// diverged run may contain.
void drop_ranges_without_numbers(std::string& text) {
    constexpr std::string_view begin = "<InformationKey name=\"L2_NORM_", end = "</InformationKey>";
    for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        const auto size = text.find(end, at) + end.size() - at;
        const std::string_view key = std::string_view(text).substr(at, size);
        if (key.find("nan") == std::string_view::npos && key.find("inf") == std::string_view::npos)
            at += size;
        else
            text.erase(at, size);
    }
}

/// Bytes that VTK takes at most to write the data as text: base64 of arrays that do not get smaller by compression, in
/// a stream that grows by doubling, and two copies of what it then holds.
std::size_t memory_to_write(vtkPolyData* data) {
    constexpr std::size_t besides = std::size_t{16} << 20U;
    const std::size_t arrays = std::size_t{1024} * data->GetActualMemorySize();
    return besides + arrays * 4 / 3 * 5;
}

/// The text of the file. VTK writes it to memory because VTK 9.1 misses errors or crashes when the disk becomes full.
/// The data are inline, not appended: ParaView 5.11 of Debian 12 cannot read appended data with that system's
/// libexpat.
std::string vtp_text(vtkPolyData* data, const fs::path& file) {
    if (!may_allocate(memory_to_write(data)))
        throw ResourceError("'" + file.string() + "' was not written: VTK may take " +
                                std::to_string(memory_to_write(data) >> 20U) +
                                " MiB for it, more than the limit of this process' memory leaves (ulimit -v)",
                            "Raise the limit, or write frames with --frames hdf5.");
    const VtkMessages messages;
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetDataModeToBinary();
    writer->SetCompressorTypeToLZ4();
    writer->SetHeaderTypeToUInt64();
    writer->WriteToOutputStringOn();
    const bool written = writer->Write() == 1;
    std::string text = writer->GetOutputString();
    if (!written || !messages.text().empty() || writer->GetErrorCode() != vtkErrorCode::NoError ||
        !std::string_view(text).substr(0, text.find_last_not_of(" \n") + 1).ends_with("</VTKFile>"))
        throw_write_error(file, messages.text().empty() ? "VTK ran out of memory" : messages.text());
    drop_ranges_without_numbers(text);
    return text;
}

bool is_own_frame(const fs::path& file) {
    const std::string name = file.filename().string();
    return file.extension() == ".vtp" && std::ranges::any_of(series_names, [&](const char* series) {
               return name.starts_with(std::string(series) + "_");
           });
}

/// Series first: a .pvd must not list a file that no longer exists.
void remove_earlier_run(const fs::path& folder) {
    std::error_code failed;
    for (const char* name : series_names) fs::remove(folder / (std::string(name) + ".pvd"), failed);
    fs::remove(folder / "walls.vtp", failed);
    std::vector<fs::path> old_frames;
    for (const auto& entry : fs::directory_iterator(folder / frames_folder, failed))
        if (is_own_frame(entry.path())) old_frames.push_back(entry.path());
    for (const fs::path& file : old_frames) fs::remove(file, failed);
}

}  // namespace

VtkSink::VtkSink(fs::path folder, RunLabel label) : folder_(std::move(folder)), label_(std::move(label)) {
    make_folder(folder_);
    make_folder(folder_ / frames_folder);
}

void VtkSink::go_on(long frames) {
    for (const char* name : series_names) {
        std::ifstream file(folder_ / (std::string(name) + ".pvd"));
        static const std::regex entry("timestep=\"([^\"]+)\".* file=\"([^\"]+)\"");
        std::smatch match;
        for (std::string line; std::getline(file, line);) {
            if (!std::regex_search(line, match, entry)) continue;
            const std::string frame = match[2];
            if (frame >= frame_file(name, frames)) {
                fs::remove(folder_ / frame);
                continue;
            }
            if (!fs::exists(folder_ / frame))
                throw InputError({(folder_ / frame).string()}, "a frame of the run is missing",
                                 "A run can only be continued in the folder of its frames; otherwise start it again in "
                                 "another folder.");
            series_[name].push_back({std::stod(match[1]), frame});
        }
        // Solids may appear later; all other groups exist from the beginning.
        const auto& entries = series_.contains(name) ? series_[name] : std::vector<Entry>{};
        const long first = frames - static_cast<long>(entries.size());
        bool complete = entries.empty() || first == 0 || (first > 0 && std::string_view(name) == "solid");
        for (std::size_t k = 0; complete && k < entries.size(); ++k)
            complete = entries[k].file == frame_file(name, first + static_cast<long>(k));
        if (!complete)
            throw InputError(
                {(folder_ / (std::string(name) + ".pvd")).string()},
                "the series lists fewer frames than the run has written",
                "A run can only be continued in the folder of its frames; otherwise start it again in another folder.");
    }
    if (frames > 0 && series_.empty())
        throw InputError({folder_.string()}, "the run to be continued has written no ParaView files",
                         "Continue it with the same --frames with which it was started.");
    frames_ = frames;
    walls_written_ = fs::exists(folder_ / "walls.vtp");
}

void VtkSink::start(const Frame& frame) {
    remove_earlier_run(folder_);
    write_file(folder_ / paraview_script_name, paraview_script(frame.spacing));
}

void VtkSink::write(const Frame& frame) {
    if (frames_ == 0) start(frame);
    std::map<std::string, Entry> written;
    for (const FrameGroup& group : frame.groups) {
        const bool walls = group.name == "walls";
        if (group.size() == 0 || (walls && walls_written_)) continue;
        const std::string file = walls ? "walls.vtp" : frame_file(group.name, frames_);
        write_file(folder_ / file, vtp_text(to_polydata(frame, group, label_), folder_ / file));
        if (walls)
            walls_written_ = true;
        else
            written[group.name] = {frame.time, file};
    }
    ++frames_;
    for (const auto& [name, entry] : written) {
        series_[name].push_back(entry);
        write_series(name);
    }
}

void VtkSink::write_series(const std::string& name) const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (const Entry& entry : series_.at(name))
        text += "    <DataSet timestep=\"" + exact_text(entry.time) + "\" part=\"0\" file=\"" + entry.file + "\"/>\n";
    text += "  </Collection>\n</VTKFile>\n";
    write_file(folder_ / (name + ".pvd"), text);
}

std::vector<std::string> VtkSink::files() const {
    std::vector<std::string> names;
    for (const auto& [name, entries] : series_) names.push_back(name + ".pvd");
    if (walls_written_) names.emplace_back("walls.vtp");
    if (frames_ > 0) names.emplace_back(paraview_script_name);
    return names;
}

}  // namespace dmp::postproc
