// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/slurm_folder.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "cli/exit_codes.hpp"
#include "cli/sweep/slurm_job.hpp"
#include "cli/sweep/sweep_table.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* ends_name = "ends";
constexpr const char* number_name = "job";
constexpr const char* ends_heading =
    "exit_code,wall_time [s],processor_time [s],peak_memory [B],job,checkpoint,error\n";

template <class Number>
Number number_of(const std::string& text, Number otherwise) {
    Number number = otherwise;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

bool is_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos && text.size() < 9;
}

std::string first_line(const fs::path& file) {
    if (!fs::is_regular_file(file)) return "";
    const std::vector<std::string> lines = text_lines(read_file(file));
    return lines.empty() ? "" : lines.front();
}

/// The folders 1, 2, ... in order.
std::vector<fs::path> job_folders(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.symlink_status().type() == fs::file_type::directory && is_number(entry.path().filename().string()))
            found.push_back(entry.path());
    std::ranges::sort(found, {}, [](const fs::path& path) { return std::stol(path.filename().string()); });
    return found;
}

/// What a job's folder may hold.
bool is_jobs_file(const fs::path& file) {
    const std::string name = file.filename().string();
    return name == job_script_name || name == job_runs_name || name == number_name ||
           (name.starts_with("element_") && name.ends_with(".log"));
}

void remove_files(const fs::path& folder, bool (*is_own)(const fs::path&)) {
    std::error_code none;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.symlink_status().type() == fs::file_type::regular && is_own(entry.path()))
            files.push_back(entry.path());
    for (const fs::path& file : files) fs::remove(file);
    fs::remove(folder, none);  // where nothing else is in it
}

}  // namespace

bool is_stopped(int exit_code) {
    constexpr std::array codes{exit_hung_up, exit_interrupted, exit_user_signal, exit_no_reader, exit_terminated};
    return std::ranges::find(codes, exit_code) != codes.end();
}

bool JobEnd::is_unfinished() const { return is_stopped(exit_code); }

bool SubmittedJob::has(const QueuedElement& element) const {
    return job.empty() ? fs::path(element.script) == fs::absolute(folder / job_script_name) : element.job == job;
}

std::vector<SubmittedJob> SlurmFolder::jobs() const {
    std::vector<SubmittedJob> all;
    for (const fs::path& folder : job_folders(folder_)) {
        const fs::path runs = folder / job_runs_name;
        if (!fs::is_regular_file(runs)) continue;  // it was never handed in
        SubmittedJob& job = all.emplace_back(SubmittedJob{folder, first_line(folder / number_name), {}});
        for (const std::string& line : text_lines(read_file(runs))) {
            std::istringstream words(line);
            std::vector<std::string>& names = job.elements.emplace_back();
            for (std::string name; words >> name;) names.push_back(name);
        }
    }
    return all;
}

fs::path SlurmFolder::add_job(const std::vector<std::vector<std::string>>& elements) const {
    const std::vector<fs::path> others = job_folders(folder_);
    const long last = others.empty() ? 0 : std::stol(others.back().filename().string());
    const fs::path folder = folder_ / std::to_string(last + 1);
    make_folder(folder);
    make_folder(folder_ / ends_name);
    std::string text;
    for (const auto& runs : elements) {
        std::string line;
        for (const std::string& run : runs) line += (line.empty() ? "" : " ") + run;
        text += line + "\n";
    }
    write_file(folder / job_runs_name, text);
    return folder;
}

void SlurmFolder::note_number(const fs::path& job_folder, const std::string& number) {
    write_file(job_folder / number_name, number + "\n");
}

void SlurmFolder::remove_job(const fs::path& job_folder) { remove_files(job_folder, is_jobs_file); }

std::string SlurmFolder::last_words(const SubmittedJob& job, long element) {
    const fs::path log = job.folder / fmt::format("element_{}.log", element);
    return fs::is_regular_file(log) ? last_error(read_file(log)) : "";
}

fs::path SlurmFolder::ends_file(const std::string& run) const { return folder_ / ends_name / (run + ".csv"); }

std::vector<JobEnd> SlurmFolder::ends_of(const std::string& run) const {
    std::vector<JobEnd> ends;
    const fs::path file = ends_file(run);
    if (!fs::is_regular_file(file)) return ends;
    std::vector<std::string> lines = text_lines(read_file(file));
    if (!lines.empty()) lines.erase(lines.begin());
    for (const std::string& line : lines) {
        const std::vector<std::string> cells = csv_cells(line);
        if (cells.size() != 7) continue;  // it is being written
        ends.push_back({number_of(cells[0], static_cast<int>(exit_bug)), number_of(cells[1], 0.0),
                        number_of(cells[2], 0.0), number_of(cells[3], 0.0), cells[4], number_of(cells[5], -1L),
                        cells[6]});
    }
    return ends;
}

std::vector<std::string> SlurmFolder::ended_runs() const {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_ / ends_name, none))
        if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

void SlurmFolder::add_end(const std::string& run, const JobEnd& end) const {
    const fs::path file = ends_file(run);
    const std::string before = fs::is_regular_file(file) ? read_file(file) : ends_heading;
    make_folder(file.parent_path());
    // In one go, as the sweep may read it at any time.
    write_file(file,
               before + fmt::format("{},{:.3f},{:.3f},{:.0f},{},{},{}\n", end.exit_code, end.wall_s, end.processor_s,
                                    end.peak_memory, csv_cell(end.job), end.checkpoint, csv_cell(end.error)));
}

void SlurmFolder::remove_ends(const std::string& run) const { fs::remove(ends_file(run)); }

void SlurmFolder::remove() const {
    if (fs::symlink_status(folder_).type() != fs::file_type::directory) return;
    for (const fs::path& folder : job_folders(folder_)) remove_files(folder, is_jobs_file);
    remove_files(folder_ / ends_name, [](const fs::path& file) { return file.extension() == ".csv"; });
    std::error_code none;
    fs::remove(folder_, none);
}

std::map<std::string, QueuedElement> queued_runs(const std::vector<SubmittedJob>& jobs,
                                                 const std::vector<QueuedElement>& queue) {
    std::map<std::string, QueuedElement> runs;
    for (const QueuedElement& element : queue)
        for (const SubmittedJob& job : jobs) {
            const auto index = static_cast<std::size_t>(element.element - 1);
            if (!job.has(element) || element.element < 1 || index >= job.elements.size()) continue;
            for (const std::string& run : job.elements[index]) runs.insert_or_assign(run, element);
        }
    return runs;
}

}  // namespace dmp::cli
