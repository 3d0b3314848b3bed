// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/written_study.hpp"

#include <fmt/format.h>

#include "scene/toml_node.hpp"

namespace dmp::study {

namespace fs = std::filesystem;

std::string key_set_by(const std::string& assignment) {
    const std::string key = assignment.substr(0, assignment.find('='));
    const auto first = key.find_first_not_of(" \t");
    return first == std::string::npos ? "" : key.substr(first, key.find_last_not_of(" \t") - first + 1);
}

std::map<std::string, std::string> values_set(const std::vector<std::string>& overrides) {
    std::map<std::string, std::string> values;
    for (const std::string& each : overrides)
        if (const std::string key = key_set_by(each); key != "run.threads")
            values[key] = toml_text(parse_toml_value(each.substr(each.find('=') + 1), {}));
    return values;
}

std::string study_text(const WrittenStudy& study, const fs::path& folder) {
    std::vector<std::string> left_out;
    for (const RunOutput each : study.left_out) left_out.push_back(toml_quoted(to_string(each)));
    std::string text = "# " + study.comment + "\ntitle = " + toml_quoted(study.title) +
                       "\npurpose = " + toml_quoted(study.purpose) + "\nscene = " +
                       toml_quoted(fs::absolute(study.scene)
                                       .lexically_normal()
                                       .lexically_proximate(fs::absolute(folder).lexically_normal())
                                       .string()) +
                       fmt::format("\ncombine = \"zip\"\nleave_out = [{}]\n", fmt::join(left_out, ", "));
    for (const auto& [key, values] : study.columns)
        text += "\n[[vary]]\nkey = " + toml_quoted(key) + fmt::format("\nvalues = [{}]\n", fmt::join(values, ", "));
    return text;
}

}  // namespace dmp::study
