// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "solver/simulation.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// What one run of a case has shown: rows of docs/verification.md. They go into a file of the build folder when the
/// record ends; write_page.py puts them into the page.
class Record {
  public:
    /// `case_name` is a folder of cases/verification/ (or cases/), `setting` what was varied in it.
    Record(const std::string& case_name, const std::string& setting, const RunSummary& run) {
        std::size_t particles = 0;
        for (const auto& [kind, count] : run.particles) particles += count;
        record_ = {{"case", case_name},
                   {"setting", setting},
                   {"particles", particles},
                   {"wall_s", run.wall_s},
                   {"particle_steps_per_s", run.particle_steps_per_s},
                   {"rows", nlohmann::json::array()}};
    }
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;

    ~Record() {
        const std::filesystem::path folder = DMP_BUILD_DIR "/verification";
        std::filesystem::create_directories(folder);
        std::string name = record_["case"].get<std::string>() + "_" + record_["setting"].get<std::string>();
        for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
        std::ofstream(folder / (name + ".json")) << record_.dump(1) << '\n';
    }

    /// Expects |figure| <= bound.
    void at_most(const std::string& quantity, double figure, double bound, const std::string& unit = "") {
        EXPECT_LE(std::abs(figure), bound) << record_["case"] << ", " << record_["setting"] << ": " << quantity;
        add(quantity, figure, "at most", bound, unit);
    }
    /// Expects figure >= bound.
    void at_least(const std::string& quantity, double figure, double bound, const std::string& unit = "") {
        EXPECT_GE(figure, bound) << record_["case"] << ", " << record_["setting"] << ": " << quantity;
        add(quantity, figure, "at least", bound, unit);
    }
    /// The same for fractions that are shown in percent.
    void percent(const std::string& quantity, double figure, double bound) {
        at_most(quantity, 100 * figure, 100 * bound, "%");
    }

  private:
    void add(const std::string& quantity, double figure, const char* side, double bound, const std::string& unit) {
        record_["rows"].push_back(
            {{"quantity", quantity}, {"figure", figure}, {"side", side}, {"bound", bound}, {"unit", unit}});
    }

    nlohmann::json record_;
};

}  // namespace dmp::tests
