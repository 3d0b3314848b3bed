// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_difference.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace dmp::scene {

namespace {

struct Line {
    std::string key, value;
};

constexpr std::string_view before_written = "  # in the scene: ";

/// "[numerics]" -> "numerics", "[[part]]" -> "part"
std::string table_in(const std::string& line) {
    const auto first = line.find_first_not_of('['), last = line.find_last_not_of(']');
    return first == std::string::npos || last < first ? "" : line.substr(first, last - first + 1);
}

std::string without_quotes(const std::string& value) {
    const bool quoted = value.size() > 1 && value.front() == '"' && value.back() == '"';
    return quoted ? value.substr(1, value.size() - 2) : value;
}

/// The lines of a resolved scene, in their order. A table of a list is called by its name, else by its number.
std::vector<Line> lines_of(const std::string& scene) {
    std::vector<Line> lines;
    std::map<std::string, int> tables;
    std::istringstream text(scene);
    std::string table;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("##")) continue;  // a remark
        if (line.starts_with("# ")) line.erase(0, 2);
        if (line.starts_with("[")) {
            table = table_in(line);
            if (line.starts_with("[[")) table += "." + std::to_string(++tables[table]);
            continue;
        }
        const auto equals = line.find(" = ");
        if (equals == std::string::npos) continue;
        std::string key = line.substr(0, equals), value = line.substr(equals + 3);
        if (const auto comment = value.rfind(before_written); comment != std::string::npos)
            value.erase(0, comment + before_written.size());
        // The name is the first line of its table.
        const auto number = table.rfind('.');
        if (key == "name" && number != std::string::npos)
            table.replace(number + 1, std::string::npos, without_quotes(value));
        lines.push_back({table.empty() ? key : table + "." + key, std::move(value)});
    }
    std::erase_if(lines, [](const Line& line) { return line.key == "run.threads"; });
    return lines;
}

/// Whether the state at some time depends on it.
bool is_of_state(const std::string& key) {
    if (key == "output.average_from") return true;
    return key != "title" && key != "run.duration" && !key.starts_with("output.") && !key.starts_with("measure.") &&
           !key.starts_with("reference.");
}

std::vector<Line> lines_of_state(const std::string& scene) {
    std::vector<Line> lines = lines_of(scene);
    std::erase_if(lines, [](const Line& line) { return !is_of_state(line.key); });
    return lines;
}

std::string value_text(const std::string& value) { return value.empty() ? "not set" : value; }

std::vector<ValueDifference> differences(const std::vector<Line>& old_lines, const std::vector<Line>& new_lines) {
    std::map<std::string, std::string> old_values, new_values;
    for (const Line& line : old_lines) old_values.emplace(line.key, line.value);
    for (const Line& line : new_lines) new_values.emplace(line.key, line.value);
    std::vector<ValueDifference> found;
    for (const auto& [key, value] : new_lines) {
        const auto old_value = old_values.find(key);
        if (old_value == old_values.end())
            found.push_back({key, "", value});
        else if (old_value->second != value)
            found.push_back({key, old_value->second, value});
    }
    for (const auto& [key, value] : old_lines)
        if (!new_values.contains(key)) found.push_back({key, value, ""});
    // Parts and other items are numbered in their order.
    const auto same = [](const Line& a, const Line& b) { return a.key == b.key && a.value == b.value; };
    if (found.empty() && !std::ranges::equal(old_lines, new_lines, same))
        found.push_back({"order of the tables", "another", "that of the scene"});
    return found;
}

/// The lines of the measures that are in `others` too, by key.
std::vector<Line> lines_of_measures_in(const std::vector<Line>& others, std::vector<Line> lines) {
    const auto measure_of = [](const Line& line) { return line.key.substr(0, line.key.rfind('.')); };
    std::set<std::string> names;
    for (const Line& line : others) names.insert(measure_of(line));
    std::erase_if(lines, [&](const Line& line) {
        return !line.key.starts_with("measure.") || !names.contains(measure_of(line));
    });
    std::ranges::sort(lines, {}, &Line::key);
    return lines;
}

/// Measures may come and go, but one that is in both under the same name must be the same: its column goes on.
std::vector<ValueDifference> differences_in_measures(const std::vector<Line>& old_lines,
                                                     const std::vector<Line>& new_lines) {
    return differences(lines_of_measures_in(new_lines, old_lines), lines_of_measures_in(old_lines, new_lines));
}

}  // namespace

std::string with_values_of(const std::string& written, const std::string& as_run) {
    std::istringstream written_lines(written), run_lines(as_run);
    std::string text;
    for (std::string line, original; std::getline(run_lines, line) && std::getline(written_lines, original);) {
        text += line;
        if (line != original) text.append(before_written).append(original, original.find(" = ") + 3);
        text += '\n';
    }
    if (std::string rest; std::getline(written_lines, rest) || std::getline(run_lines, rest))
        throw std::logic_error("a scene as it was run has other keys than the scene");
    return text;
}

std::vector<ValueDifference> differences(const std::string& before, const std::string& now) {
    return differences(lines_of(before), lines_of(now));
}

std::vector<ValueDifference> differences_in_state(const std::string& before, const std::string& now) {
    std::vector<Line> old_lines = lines_of_state(before), new_lines = lines_of_state(now);
    const auto never = [](const Line& line) { return line.key == "run.until_steady" && line.value == "\"0 s\""; };
    if (std::ranges::any_of(new_lines, never))
        for (std::vector<Line>* lines : {&old_lines, &new_lines})
            std::erase_if(*lines, [](const Line& line) { return line.key == "run.until_steady"; });
    std::vector<ValueDifference> found = differences(old_lines, new_lines);
    std::ranges::move(differences_in_measures(lines_of(before), lines_of(now)), std::back_inserter(found));
    return found;
}

std::string differences_text(const std::vector<ValueDifference>& differences) {
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, differences.size()); ++k) {
        const ValueDifference& one = differences[k];
        text += "\n  " + one.key + ": was " + value_text(one.before) + ", is " + value_text(one.now);
    }
    if (differences.size() > most) text += "\n  and " + std::to_string(differences.size() - most) + " more";
    return text;
}

}  // namespace dmp::scene
