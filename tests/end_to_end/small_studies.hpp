// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/csv.hpp"
#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests {

/// The vein valve with coarse particles: four runs, of which the last two cannot be meshed.
class Studies : public SmallValve {
  protected:
    Studies() {
        folder_.replace("scene.toml", "spacing = \"0.2 mm\"", "spacing = \"0.8 mm\"");
        folder_.replace("scene.toml", "duration = \"4 s\"", "duration = \"0.2 s\"");
        folder_.replace("scene.toml", "every = \"40 ms\"", "every = \"10 ms\"\npictures = false");
        folder_.write("valve.toml", R"(scene = "scene.toml"

[[vary]]
key = "particles.spacing"
values = ["0.8 mm", "30 mm"]

[[vary]]
key = "part.blood.viscosity"
values = ["3.5 mPa*s", "4 mPa*s"]

[[result]]
name = "fastest"
measure = "largest_speed"
reduce = "maximum"

[[result]]
name = "volume"
measure = "inlet_flux"
reduce = "integral"
from = "0.05 s"
)");
    }

    [[nodiscard]] Outcome sweep(const std::string& out, const Words& more = {}, const Surroundings& with = {}) const {
        Words words{"sweep", "valve.toml", "--out", out};
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words, with);
    }
    /// The cells of results.csv, without its heading.
    [[nodiscard]] std::vector<Words> table(const std::string& out) const {
        std::vector<Words> rows;
        std::istringstream lines(folder_.read(out + "/results.csv"));
        for (std::string line; std::getline(lines, line);) rows.push_back(csv_cells(line));
        if (!rows.empty()) rows.erase(rows.begin());
        return rows;
    }
    /// Names of the runs that have a folder.
    [[nodiscard]] Words runs(const std::string& out) const {
        Words names;
        for (const std::string& name : files(out + "/runs"))
            if (name.find('.') == std::string::npos) names.push_back(name);  // no log, nor a file that is being written
        return names;
    }
    /// Whether the study's run with this number has its frame at 0.05 s.
    [[nodiscard]] bool is_half_way(const std::string& out, const std::string& number) const {
        const Words names = runs(out);
        return std::ranges::any_of(names, [&](const std::string& name) {
            return name.starts_with(number) &&
                   std::filesystem::exists(folder_.path() / out / "runs" / name / "frames/fluid_000005.vtp");
        });
    }
    /// A study that is ended by a signal in the middle of its second run.
    [[nodiscard]] Outcome ended_sweep(const std::string& out, int signal, const Words& more = {"--jobs", "1"}) const {
        return sweep(out, more, {.interrupt_when = [this, out] { return is_half_way(out, "0002"); }, .signal = signal});
    }
    [[nodiscard]] double maximum(const std::string& run, const std::string& measure) const {
        return summary(run)["measures"][measure]["max"];
    }
};

}  // namespace dmp::tests
