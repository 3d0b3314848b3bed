// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/study_files.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "report/write_report.hpp"

namespace dmp::report {

namespace {

namespace fs = std::filesystem;

constexpr const char* what_to_do = "'dmp sweep' with --resume writes it again; finished runs are not run again.";

std::string text_of(const fs::path& file, const std::string& lacks, std::vector<std::string>& notes) {
    if (fs::is_regular_file(file)) return read_file(file);
    notes.push_back(file.filename().string() + " is not in the folder: " + lacks);
    return "";
}

/// A table: cells by the names of their columns.
class Table {
  public:
    Table(fs::path file, const std::string& text) : file_(std::move(file)), lines_(text_lines(text)) {
        if (lines_.empty()) return;
        for (const std::string& heading : csv_cells(lines_.front())) {
            names_.push_back(name_and_unit(heading).first);
            units_.push_back(name_and_unit(heading).second);
        }
    }

    [[nodiscard]] std::size_t rows() const { return lines_.empty() ? 0 : lines_.size() - 1; }
    /// None where there is no such column.
    [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const {
        const auto found = std::ranges::find(names_, name);
        if (found == names_.end()) return {};
        return static_cast<std::size_t>(found - names_.begin());
    }
    [[nodiscard]] std::size_t need(const std::string& name) const {
        const auto found = find(name);
        if (!found) throw InputError(where(0), "there is no column '" + name + "'", what_to_do);
        return *found;
    }
    [[nodiscard]] const std::string& unit(std::size_t column) const { return units_[column]; }
    [[nodiscard]] std::vector<std::string> cells(std::size_t row) const {
        std::vector<std::string> cells = csv_cells(lines_[row + 1]);
        if (cells.size() != names_.size())
            throw InputError(where(row + 1), fmt::format("found {} values, expected {}", cells.size(), names_.size()),
                             what_to_do);
        return cells;
    }
    /// NaN where the cell is empty.
    [[nodiscard]] double number(std::size_t row, const std::string& cell) const {
        double value = std::numeric_limits<double>::quiet_NaN();
        if (cell.empty()) return value;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc() || end != cell.data() + cell.size())
            throw InputError(where(row + 1), "'" + cell + "' is not a number", what_to_do);
        return value;
    }

  private:
    [[nodiscard]] SourceLocation where(std::size_t line) const {
        return {file_.string(), static_cast<int>(line) + 1, 0};
    }

    fs::path file_;
    std::vector<std::string> lines_, names_, units_;
};

/// Whether it can be the name of a folder beside others.
bool is_plain_name(const std::string& name) {
    return !name.empty() && name != "." && name != ".." && fs::path(name) == fs::path(name).filename();
}

void read_rows(StudyFiles& study) {
    const fs::path file = study.folder / "results.csv";
    const Table table(file, text_of(file, "no run has ended yet", study.notes));
    study.result_units.assign(study.facts.results.size(), "");
    if (table.rows() == 0) return;
    const std::size_t run = table.need("run"), code = table.need("exit_code"), error = table.need("error");
    std::vector<std::size_t> keys, results;
    for (const StudyFacts::Key& key : study.facts.keys) keys.push_back(table.need(key.name));
    for (std::size_t k = 0; k < study.facts.results.size(); ++k) {
        results.push_back(table.need(study.facts.results[k].name));
        study.result_units[k] = table.unit(results.back());
    }
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const std::vector<std::string> cells = table.cells(i);
        StudyRow& row = study.rows.emplace_back();
        row.run = cells[run];
        for (const std::size_t column : keys) row.values.push_back(cells[column]);
        for (const std::size_t column : results) row.results.push_back(table.number(i, cells[column]));
        row.exit_code = static_cast<int>(table.number(i, cells[code]));
        row.error = cells[error];
        if (row.exit_code != 0 && row.error.empty()) row.error = fmt::format("it ended with code {}", row.exit_code);
        row.has_page =
            is_plain_name(row.run) && fs::is_regular_file(study.folder / "runs" / row.run / report_file_name);
    }
}

void read_timing(StudyFiles& study) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const fs::path file = study.folder / "timing.csv";
    const Table table(file, text_of(file, "the time spent is not known", study.notes));
    StudyTiming& timing = study.timing;
    const auto run = table.find("run"), wall = table.find("wall_time"), processor = table.find("processor_time"),
               memory = table.find("peak_memory");
    if (!wall) timing.wall_s = timing.longest_s = unknown;
    if (!processor) timing.processor_s = unknown;
    if (!memory) timing.peak_memory = unknown;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const std::vector<std::string> cells = table.cells(i);
        ++timing.starts;
        if (wall) {
            const double seconds = table.number(i, cells[*wall]);
            timing.wall_s += seconds;
            if (seconds > timing.longest_s) {
                timing.longest_s = seconds;
                if (run) timing.longest_run = cells[*run];
            }
        }
        if (processor) timing.processor_s += table.number(i, cells[*processor]);
        if (memory) timing.peak_memory = std::max(timing.peak_memory, table.number(i, cells[*memory]));
    }
}

/// `count` of `all` things, evenly spaced, the first and the last among them.
std::vector<std::size_t> evenly_spaced(std::size_t count, std::size_t all) {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < count; ++k) chosen.push_back(count == 1 ? 0 : k * (all - 1) / (count - 1));
    return chosen;
}

/// Those of as many runs as the limits allow, evenly spaced among all that have one.
void read_pictures(StudyFiles& study) {
    struct Found {
        std::size_t row;
        fs::path file;
        std::size_t bytes;
    };
    std::vector<Found> found;
    for (std::size_t row = 0; row < study.rows.size(); ++row) {
        if (!is_plain_name(study.rows[row].run)) continue;
        const fs::path file = study.folder / "runs" / study.rows[row].run / "last_frame.png";
        std::error_code none;
        if (fs::is_regular_file(file, none))
            found.push_back({row, file, static_cast<std::size_t>(fs::file_size(file))});
    }
    for (std::size_t count = std::min(most_run_pictures, found.size()); count > 0; --count) {
        const std::vector<std::size_t> chosen = evenly_spaced(count, found.size());
        std::size_t bytes = 0;
        for (const std::size_t k : chosen) bytes += found[k].bytes;
        if (bytes > most_run_picture_bytes) continue;
        for (const std::size_t k : chosen)
            if (auto picture = read_picture(found[k].file))
                study.pictures.push_back({found[k].row, std::move(*picture)});
            else
                study.notes.push_back(study.rows[found[k].row].run + "/last_frame.png is not a whole PNG file");
        break;
    }
    study.pictures_left_out = found.size() - study.pictures.size();
}

}  // namespace

std::size_t StudyFiles::failed() const {
    return static_cast<std::size_t>(std::ranges::count_if(rows, &StudyRow::failed));
}

StudyFiles read_study_files(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw InputError(SourceLocation{folder.string(), 0, 0}, "there is no such folder",
                         "Name the folder that a study left, e.g. out/vein_valve_study.");
    StudyFiles study;
    study.folder = folder;
    study.facts = read_study_facts(folder);
    study.log = logged_run(text_of(folder / study_log_name, "when it was started is not known", study.notes));
    study.study_text = text_of(folder / "study.toml", "the study's file is missing", study.notes);
    study.scene_text = text_of(folder / "scene.toml", "the scene is missing", study.notes);
    read_rows(study);
    read_timing(study);
    read_pictures(study);
    if (fs::is_regular_file(folder / trade_file_name)) study.trade = read_trade_facts(folder / trade_file_name);
    if (fs::is_regular_file(folder / limits_file_name)) study.limits = read_limits_facts(folder / limits_file_name);
    return study;
}

}  // namespace dmp::report
