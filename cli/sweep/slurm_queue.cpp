// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/slurm_queue.hpp"

#include <algorithm>
#include <charconv>
#include <regex>

#include <unistd.h>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "base/text_lines.hpp"
#include "cli/sweep/other_program.hpp"

namespace dmp::cli {

namespace {

/// Array's job, element, state, reason, script; the last one may hold anything.
constexpr const char* queue_format = "%F|%K|%t|%r|%o";

/// What a pattern's group finds; "" where it does not.
std::string found(const std::string& text, const char* pattern) {
    std::smatch match;
    return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "";
}

std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text;
}

/// What it said against it; its exit code where it said nothing.
std::string complaint(const ProgramOutput& said) {
    const std::string errors = trimmed(said.errors);
    return errors.empty() ? "it ended with code " + std::to_string(said.exit_code) : errors;
}

}  // namespace

std::vector<QueuedElement> read_queue(const std::string& text) {
    std::vector<QueuedElement> elements;
    for (const std::string& line : text_lines(text)) {
        std::vector<std::string> cells;
        std::size_t begin = 0;
        for (std::size_t bar = line.find('|'); cells.size() < 4 && bar != std::string::npos;
             bar = line.find('|', begin)) {
            cells.push_back(line.substr(begin, bar - begin));
            begin = bar + 1;
        }
        if (cells.size() < 4) continue;
        QueuedElement element{cells[0], 0, cells[2], cells[3], line.substr(begin)};
        const char* const end = cells[1].data() + cells[1].size();
        if (const auto read = std::from_chars(cells[1].data(), end, element.element);
            read.ec == std::errc{} && read.ptr == end)
            elements.push_back(std::move(element));
    }
    return elements;
}

std::size_t largest_element(const std::string& configuration) {
    constexpr std::size_t usual = 1001;  // where Slurm's configuration does not say it
    const std::string text = found(configuration, "MaxArraySize\\s*=\\s*([0-9]{1,9})");
    const std::size_t size = text.empty() ? usual : std::stoul(text);
    return std::max<std::size_t>(size, 2) - 1;
}

JobState read_job_state(const std::string& text) {
    const std::string reason = found(text, "\\bReason=(\\S+)");
    return {found(text, "\\bJobState=(\\S+)"), reason == "None" ? "" : reason};
}

SlurmQueue::SlurmQueue() {
    for (const char* program : {"sbatch", "squeue", "scontrol"})
        if (program_path(program).empty())
            throw InputError(
                "there is no '" + std::string(program) + "' on this machine: --slurm hands the runs to Slurm",
                "Give the command on a machine of the cluster that jobs are submitted from, after "
                "loading Slurm's module where it has one.\nWithout --slurm the runs go on this machine.");
}

std::optional<SlurmQueue> SlurmQueue::if_there() {
    if (program_path("squeue").empty() || program_path("scontrol").empty()) return {};
    return SlurmQueue(Unchecked{});
}

SlurmQueue::Answer SlurmQueue::submit(const std::filesystem::path& script) const {
    const ProgramOutput said = output_of({"sbatch", "--parsable", script.string()});
    const std::string job = found(said.output, "^([0-9]+)");  // "123", or "123;cluster"
    if (said.exit_code != 0 || job.empty()) return {"", complaint(said)};
    return {job, ""};
}

std::optional<std::vector<QueuedElement>> SlurmQueue::elements(std::string& problem) const {
    const ProgramOutput said = output_of({"squeue", "--noheader", "--array", "--user=" + std::to_string(getuid()),
                                          "--format=" + std::string(queue_format)});
    problem = said.exit_code == 0 ? "" : complaint(said);
    if (said.exit_code != 0) return {};
    return read_queue(said.output);
}

JobState SlurmQueue::state_of(const std::string& job, long element) const {
    return read_job_state(
        output_of({"scontrol", "--oneliner", "show", "job", job + "_" + std::to_string(element)}).output);
}

std::size_t SlurmQueue::most_elements() const {
    return largest_element(output_of({"scontrol", "show", "config"}).output);
}

}  // namespace dmp::cli
