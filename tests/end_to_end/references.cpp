// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a run says, writes and shows of how far its measures are from what the scene says that they should be.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::references_tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double pi = std::numbers::pi, steady = 12.5e-6;

/// Velocity at half the width, with so many terms that none is missing.
double start_up(double t) {
    double sum = 0;
    for (int n = 0; n < 2000; ++n) {
        const double odd = 2 * n + 1;
        sum += (n % 2 == 0 ? 1 : -1) / std::pow(odd, 3) * std::exp(-odd * odd * pi * pi * t);
    }
    return steady * (1 - 32 / std::pow(pi, 3) * sum);
}

struct Row {
    double time, x;
};

std::vector<Row> rows_of(const std::string& csv) {
    std::istringstream lines(csv);
    std::vector<Row> rows;
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);)
        rows.push_back({std::stod(line), std::stod(line.substr(line.find(',') + 1))});
    return rows;
}

class RunWithReferences : public testing::Test {
  protected:
    RunWithReferences() { folder_.copy_case("verification/poiseuille"); }

    [[nodiscard]] Outcome run(const std::string& scene, const std::string& out,
                              const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"run", scene, "--out", out, "--threads", "1", "--set", "output.pictures=false"};
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words);
    }
    [[nodiscard]] nlohmann::json references(const std::string& out) const {
        return nlohmann::json::parse(folder_.read(out + "/summary.json"))["references"];
    }

    CaseFolder folder_;
};

TEST_F(RunWithReferences, TellsHowFarItIsFromThem) {
    const Outcome outcome = run(".", "out");
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output,
                testing::ContainsRegex("  centre_velocity_x: 0\\.[0-9]+ % from its reference \\(series solution, "
                                       "Morris, Fox & Zhu 1997\\)\n"));
    const nlohmann::json json = references("out");
    ASSERT_EQ(json.size(), 2U);
    EXPECT_EQ(json[0]["measure"], "centre_velocity");
    EXPECT_EQ(json[0]["column"], "centre_velocity_x");
    EXPECT_EQ(json[0]["source"], "series solution, Morris, Fox & Zhu 1997");

    // Independently, from the rows; of straight lines between them.
    const std::vector<Row> rows = rows_of(folder_.read("out/measures.csv"));
    ASSERT_GT(rows.size(), 30U);
    double difference = 0, square = 0, size = 0, area = 0, size_area = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double dt = rows[i].time - rows[i - 1].time;
        const double a = rows[i - 1].x - start_up(rows[i - 1].time), b = rows[i].x - start_up(rows[i].time);
        const double c = start_up(rows[i - 1].time), d = start_up(rows[i].time);
        square += dt * (a * a + a * b + b * b) / 3;
        size += dt * (c * c + c * d + d * d) / 3;
        area += dt * (a + b) / 2;
        size_area += dt * (c + d) / 2;
    }
    difference = std::sqrt(square / size);
    const nlohmann::json distance = json[0]["distance"];
    constexpr double left_out = 2e-5;  // of the series in the scene, at the first row
    EXPECT_NEAR(distance["whole"], difference, left_out);
    EXPECT_NEAR(distance["integral"], std::abs(area) / size_area, left_out);
    const double end = std::abs(rows.back().x - start_up(rows.back().time)) / start_up(rows.back().time);
    EXPECT_NEAR(distance["end"], end, left_out);
    EXPECT_NEAR(distance["peak"], end, left_out) << "it grows to its end";
    EXPECT_EQ(json[0]["error"], std::max({distance["whole"], distance["integral"], distance["end"], distance["peak"]}));
    EXPECT_GT(json[0]["error"], 1e-4);
    EXPECT_LT(json[0]["error"], 0.01);
    EXPECT_LT(json[1]["error"], 0.01) << "in the size of the vector";

    const std::string table = folder_.read("out/references.csv");
    EXPECT_THAT(table, testing::StartsWith("time [s],centre_velocity_x [m/s],centre_velocity_y [m/s]\n"));
    const std::vector<Row> exact = rows_of(table);
    ASSERT_EQ(exact.size(), rows.size());
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(exact[i].time, rows[i].time);
        EXPECT_NEAR(exact[i].x, start_up(rows[i].time), 1e-6 * steady);
    }
    EXPECT_THAT(folder_.read("out/report.html"),
                AllOf(HasSubstr("dashed: reference (series solution, Morris, Fox &amp; Zhu 1997); 0."),
                      HasSubstr("\"reference\":[")));
}

TEST_F(RunWithReferences, ThatGoesOnHasThoseOfAllItsTimes) {
    ASSERT_EQ(run(".", "whole").code, 0);
    ASSERT_EQ(run(".", "out", {"--until", "0.4 s"}).code, 0);
    const std::string first = folder_.read("out/references.csv");
    EXPECT_THAT(folder_.read("whole/references.csv"), testing::StartsWith(first));
    ASSERT_EQ(run(".", "out", {"--resume"}).code, 0);
    EXPECT_EQ(folder_.read("out/references.csv"), folder_.read("whole/references.csv"));
    EXPECT_EQ(references("out"), references("whole"));
}

TEST_F(RunWithReferences, FindsTheirFilesFromTheSceneAndFromWhatItWasRunWith) {
    const std::string scene = folder_.read("scene.toml");
    const auto formula = scene.find("formula = \"12.5 um/s");
    folder_.write("scene.toml", scene.substr(0, formula) + "file = \"curve.csv\"\nfrom = \"0.1 s\"\n" +
                                    scene.substr(scene.find('\n', formula) + 1));
    const Outcome without = run(".", "out");
    EXPECT_EQ(without.code, 2);
    EXPECT_THAT(without.errors,
                AllOf(HasSubstr("scene.toml:"), HasSubstr("reference.file: there is no file"), HasSubstr("curve.csv")));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out")) << "before anything is made";
    EXPECT_EQ(run(".", "out", {"--dry-run"}).code, 2);

    folder_.write("curve.csv", "time [ms],centre_velocity_x [um/s]\n0,0\n200,10.75\n");
    ASSERT_EQ(run(".", "out", {"--until", "0.2 s"}).code, 0);
    EXPECT_THAT(folder_.read("out/references.csv"), AllOf(HasSubstr("\n0,nan,0\n"), Not(HasSubstr("\n0.1,nan"))));
    EXPECT_THAT(folder_.read("out/scene.resolved.toml"), HasSubstr("file = \"../curve.csv\""));
    ASSERT_EQ(run("out/scene.resolved.toml", "again").code, 0);
    EXPECT_EQ(references("again"), references("out"));
    EXPECT_GT(references("out")[0]["error"], 0) << "the curve is none of this flow";
}

TEST_F(RunWithReferences, SaysWhyItDoesNotCompare) {
    const Outcome outcome = run(
        ".", "out",
        {"--until", "0.2 s", "--set", "reference.start_up.from=\"0.3 s\"", "--set", "reference.across.from=\"0.3 s\""});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output,
                HasSubstr("  centre_velocity_x: not compared with its reference (series solution, Morris, Fox & Zhu "
                          "1997): fewer than two rows are at times for which it holds\n"));
    EXPECT_TRUE(references("out")[0]["error"].is_null());
}

}  // namespace
}  // namespace dmp::tests::references_tests
