// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "geometry/geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// A folder of its own for each test, removed afterwards.
class GeometryFileTest : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("dmp_" + std::string(test->test_suite_name()) + "_" + test->name() + "_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

    [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name)) << text;
        return path(name);
    }

    [[nodiscard]] static GeometryOptions options_for(const std::string& file) {
        GeometryOptions options;
        options.file = file;
        options.location = {.file = "scene.toml", .line = 6, .column = 8};
        return options;
    }

    /// Reads a script that lies in the test's folder.
    [[nodiscard]] Geometry read(const std::string& text) const {
        return read_geometry(options_for(write("domain.geo", text)));
    }

  private:
    std::filesystem::path folder_;
};

/// A unit square, corners (0, 0) to (1, 1), as surface 1 of curves 1 to 4.
inline const std::string unit_square =
    "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nPoint(3) = {1, 1, 0};\nPoint(4) = {0, 1, 0};\n"
    "Line(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\n"
    "Curve Loop(1) = {1, 2, 3, 4};\nPlane Surface(1) = {1};\n";

}  // namespace dmp::tests
