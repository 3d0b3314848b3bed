// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// The vein valve with coarse particles: a second of computing, with fluid, walls, springs and measures.
class SmallValve : public testing::Test {
  protected:
    using Words = std::vector<std::string>;

    SmallValve() { folder_.copy_case("vein_valve"); }

    /// dmp run on it, to the output folder `out`.
    [[nodiscard]] Outcome run(const std::string& out, const Words& more = {}, const Surroundings& with = {}) const {
        Words words = on_scene("run", out);
        for (const auto& [option, value] : std::map<std::string, std::string>{{"--until", "0.1 s"}, {"--threads", "1"}})
            if (std::ranges::find(more, option) == more.end()) words.insert(words.end(), {option, value});
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words, with);
    }

    /// A run that gets a signal when its frame at 0.05 s is there.
    [[nodiscard]] Outcome stopped_run(const std::string& out, const Words& more = {}, int ranks = 0,
                                      int signal = SIGTERM, const std::string& frame = "fluid_000005.vtp") const {
        return run(out, more, {.interrupt_at = out + "/frames/" + frame, .signal = signal, .ranks = ranks});
    }

    /// dmp mesh on it, to the output folder `out`.
    [[nodiscard]] Outcome mesh(const std::string& out, const Words& more = {}) const {
        Words words = on_scene("mesh", out);
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words);
    }

    [[nodiscard]] nlohmann::json summary(const std::string& out) const {
        return nlohmann::json::parse(folder_.read(out + "/summary.json"));
    }
    [[nodiscard]] std::string hash(const std::string& out) const { return summary(out)["state_hash"]; }
    /// Names of the files in a folder, sorted.
    [[nodiscard]] Words files(const std::string& name) const {
        Words found;
        if (std::filesystem::is_directory(folder_.path() / name))
            for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / name))
                found.push_back(entry.path().filename().string());
        std::ranges::sort(found);
        return found;
    }
    /// Puts two regions into the scene; the words that ask for every field that frames can have.
    [[nodiscard]] Words all_fields() const {
        folder_.write("scene.toml", folder_.read("scene.toml") + R"(
[[region]]
name = "inlet"
from = ["-40 mm", "-4 mm"]
to = ["-20 mm", "4 mm"]

[[region]]
name = "sinus"
from = [0, 0]
to = ["20 mm", "15 mm"]
)");
        return {
            "--set",
            "output.fields=['velocity', 'pressure', 'density', 'shear_stress', 'stress', 'von_mises', 'vorticity', "
            "'residence_time']",
            "--set",
            "output.solid_fields=['velocity', 'displacement', 'mean_displacement', 'stress', 'von_mises', 'strain', "
            "'force']",
            "--set",
            "output.average_from=\"25 ms\""};
    }
    void copy(const std::string& from, const std::string& to) const {
        std::filesystem::copy(folder_.path() / from, folder_.path() / to, std::filesystem::copy_options::recursive);
    }

    CaseFolder folder_;

  private:
    static Words on_scene(const std::string& command, const std::string& out) {
        return {command, ".",
                "--set", "particles.spacing=\"0.5 mm\"",
                "--set", "output.every=\"10 ms\"",
                "--set", "output.pictures=false",
                "--out", out};
    }
};

}  // namespace dmp::tests
