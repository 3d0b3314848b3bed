// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "scene/read_scene.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// A complete small scene with a fluid, a wall, an elastic solid and two measures.
inline const std::string good_scene = R"(schema = 1
title = "Test"

[geometry]
file = "channel.geo"

[particles]
spacing = "0.1 mm"

[[part]]
name = "blood"
kind = "fluid"
density = "1056 kg/m^3"
viscosity = "3.5 mPa*s"

[[part]]
name = "wall"
kind = "rigid"

[[part]]
name = "leaflets"
kind = "elastic"
bending_stiffness = "3e-6 N*m^2"
axial_stiffness = "100 N"
mass_per_length = "0.42 kg/m"

[flow]
largest_speed = "0.2 m/s"

[run]
duration = "4 s"

[output]
every = "20 ms"

[[measure]]
name = "flux_in"
kind = "flux"
from = ["0 mm", "-4 mm"]
to = ["0 mm", "4 mm"]

[[measure]]
name = "tip_gap"
kind = "gap"
part = "leaflets"
)";

/// good_scene with `found` (which must stand in it) replaced once.
inline std::string scene_with(const std::string& found, const std::string& replacement) {
    std::string text = good_scene;
    const auto at = text.find(found);
    if (at == std::string::npos) throw std::logic_error("the test scene has no " + found);
    return text.replace(at, found.size(), replacement);
}

/// An empty folder of this test that goes away with it; the current folder while it lives, so that messages show the
/// file as "scene.toml".
class Folder {
  public:
    Folder() : before_(std::filesystem::current_path()) {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string("dmp_") + info->test_suite_name() + "_" + info->name();
        for (char& c : name) c = c == '/' ? '_' : c;
        path_ = std::filesystem::path(testing::TempDir()) / name;
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
        std::filesystem::current_path(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code none;
        std::filesystem::current_path(before_, none);
        std::filesystem::remove_all(path_, none);
    }

    static void write(const std::string& text, const std::string& file = "scene.toml") {
        std::ofstream(file, std::ios::binary) << text;
    }

  private:
    std::filesystem::path before_;
    std::filesystem::path path_;
};

inline Scene read_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
    const Folder folder;
    Folder::write(text);
    return read_scene("scene.toml", overrides);
}

/// What reading the text says is wrong: "scene.toml:8:11: ...\n  what to do".
inline std::string fault_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        read_text(text, overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace dmp::tests
