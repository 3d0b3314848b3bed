// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "bench/options.hpp"
#include "tests/modules.hpp"

namespace dmp::bench {
namespace {

using testing::HasSubstr;

Options options_of(std::vector<const char*> words) {
    words.insert(words.begin(), "somewhere/dmp_bench");
    return read_options(words);
}

std::string fault_of(const std::vector<const char*>& words) {
    try {
        options_of(words);
    } catch (const InputError& error) {
        return error.problem() + "\n" + error.what_to_do();
    }
    return "no error";
}

TEST(BenchOptions, PlainIsTheDefault) {
    const Options options = options_of({"--case", "disordered3d"});
    EXPECT_EQ(options.channel.dimension, 3);
    EXPECT_TRUE(options.channel.disordered);
    EXPECT_EQ(options.channel.particles, 100'000U);
    EXPECT_EQ(options.channel.walls, WallModel::plain);
    EXPECT_EQ(options.channel.shifting, 0);
    EXPECT_EQ(options.channel.density_diffusion, 0);
    EXPECT_EQ(options.channel.contact_range, 0);
    EXPECT_EQ(options.channel.support, 2.5);
    EXPECT_EQ(options.repeat, 5);
    EXPECT_EQ(options.threads, 1);
    EXPECT_EQ(options.channel.scheme, FluidScheme::plain);
}

TEST(BenchOptions, TakesTheDefaultsOfAScheme) {
    const Channel corrected = options_of({"--defaults", "corrected", "--case", "channel2d"}).channel;
    EXPECT_EQ(corrected.scheme, FluidScheme::corrected);
    const Channel plain = options_of({"--defaults", "plain", "--case", "channel2d"}).channel;
    EXPECT_EQ(plain.scheme, FluidScheme::plain);
    EXPECT_EQ(plain.walls, WallModel::extrapolated);
    EXPECT_GT(plain.shifting, corrected.shifting);
    EXPECT_THAT(fault_of({"--case", "channel2d", "--defaults", "marble"}), HasSubstr("'corrected' and 'plain'"));
}

TEST(BenchOptions, SpeciesAreCounted) {
    EXPECT_EQ(options_of({"--case", "channel2d"}).channel.species, 0);
    EXPECT_EQ(options_of({"--case", "channel2d", "--defaults", "plain", "--species", "3"}).channel.species, 3);
}

TEST(BenchOptions, ASingleChoiceOverrulesTheDefaults) {
    const Channel channel = options_of({"--case", "channel2d", "--walls", "plain", "--defaults", "plain",
                                        "--support=2.6", "--kernel", "lucy"})
                                .channel;
    EXPECT_EQ(channel.walls, WallModel::plain);
    EXPECT_EQ(channel.support, 2.6);
    EXPECT_EQ(channel.kernel, KernelKind::lucy);
    EXPECT_GT(channel.shifting, 0);
}

TEST(BenchOptions, ReadsNumbersAndWords) {
    const Options options = options_of({"--case", "channel2d", "--particles", "5000", "--threads", "2", "--steps", "7",
                                        "--repeat", "3", "--vector-unit", "avx2", "--json", "--particles-to", "x.txt"});
    EXPECT_EQ(options.channel.particles, 5000U);
    EXPECT_EQ(options.threads, 2);
    EXPECT_EQ(options.steps, 7);
    EXPECT_EQ(options.repeat, 3);
    EXPECT_EQ(options.vector_unit, VectorUnit::avx2);
    EXPECT_TRUE(options.json);
    EXPECT_EQ(options.particles_to, "x.txt");
}

TEST(BenchOptions, SetsKeysOfTheScene) {
    const Channel channel =
        options_of({"--case", "channel2d", "--set", "numerics.shifting=2", "--set", "contact.range=1"}).channel;
    EXPECT_EQ(channel.overrides, (std::vector<std::string>{"numerics.shifting=2", "contact.range=1"}));
    const Scene scene = make_scene(channel);
    EXPECT_EQ(*scene.numerics.shifting, 2);
    EXPECT_EQ(*scene.contact.range, 1);
    EXPECT_THAT(fault_of({"--case", "channel2d", "--set"}), HasSubstr("--set"));
}

TEST(BenchOptions, UnknownWordsAreErrorsWithTheNearestRightOne) {
    EXPECT_THAT(fault_of({"--case", "channel2d", "--thread", "2"}), HasSubstr("Did you mean '--threads'?"));
    EXPECT_THAT(fault_of({"--case", "chanel2d"}), HasSubstr("Did you mean 'channel2d'?"));
    EXPECT_THAT(fault_of({"--case", "channel2d", "--kernel", "lucky"}), HasSubstr("Did you mean 'lucy'?"));
    EXPECT_THAT(fault_of({"--case", "channel2d", "--walls", "marble"}), HasSubstr("'extrapolated' and 'plain'"));
    EXPECT_THAT(fault_of({"--case", "channel2d", "valve"}), HasSubstr("no option 'valve'"));
}

TEST(BenchOptions, WrongAndMissingValuesAreErrors) {
    EXPECT_THAT(fault_of({}), HasSubstr("--case is required"));
    EXPECT_THAT(fault_of({"--case"}), HasSubstr("--case"));
    for (const auto& [option, value] :
         {std::pair{"--steps", "0"}, std::pair{"--steps", "x"}, std::pair{"--repeat", "-1"},
          std::pair{"--support", "1.9"}, std::pair{"--support", "9"}, std::pair{"--particles", "1e5"},
          std::pair{"--threads", ""}})
        EXPECT_THAT(fault_of({"--case", "channel2d", option, value}), HasSubstr(option)) << value;
}

TEST(BenchOptions, HelpNeedsNoCase) { EXPECT_THAT(options_of({"--help"}).help, HasSubstr("--yardstick-only")); }

}  // namespace
}  // namespace dmp::bench
