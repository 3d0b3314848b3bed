// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A lid that drives the liquid in a square cavity (Ghia, Ghia & Shin 1982), against finite differences.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests {

struct Station {
    Vec point;
    int axis;         ///< of the velocity compared
    double expected;  ///< [U]
};

/// Those inside the cavity at one Reynolds number.
inline std::vector<Station> stations_at(int reynolds) {
    std::ifstream file(DMP_SOURCE_DIR "/tests/data/cavity.csv");
    std::vector<Station> stations;
    for (std::string line; std::getline(file, line);) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        int number = 0;
        std::string what;
        double position = 0, ghia = 0, differences = 0;
        if (!(words >> number >> what >> position >> ghia >> differences) || number != reynolds) continue;
        if (position == 0 || position == 1) continue;
        stations.push_back(what == "u" ? Station{Vec(0.5, position, 0), 0, differences}
                                       : Station{Vec(position, 0.5, 0), 1, differences});
    }
    return stations;
}

/// Averages the velocity at the stations over the frames from a time on: the best linear fit, in the least-squares
/// sense with the weight (1 - r/R)^2, to the particles within R = 3 spacings.
class StationMeans : public FrameSink {
  public:
    StationMeans(std::vector<Station> stations, double from)
        : stations_(std::move(stations)), sums_(stations_.size()), from_(from) {}

    void write(const Frame& frame) override {
        if (frame.time < from_) return;
        ++frames_;
        for (std::size_t s = 0; s < stations_.size(); ++s) sums_[s] += value_at(stations_[s], frame);
    }

    /// Largest difference from what is expected along one line [U].
    [[nodiscard]] double largest_error(int axis) const {
        double largest = 0;
        for (std::size_t s = 0; s < stations_.size(); ++s)
            if (stations_[s].axis == axis)
                largest = std::max(largest, std::abs(sums_[s] / frames_ - stations_[s].expected));
        return largest;
    }

  private:
    static double value_at(const Station& station, const Frame& frame) {
        const FrameGroup& fluid = required_group(frame, "fluid");
        const std::vector<float>& velocity = required_field(fluid, "velocity").values;
        const double reach = 3 * frame.spacing;
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const Eigen::Vector3d base(1, (fluid.position[3 * k] - station.point[0]) / reach,
                                       (fluid.position[3 * k + 1] - station.point[1]) / reach);
            const double distance = std::hypot(base[1], base[2]);
            if (distance >= 1) continue;
            const double weight = (1 - distance) * (1 - distance);
            matrix += weight * base * base.transpose();
            right += weight * velocity[3 * k + static_cast<std::size_t>(station.axis)] * base;
        }
        return matrix.ldlt().solve(right)[0];
    }

    std::vector<Station> stations_;
    std::vector<double> sums_;
    double from_;
    int frames_ = 0;
};

inline void compare_cavity(int reynolds, const std::string& name, const std::vector<std::string>& overrides,
                           double until, double bound) {
    StationMeans means(stations_at(reynolds), 0.8 * until);
    const RunSummary run = run_case("verification/cavity", overrides, until, &means);
    Record record("cavity", name, run);
    record.at_most("u on the vertical line, largest difference over U", means.largest_error(0), bound);
    record.at_most("v on the horizontal line, largest difference over U", means.largest_error(1), bound);
    EXPECT_EQ(run.lost, 0U);
    EXPECT_EQ(run.end.mass, run.start.mass);
}

}  // namespace dmp::tests
