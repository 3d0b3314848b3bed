// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "bench/measure.hpp"
#include "bench/particle_file.hpp"
#include "tests/modules.hpp"

namespace dmp::bench {
namespace {

using testing::HasSubstr;
using testing::Not;

Options quick() {
    Options options;
    options.name = "channel2d";
    options.channel.particles = 1000;
    options.steps = 4;
    options.repeat = 2;
    return options;
}

TEST(BenchMeasure, SpreadIsMedianAndExtremes) {
    const Spread odd = spread_of({5, 1, 3}), even = spread_of({4, 1, 2, 9});
    EXPECT_EQ(odd.median, 3);
    EXPECT_EQ(odd.smallest, 1);
    EXPECT_EQ(odd.largest, 5);
    EXPECT_EQ(even.median, 3);
}

TEST(BenchMeasure, StagesAndRestAreTheStep) {
    Options options = quick();
    options.repeat = 1;
    const Measured measured = measure(options);
    ASSERT_TRUE(measured.engine);
    double sum = 0;
    for (const auto& [stage, spread] : measured.engine->stage) sum += spread.median;
    EXPECT_NEAR(sum / measured.engine->step.median, 1, 1e-9);
    EXPECT_GT(measured.engine->stage.size(), 3U);
    EXPECT_EQ(measured.engine->steps, options.steps);
    EXPECT_GT(measured.yardstick.median, 0);
    for (const double share : {measured.engine->processor, measured.yardstick_processor}) {
        EXPECT_GT(share, 0);
        EXPECT_LT(share, 1.1);
    }
    EXPECT_GT(measured.engine->planned_bytes, 0U);
    EXPECT_NEAR(measured.engine->density_low, 1, 0.01);
}

TEST(BenchMeasure, ReportsRatesThatGoTogether) {
    Options options = quick();
    options.json = true;
    const auto json = nlohmann::json::parse(report(options, measure(options)));
    const auto& engine = json["engine"];
    const double rate = engine["particle_steps_per_s_core"];
    EXPECT_NEAR(rate * engine["ns_per_particle_step"]["median"].get<double>() * 1e-9, 1, 1e-9);
    EXPECT_DOUBLE_EQ(engine["particle_sweeps_per_s_core"], 2 * rate);
    EXPECT_DOUBLE_EQ(engine["pairs_per_s_core"], 2 * rate * json["pairs_per_particle"].get<double>());
    EXPECT_NEAR(json["yardstick_sweep_over_engine_step"],
                json["yardstick"]["ns_per_particle_sweep"]["median"].get<double>() /
                    engine["ns_per_particle_step"]["median"].get<double>(),
                1e-9);
}

TEST(BenchMeasure, TextSaysWhatWasMeasured) {
    Options options = quick();
    const std::string text = report(options, measure(options));
    for (const char* word : {"particle-steps/s/core", "particle-sweeps/s/core", "pairs within the support", "resident",
                             "forces", "yardstick"})
        EXPECT_THAT(text, HasSubstr(word));
    options.yardstick_only = true;
    EXPECT_THAT(report(options, measure(options)), Not(HasSubstr("engine")));
}

TEST(BenchMeasure, TheYardstickRunsInSpace) {
    Options options = quick();
    options.channel.dimension = 3;
    options.yardstick_only = true;
    EXPECT_GT(measure(options).yardstick.median, 0);
}

TEST(BenchMeasure, ParticleFileHoldsThemAll) {
    const Options options = quick();
    const ParticleSet set = make_particles(options.channel);
    std::istringstream text(particle_text(options.channel, set));
    std::string line;
    std::getline(text, line);
    const auto head = nlohmann::json::parse(line);
    EXPECT_EQ(head["particles"], set.size());
    EXPECT_EQ(head["support"], options.channel.support * set.spacing);
    for (std::size_t i = 0; i < set.size(); ++i) {
        int fixed = -1;
        Vec position;
        text >> fixed >> position[0] >> position[1] >> position[2];
        ASSERT_EQ(fixed, set.fixed[i]);
        ASSERT_EQ(position, set.position[i]);
    }
}

}  // namespace
}  // namespace dmp::bench
