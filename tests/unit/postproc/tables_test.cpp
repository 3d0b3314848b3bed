// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/tables.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "synthetic_run.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::tables_tests {
namespace {

using ::testing::HasSubstr;

const double missing = std::numeric_limits<double>::quiet_NaN();

MeasureSeries two_measures() {
    return {{"inlet_flux", "tip_gap"}, {"m^2/s", "m"}, {0, 0.1, 0.2}, {{0, missing}, {1.0 / 3, 2e-5}, {-1e-7, 4e-5}}};
}

RunSummary some_summary() {
    RunSummary summary;
    summary.particles = {{"fluid", 1000}, {"rigid", 200}, {"elastic", 18}};
    summary.steps = 4321;
    summary.simulated_s = 0.25;
    summary.wall_s = 1.5;
    summary.particle_steps_per_s = 3.5e6;
    summary.threads = 2;
    summary.limits = {{"sound", 1.25e-5, "0.3 h / c0"}, {"viscosity", 4e-4, "h^2 / (8 nu)"}};
    summary.ruling_limit = "sound";
    summary.sound_speed = 2.2;
    summary.warnings = {{"flow.largest_speed", {}, "is too slow", "give more"}};
    summary.start = {1.0, {0, 0, 0}};
    summary.end = {1.0, {0.5, -0.25, 0}};
    summary.impulse_of_body_forces = {0.75, 0, 0};
    summary.impulse_of_fixed = {-0.25, -0.25, 0};
    summary.momentum_residual = 1e-15;
    summary.density_low = 999.5;
    summary.density_high = missing;
    summary.state_hash = "00ff00ff00ff00ff";
    summary.seconds_by_stage = {{"forces", 1.0}, {"elastic", 0.25}};
    summary.measures = two_measures();
    return summary;
}

nlohmann::json written(const RunSummary& summary) {
    const TemporaryFolder folder;
    write_summary(folder.path() / "out", summary, {{"Channel", "0123456789abcdef", "0.1.0"}, {"fluid.pvd"}});
    return nlohmann::json::parse(read_file(folder.path() / "out/summary.json"));
}

TEST(Summary, HasTheWarningsFromStartToEnd) {
    const TemporaryFolder folder;
    SummaryExtra extra;
    extra.warnings = {"water: a gap of 1 spacings"};
    write_summary(folder.path(), some_summary(), extra);
    EXPECT_EQ(nlohmann::json::parse(read_file(folder.path() / "summary.json"))["warnings"],
              nlohmann::json::array({"water: a gap of 1 spacings", "flow.largest_speed is too slow; give more"}));
}

TEST(Summary, HasTheEnergyOfSpheres) {
    EXPECT_FALSE(written(some_summary()).contains("energy"));
    RunSummary summary = some_summary();
    summary.spheres = SphereSummary{{1, 2, 3}, {0.5, 0.25, 0.125}, 0, 0, 0};
    const nlohmann::json energy = written(summary)["energy"];
    EXPECT_EQ(energy["start"]["rotation"], 2);
    EXPECT_EQ(energy["start"]["contacts"], 3);
    EXPECT_EQ(energy["end"]["translation"], 0.5);
}

TEST(Summary, HasDistancesFromReferences) {
    EXPECT_FALSE(written(some_summary()).contains("references"));
    const TemporaryFolder folder;
    SummaryExtra extra;
    extra.references = {{"flow", "flow_x", "Author 1997", 0.01, 0.02, 0.03, 0.04, 0.04},
                        {"gap", "gap", "measured", missing, missing, missing, missing, missing, "it is 0"}};
    write_summary(folder.path(), some_summary(), extra);
    const auto json = nlohmann::json::parse(read_file(folder.path() / "summary.json"))["references"];
    EXPECT_EQ(json[0], nlohmann::json::parse(R"({"measure": "flow", "column": "flow_x", "source": "Author 1997",
        "error": 0.04, "distance": {"whole": 0.01, "end": 0.02, "peak": 0.03, "integral": 0.04}})"));
    EXPECT_EQ(json[1]["error"], nullptr);
    EXPECT_EQ(json[1]["distance"]["whole"], nullptr);
}

TEST(MeasuresCsv, HasThisText) {
    const TemporaryFolder folder;
    write_measures_csv(folder.path(), two_measures());
    EXPECT_EQ(read_file(folder.path() / "measures.csv"),
              "time [s],inlet_flux [m^2/s],tip_gap [m]\n"
              "0,0,nan\n"
              "0.1,0.3333333333333333,2e-05\n"
              "0.2,-1e-07,4e-05\n");
}

TEST(MeasuresCsv, ComesBackBitForBit) {
    const TemporaryFolder folder;
    MeasureSeries series = two_measures();
    series.names[0] = "flux, \"upper\" [left]";
    series.rows[0] = {std::nextafter(1.0, 2.0), -missing};
    write_measures_csv(folder.path(), series);
    const MeasureSeries back = read_measures_csv(folder.path());
    EXPECT_EQ(back.names, series.names);
    EXPECT_EQ(back.units, series.units);
    EXPECT_EQ(back.time, series.time);
    ASSERT_EQ(back.rows.size(), 3U);
    EXPECT_EQ(back.rows[0][0], series.rows[0][0]);
    EXPECT_TRUE(std::isnan(back.rows[0][1]));
    EXPECT_EQ(back.rows[1], series.rows[1]);
    EXPECT_EQ(back.rows[2], series.rows[2]);
}

TEST(MeasuresCsv, GrowsWithTheRun) {
    const TemporaryFolder folder, at_once;
    const MeasureSeries all = two_measures();
    MeasureSeries series = all;
    series.time.resize(1);
    series.rows.resize(1);
    std::ofstream(folder.path() / "measures.csv") << "of an earlier run\n";
    MeasuresFile file(folder.path());
    file.write(series);  // of a run that goes on from a checkpoint, say
    EXPECT_EQ(read_measures_csv(folder.path()).rows.size(), 1U);
    file.write(series);
    EXPECT_EQ(read_measures_csv(folder.path()).rows.size(), 1U);
    file.write(all);
    write_measures_csv(at_once.path(), all);
    EXPECT_EQ(read_file(folder.path() / "measures.csv"), read_file(at_once.path() / "measures.csv"));

    std::filesystem::remove(folder.path() / "measures.csv");
    series = all;
    series.time.push_back(0.3);
    series.rows.push_back({1, 2});
    EXPECT_THROW(file.write(series), ResourceError) << "somebody took it away";
}

TEST(MeasuresCsv, MayHaveAnotherName) {
    const TemporaryFolder folder;
    MeasuresFile(folder.path(), references_file_name).write(two_measures());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "measures.csv"));
    EXPECT_EQ(read_measures_csv(folder.path(), references_file_name).names, two_measures().names);
}

TEST(MeasuresCsv, WithoutMeasuresIsTheHeadingAlone) {
    const TemporaryFolder folder;
    write_measures_csv(folder.path(), {});
    EXPECT_EQ(read_file(folder.path() / "measures.csv"), "time [s]\n");
    EXPECT_TRUE(read_measures_csv(folder.path()).names.empty());
}

TEST(MeasuresCsv, MalformedLinesAreNamed) {
    const TemporaryFolder folder;
    const auto message = [&](const std::string& text) -> std::string {
        std::ofstream(folder.path() / "measures.csv") << text;
        try {
            read_measures_csv(folder.path());
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(message("time [s],a [m]\n0,1\n1\n"), HasSubstr("measures.csv:3: found 1 values, expected 2"));
    EXPECT_THAT(message("time [s],a [m]\n0,one\n"), HasSubstr("measures.csv:2: 'one' is not a number"));
    EXPECT_THAT(message("time [s],a [m]\n0,1 m\n"), HasSubstr("measures.csv:2: '1 m' is not a number"));
    EXPECT_THROW(read_measures_csv(folder.path() / "none"), InputError);
}

TEST(MeasuresCsv, RowsThatDoNotFitAreRefused) {
    const TemporaryFolder folder;
    MeasureSeries series = two_measures();
    series.rows[1].pop_back();
    EXPECT_THROW(write_measures_csv(folder.path(), series), std::invalid_argument);
}

TEST(Summary, HasTheKeysThatScriptsWant) {
    const nlohmann::json json = written(some_summary());
    for (const char* key : {"particles",     "steps",       "simulated_s",  "wall_s",       "particle_steps_per_s",
                            "threads",       "ranks",       "dt_limits",    "ruling_limit", "conserved",
                            "lost",          "measures",    "state_hash",   "title",        "version",
                            "scene_hash",    "density_low", "density_high", "sound_speed",  "seconds_by_stage",
                            "interrupted",   "files",       "processor_s",  "vector_unit",  "rank_shares",
                            "density_drift", "warnings",    "largest_speed"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["particles"], (nlohmann::json{{"fluid", 1000}, {"rigid", 200}, {"elastic", 18}}));
    EXPECT_EQ(json["steps"], 4321);
    EXPECT_EQ(json["simulated_s"], 0.25);
    EXPECT_EQ(json["dt_limits"], (nlohmann::json{{"sound", 1.25e-5}, {"viscosity", 4e-4}}));
    EXPECT_EQ(json["ruling_limit"], "sound");
    EXPECT_EQ(json["lost"], 0);
    EXPECT_EQ(json["interrupted"], false);
    EXPECT_EQ(json["warnings"], nlohmann::json::array({"flow.largest_speed is too slow; give more"}));
    EXPECT_EQ(json["state_hash"], "00ff00ff00ff00ff");
    EXPECT_EQ(json["files"], nlohmann::json::array({"fluid.pvd"}));
    EXPECT_EQ(json["scene_hash"], "0123456789abcdef");
}

TEST(Summary, KeepsTheBooksOfMassAndMomentum) {
    const nlohmann::json conserved = written(some_summary())["conserved"];
    EXPECT_EQ(conserved["start"]["mass"], 1.0);
    EXPECT_EQ(conserved["end"]["momentum"], (std::vector<double>{0.5, -0.25, 0}));
    EXPECT_EQ(conserved["impulse_of_body_forces"], (std::vector<double>{0.75, 0, 0}));
    EXPECT_EQ(conserved["impulse_of_fixed"], (std::vector<double>{-0.25, -0.25, 0}));
    EXPECT_EQ(conserved["impulse_of_drag"], (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(conserved["momentum_residual"], 1e-15);
}

TEST(Summary, SaysWhatImplicitViscosityTookWhereItRan) {
    RunSummary summary = some_summary();
    EXPECT_FALSE(written(summary).contains("implicit_viscosity"));
    summary.viscous_solves = {4, 50, 17};
    const nlohmann::json viscosity = written(summary)["implicit_viscosity"];
    EXPECT_EQ(viscosity["solves"], 4);
    EXPECT_EQ(viscosity["iterations_mean"], 12.5);
    EXPECT_EQ(viscosity["iterations_most"], 17);
}

TEST(Summary, MeasuresAreOverTheirFiniteRows) {
    const nlohmann::json measures = written(some_summary())["measures"];
    EXPECT_EQ(measures["inlet_flux"]["unit"], "m^2/s");
    EXPECT_EQ(measures["inlet_flux"]["last"], -1e-7);
    EXPECT_EQ(measures["inlet_flux"]["min"], -1e-7);
    EXPECT_EQ(measures["inlet_flux"]["max"], 1.0 / 3);
    EXPECT_DOUBLE_EQ(measures["inlet_flux"]["mean"], (1.0 / 3 - 1e-7) / 3);
    EXPECT_EQ(measures["inlet_flux"]["missing"], 0);
    EXPECT_DOUBLE_EQ(measures["tip_gap"]["mean"], 3e-5);
    EXPECT_EQ(measures["tip_gap"]["missing"], 1);
}

TEST(Summary, NotANumberBecomesNull) {
    RunSummary summary = some_summary();
    summary.momentum_residual = std::numeric_limits<double>::infinity();
    summary.measures.rows.back()[1] = missing;
    for (auto& row : summary.measures.rows) row[0] = missing;
    const nlohmann::json json = written(summary);
    EXPECT_TRUE(json["density_high"].is_null());
    EXPECT_TRUE(json["conserved"]["momentum_residual"].is_null());
    EXPECT_TRUE(json["measures"]["tip_gap"]["last"].is_null());
    EXPECT_EQ(json["measures"]["tip_gap"]["max"], 2e-5);
    EXPECT_TRUE(json["measures"]["inlet_flux"]["mean"].is_null());
}

TEST(Summary, SaysHowTheRunEnded) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_run_end(folder.path()));
    RunSummary summary = some_summary();
    for (const bool interrupted : {false, true}) {
        summary.interrupted = interrupted;
        write_summary(folder.path(), summary, {});
        const auto end = read_run_end(folder.path());
        ASSERT_TRUE(end);
        EXPECT_EQ(end->interrupted, interrupted);
        EXPECT_EQ(end->simulated_s, 0.25);
    }
    for (const char* text : {"", "{", "[]", "{}", R"({"interrupted": 1})"}) {
        write_file(folder.path() / "summary.json", text);
        EXPECT_FALSE(read_run_end(folder.path())) << text;
    }
}

}  // namespace
}  // namespace dmp::tests::tables_tests
