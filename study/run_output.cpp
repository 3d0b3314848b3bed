// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/run_output.hpp"

#include <algorithm>
#include <string>

#include "scene/value_types.hpp"

namespace dmp::study {

std::optional<RunOutput> run_output_called(std::string_view name) {
    const auto found = std::ranges::find(enum_names<RunOutput>, name);
    if (found == enum_names<RunOutput>.end()) return {};
    return static_cast<RunOutput>(found - enum_names<RunOutput>.begin());
}

LeftOut read_left_out(const TomlNode& list, const std::string& path) {
    if (!list.is_array())
        throw wrong_kind(list, path, "a list of outputs", "write for example " + path + " = [\"pictures\", \"page\"]");
    LeftOut outputs;
    for (const TomlNode& item : list.children) outputs.insert(one_of<RunOutput>().read(item, path));
    return outputs;
}

}  // namespace dmp::study
