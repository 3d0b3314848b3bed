// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "solver/results/frame.hpp"

namespace dmp::solver {

/// Describes why a group cannot be stored, or "": array lengths that do not match the number of particles or bonds,
/// numbers of components other than 1, 3 and 6, a bond to a particle outside the group.
inline std::string problem_with(const FrameGroup& group) {
    const auto length = [&](const std::string& what, std::size_t found, std::size_t expected) {
        return found == expected ? std::string()
                                 : "frame group '" + group.name + "': " + what + " has " + std::to_string(found) +
                                       " values, expected " + std::to_string(expected);
    };
    std::string problem = length("position", group.position.size(), 3 * group.size());
    if (problem.empty()) problem = length("part", group.part.size(), group.size());
    if (problem.empty()) problem = length("bond_ends", group.bond_ends.size(), 2 * group.bonds());
    const auto look_at = [&](const FrameField& field, std::size_t count) {
        if (!problem.empty()) return;
        if (field.components != 1 && field.components != 3 && field.components != 6)
            problem = "frame group '" + group.name + "': field " + field.name + " has " +
                      std::to_string(field.components) + " components, expected 1, 3 or 6";
        else
            problem =
                length("field " + field.name, field.values.size(), count * static_cast<std::size_t>(field.components));
    };
    for (const FrameField& field : group.fields) look_at(field, group.size());
    for (const FrameField& field : group.bond_fields) look_at(field, group.bonds());
    const auto outside = [&](std::int32_t end) { return end < 0 || static_cast<std::size_t>(end) >= group.size(); };
    if (problem.empty() && std::any_of(group.bond_ends.begin(), group.bond_ends.end(), outside))
        problem = "frame group '" + group.name + "': a bond refers to a particle outside the group";
    if (problem.empty() && (group.triangles.size() % 3 != 0 || std::ranges::any_of(group.triangles, outside)))
        problem = "frame group '" + group.name + "': a triangle refers to a particle outside the group";
    return problem;
}

}  // namespace dmp::solver
