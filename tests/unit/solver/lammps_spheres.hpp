// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "models/dem/contact.hpp"
#include "models/dem/contact_constants.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// What LAMMPS found for spheres in contact (tests/peers/lammps_spheres).
struct LammpsSpheres {
    using V3 = Vector<double, 3>;
    struct State {
        std::vector<V3> position, velocity, spin, force, torque;
    };
    std::vector<double> radius, mass;
    State start, end;
    int steps = 0;
    double dt = 0;
    ContactConstants<> pair;

    [[nodiscard]] std::size_t size() const { return radius.size(); }
};

inline LammpsSpheres read_lammps_spheres(const std::filesystem::path& file) {
    LammpsSpheres spheres;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream text(line);
        std::string kind;
        text >> kind;
        if (kind == "step") text >> spheres.steps >> spheres.dt;
        if (kind == "law") {
            ContactConstants<>& pair = spheres.pair;
            text >> pair.normal_stiffness >> pair.tangential_stiffness >> pair.normal_rate >> pair.tangential_rate >>
                pair.friction;
        }
        if (kind == "sphere") {
            spheres.radius.push_back(0);
            spheres.mass.push_back(0);
            text >> spheres.radius.back() >> spheres.mass.back();
            for (LammpsSpheres::State* state : {&spheres.start, &spheres.end})
                for (auto* values : {&state->position, &state->velocity, &state->spin, &state->force, &state->torque}) {
                    LammpsSpheres::V3 v{};
                    text >> v[0] >> v[1] >> v[2];
                    values->push_back(v);
                }
        }
        EXPECT_FALSE(text.fail()) << line;
    }
    return spheres;
}

}  // namespace dmp::tests
