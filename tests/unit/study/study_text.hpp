// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "study/read_study.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests {

/// Two keys, six runs, two results of good_scene.
inline const std::string good_study = R"(scene = "scene.toml"

[[vary]]
key = "part.leaflets.bending_stiffness"
values = ["1e-6 N*m^2", "3e-6 N*m^2"]

[[vary]]
key = "particles.spacing"
range = { from = "0.1 mm", to = "0.4 mm", steps = 3, scale = "log" }

[[result]]
name = "opening"
measure = "tip_gap"
reduce = "maximum"
from = "2 s"

[[result]]
name = "reached"
measure = "flux_in"
reduce = "first_crossing"
level = "2e-6 m^3/s"
)";

/// good_study with `found` (which must stand in it) replaced once.
inline std::string study_with(const std::string& found, const std::string& replacement) {
    std::string text = good_study;
    const auto at = text.find(found);
    if (at == std::string::npos) throw std::logic_error("the test study has no " + found);
    return text.replace(at, found.size(), replacement);
}

/// The study of this text beside good_scene; `table` becomes table.csv.
inline Study study_of(const std::string& text, const std::string& table = "") {
    const Folder folder;
    Folder::write(good_scene);
    Folder::write(text, "study.toml");
    if (!table.empty()) Folder::write(table, "table.csv");
    return read_study("study.toml");
}

/// What reading it says is wrong.
inline std::string study_fault(const std::string& text, const std::string& table = "") {
    try {
        study_of(text, table);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace dmp::tests
