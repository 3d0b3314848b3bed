// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "models/dem/escape_model.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_escape_model_tests {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

EscapeModel model(EscapeModel::Form form, double friction, bool thesis_stiffness = false) {
    EscapeModel made;
    made.form = form;
    made.friction = friction;
    made.normal_stiffness = thesis_stiffness ? EscapeModel::thesis_stiffness(2.15e9, 0.3)
                                             : EscapeModel::hertz_stiffness(63e9, 0.24, 2.15e9, 0.3);
    return made;
}

std::string text(double value, int digits) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
    return std::string(buffer.data()) == "-nan" ? "nan" : buffer.data();
}

TEST(EscapeModel, as_printed_gives_the_reference_grid_to_its_printed_digits) {
    std::ifstream file(DMP_SOURCE_DIR "/tests/data/eta_grid_ch7.csv");
    std::string line;
    std::getline(file, line);  // where it is from
    std::getline(file, line);  // the columns
    int rows = 0;
    while (std::getline(file, line)) {
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        ASSERT_EQ(cells.size(), 10U) << line;
        const EscapeModel its = model(EscapeModel::Form::printed, std::stod(cells[1]), cells[0] == "eq7_5_API");
        const auto found = its.escape(std::stod(cells[2]) * std::sin(std::stod(cells[3]) / degrees));
        const std::vector<std::string> printed{text(found.south_angle * degrees, 3),
                                               text(found.north_latitude * degrees, 3),
                                               text(found.south, 4),
                                               text(found.north, 4),
                                               text(found.north_zone, 4),
                                               text(found.fraction(), 4)};
        EXPECT_EQ(printed, std::vector<std::string>(cells.begin() + 4, cells.end())) << line;
        ++rows;
    }
    EXPECT_EQ(rows, 1280);
}

TEST(EscapeModel, has_the_stiffness_overlap_and_first_velocity_of_the_paper) {
    const EscapeModel printed = model(EscapeModel::Form::printed, 0.3);
    EXPECT_NEAR(printed.normal_stiffness, 3.043e9, 1e6);
    EXPECT_NEAR(printed.rest_overlap(), 1.4454e-9, 1e-13);
    EXPECT_NEAR(printed.first_escape(), 0.2137, 1e-4);
    EXPECT_NEAR(model(EscapeModel::Form::printed, 0.3, true).first_escape(), 0.2007, 1e-4);
}

TEST(EscapeModel, corrected_frees_the_pole_where_kinetic_energy_equals_the_work) {
    // 1/2 m v^2 = F_c (16 z0 / 7 + 0.6 d): 0.1044 m/s.
    const EscapeModel its = model(EscapeModel::Form::corrected, 0.3);
    EXPECT_NEAR(its.first_escape(), 0.1044, 1e-4);
    EXPECT_EQ(its.escape(0.999 * its.first_escape()).fraction(), 0);
    EXPECT_GT(its.escape(1.001 * its.first_escape()).fraction(), 0);
    EXPECT_LT(its.escape(1.001 * its.first_escape()).fraction(), 0.3);
}

TEST(EscapeModel, corrected_south_uses_up_its_energy_at_the_angle_it_names) {
    const EscapeModel its = model(EscapeModel::Form::corrected, 0.5);
    const double u = 0.3, d = its.rest_overlap();
    const double phi = its.escape(u).south_angle;
    ASSERT_GT(phi, 0.1);
    ASSERT_LT(phi, 1.57);
    const double slid = its.carrier_radius * (phi - std::asin((1 - d / its.carrier_radius) * std::sin(phi)));
    EXPECT_NEAR(0.5 * its.particle_mass * u * u, its.work_to_lift() + 0.5 * its.pull_off_force * slid, 1e-22);
    // Away from the equator the printed tangent is its series.
    const double small = 0.3;
    EXPECT_NEAR(its.carrier_radius * (small - std::asin((1 - d / its.carrier_radius) * std::sin(small))),
                d * std::tan(small), 1e-4 * d);
}

TEST(EscapeModel, corrected_loses_all_at_high_speed_and_more_at_any_than_slower) {
    const EscapeModel its = model(EscapeModel::Form::corrected, 0.3);
    double before = -1;
    for (double u = 0.05; u < 30; u *= 1.1) {
        const double fraction = its.escape(u).fraction();
        EXPECT_GE(fraction, before) << u;
        EXPECT_LE(fraction, 1);
        before = fraction;
    }
    EXPECT_GT(before, 0.999);
}

}  // namespace
}  // namespace dmp::tests::solver_escape_model_tests
