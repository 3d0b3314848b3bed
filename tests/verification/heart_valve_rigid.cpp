// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/heart_valve/rigid.toml: the jet between rigid leaflets, beside the solution on a grid in tests/data.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::heart_valve_rigid_tests {
namespace {

constexpr double half_width = 12.5e-3;                          // of the vessel [m]
constexpr double throat = -5.7974e-3, throat_half = 1.8281e-3;  // the narrowest place: x, and y of the leaflet [m]
constexpr double band = 0.15e-3;                                // particles that are as near to the section count [m]
constexpr int least_samples =
    10;  // of a bin that counts: no particle is in the first one, half a spacing beside the axis
constexpr std::size_t bins = 12, clear_bins = 10;  // from the axis to the leaflet; those two bins off it

/// y and u along a section of the grid's solution for an inflow of 0.2 m/s.
std::vector<std::array<double, 2>> grid_section(const std::string& section) {
    std::ifstream file(DMP_SOURCE_DIR "/tests/data/heart_valve_grid_sections.csv");
    std::vector<std::array<double, 2>> rows;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("0.2," + section + ",")) continue;
        std::istringstream cells(line);
        std::vector<double> numbers;
        for (std::string cell; std::getline(cells, cell, ',');)
            numbers.push_back(numbers.size() == 1 ? 0 : std::stod(cell.empty() ? "nan" : cell));
        rows.push_back({1e-3 * numbers.at(3), numbers.at(5)});
    }
    if (rows.empty()) throw std::logic_error("no section " + section);
    return rows;
}

double at(const std::vector<std::array<double, 2>>& rows, double y) {
    const auto after = std::ranges::find_if(rows, [&](const auto& row) { return row[0] >= y; });
    if (after == rows.begin() || after == rows.end()) return rows.front()[1];
    const auto& [low, high] = std::pair(*(after - 1), *after);
    return low[1] + (high[1] - low[1]) * (y - low[0]) / (high[0] - low[0]);
}

/// Means over the bins, over the mean inflow.
std::array<double, bins> on_the_grid() {
    const auto inlet = grid_section("inlet"), section = grid_section("throat");
    double flux = 0;
    for (std::size_t k = 1; k < inlet.size(); ++k)
        flux += (inlet[k][0] - inlet[k - 1][0]) * (inlet[k][1] + inlet[k - 1][1]) / 2;
    std::array<double, bins> means{};
    constexpr int points = 20;  // in a bin
    for (std::size_t k = 0; k < bins; ++k)
        for (int n = 0; n < points; ++n)
            means[k] += at(section, throat_half * (static_cast<double>(k) + (n + 0.5) / points) / bins) / points /
                        (flux / half_width);
    return means;
}

/// Velocities of the particles beside the section, by frame and bin.
class AtThroat : public FrameSink {
  public:
    struct Moment {
        double time;
        std::array<double, bins> sum{};
        std::array<int, bins> count{};
    };

    void write(const Frame& frame) override {
        Moment moment{frame.time, {}, {}};
        const auto fluid = std::ranges::find(frame.groups, "fluid", &FrameGroup::name);
        const auto velocity = std::ranges::find(fluid->fields, "velocity", &FrameField::name);
        for (std::size_t i = 0; i < fluid->size(); ++i) {
            const double x = fluid->position[3 * i], y = fluid->position[3 * i + 1];
            if (std::abs(x - throat) >= band || y < 0 || y >= throat_half) continue;
            const auto bin = static_cast<std::size_t>(y / throat_half * bins);
            moment.sum[bin] += static_cast<double>(velocity->values[3 * i]);
            ++moment.count[bin];
        }
        moments.push_back(moment);
    }

    std::vector<Moment> moments;
};

TEST(RigidHeartValve, HasTheJetOfTheGridsSolution) {
    AtThroat jet;
    const RunSummary run =
        run_case("heart_valve/rigid.toml", {"output.every=\"0.1333333 ms\"", "run.duration=\"0.12 s\""}, 0.12, &jet, 1);
    const auto flux = column(run.measures, "inlet_flux");
    const auto mean_inflow = [&](double time) {
        const auto& times = run.measures.time;
        const auto after = std::ranges::lower_bound(times, time) - times.begin();
        return flux.at(std::min(static_cast<std::size_t>(after), flux.size() - 1)) / half_width;
    };
    std::array<double, bins> found{};
    std::array<int, bins> count{};
    for (const auto& moment : jet.moments) {
        if (moment.time < 0.1) continue;
        for (std::size_t k = 0; k < bins; ++k) {
            found[k] += moment.sum[k] / mean_inflow(moment.time);
            count[k] += moment.count[k];
        }
    }
    const std::array<double, bins> grid = on_the_grid();
    const double peak_on_grid = std::ranges::max(grid);
    double peak = 0, squares = 0, samples = 0;
    for (std::size_t k = 0; k < clear_bins; ++k) {
        if (count[k] < least_samples) continue;
        found[k] /= count[k];
        peak = std::max(peak, found[k]);
        squares += count[k] * std::pow(found[k] - grid[k], 2);
        samples += count[k];
    }
    ASSERT_GT(samples, 200);
    Record record("heart_valve", "rigid leaflets, 0.2 m/s, 0.5 mm", run);
    record.percent("peak at the narrowest place, off the grid's", peak / peak_on_grid - 1, 0.07);
    record.percent("profile there, to 0.3 mm from the leaflet, root mean square",
                   std::sqrt(squares / samples) / peak_on_grid, 0.06);
    EXPECT_EQ(run.lost, 0U);
}

}  // namespace
}  // namespace dmp::tests::heart_valve_rigid_tests
