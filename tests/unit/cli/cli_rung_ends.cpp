// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// How the runs of a study of limits have ended.
#include <filesystem>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/limits/limits_outcome.hpp"
#include "cli/limits/rung_ends.hpp"
#include "cli/output_folder.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "scene/read_scene.hpp"
#include "study/limit_study.hpp"
#include "study/read_study.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::rung_ends_tests {
namespace {

using namespace cli;
using study::Dial;
using study::LimitStudy;
using study::RungState;
using testing::ElementsAre;

/// Two dials of three rungs each, of which the second one is a property of the liquid; the scene measures flux_in and
/// tip_gap.
class EndsOfRungs : public testing::Test {
  protected:
    EndsOfRungs() {
        Folder::write(good_scene);
        scene_ = read_scene("scene.toml");
        std::vector<Dial> dials(2);
        const std::vector<std::pair<std::string, double>> keys{{"numerics.support", 3},
                                                               {"part.blood.viscosity", 0.0035}};
        for (std::size_t k = 0; k < 2; ++k) {
            const std::string unit = k == 0 ? "" : " Pa*s", quote = k == 0 ? "" : "\"";
            dials[k].name = keys[k].first;
            dials[k].is_physical = k == 1;
            dials[k].keys.push_back(
                {keys[k].first, keys[k].second, "", quote + std::to_string(keys[k].second) + unit + quote, {}});
            for (const double factor : {1.1, 1.2, 1.3})
                dials[k].rungs.push_back({factor,
                                          keys[k].second * factor,
                                          {quote + std::to_string(keys[k].second * factor) + unit + quote},
                                          1});
        }
        dials[0].refused = "the check has a bound";
        dials[0].bound = 3.9;
        limits_ = std::make_unique<LimitStudy>(dials, std::map<std::string, std::string>{{"numerics.support", "3.05"}});
        study_ = study::parse_study(limits_->text("scene.toml", "", {}, "out"), "out/study.toml");
        points_ = std::make_unique<study::Points>(study_);
        sweep_ = std::make_unique<SweepFolder>("out", NewSweep{study_, points_->size(), false, false},
                                               TypedCommand({"dmp"}));
        std::vector<std::size_t> all(points_->size());
        std::iota(all.begin(), all.end(), 0UL);
        rows_ = std::make_unique<SweepRows>(study_, *points_, *sweep_, all);
    }

    [[nodiscard]] RungEnds ends(double tolerance = 0.05) const { return {*rows_, *limits_, scene_, tolerance}; }
    /// The run has ended, with this flux and gap at all times.
    void ended(std::size_t run, const std::string& flux, const std::string& gap) const {
        const auto folder = run_folder("out", points_->at(run).name);
        std::filesystem::create_directories(folder);
        write_file(folder / "measures.csv",
                   "time [s],flux_in [m^2/s],tip_gap [m]\n0," + flux + "," + gap + "\n1," + flux + "," + gap + "\n");
        add(run, 0, "");
    }
    [[nodiscard]] LimitsFacts facts() const {
        LimitsRequest request{.overrides = {},
                              .common = {},
                              .added = {},
                              .read = scene_,
                              .budget = {},
                              .study = *limits_,
                              .asked = {true, true}};
        RungEnds found = ends();
        return limits_found(request, "scene.toml", found, *points_);
    }
    void add(std::size_t run, int exit_code, const std::string& error) const {
        SweepRow row;
        row.run = points_->at(run).name;
        row.values.resize(study_.keys().size());
        row.exit_code = exit_code;
        row.error = error;
        static_cast<void>(rows_->add(run, row));
    }

    Folder folder_;
    Scene scene_;
    std::unique_ptr<LimitStudy> limits_;
    Study study_;
    std::unique_ptr<study::Points> points_;
    std::unique_ptr<SweepFolder> sweep_;
    std::unique_ptr<SweepRows> rows_;
};

TEST_F(EndsOfRungs, AreNotKnownBeforeThatOfTheScenesOwnSettingsAndItsRepeat) {
    ended(2, "1", "1");
    EXPECT_FALSE(ends().has_reference());
    ended(0, "1", "1");
    EXPECT_FALSE(ends().has_reference());
    EXPECT_THAT(ends().states_of(0), ElementsAre(RungState::unknown, RungState::unknown, RungState::unknown));
    add(1, 2, "its spacing is refused");
    EXPECT_TRUE(ends().has_reference()) << "without a scatter";
    EXPECT_THAT(facts().notes,
                ElementsAre("The repeat, run " + points_->at(1).name +
                            ", is refused: its spacing is refused. The scatter of measures is not known."));
    EXPECT_THAT(ends().states_of(0), ElementsAre(RungState::clean, RungState::unknown, RungState::unknown));
}

TEST_F(EndsOfRungs, OfTheScenesOwnSettingsMayBeAFailure) {
    add(0, 3, "the simulation diverged");
    write_file(run_output("out", points_->at(0).name), "error: the simulation diverged\n  likely cause: the step\n");
    EXPECT_FALSE(ends().has_reference());
    EXPECT_EQ(ends().of(0).way, RungWay::breaks);
    EXPECT_EQ(ends().of(0).text, "the simulation diverged");
    EXPECT_EQ(ends().of(0).likely_causes, "the step");
}

TEST_F(EndsOfRungs, DepartByTheMeasureThatIsFurthestFromWhatIsAllowed) {
    ended(0, "1", "2");
    ended(1, "1.01", "2.2");  // scatter: 1 and 10 %
    ended(2, "1.04", "2.3");
    ended(3, "1.06", "2.3");
    ended(4, "1", "2.7");
    RungEnds found = ends();
    ASSERT_TRUE(found.has_reference());
    ASSERT_EQ(found.columns().size(), 2U);
    EXPECT_NEAR(found.columns()[0].allowed, 0.05, 1e-12);
    EXPECT_NEAR(found.columns()[1].allowed, 0.3, 1e-12) << "three times the scatter";
    EXPECT_THAT(found.states_of(0), ElementsAre(RungState::clean, RungState::bad, RungState::bad));
    EXPECT_EQ(found.of(3).way, RungWay::departs);
    EXPECT_EQ(found.of(3).column, "flux_in");
    EXPECT_NEAR(found.of(3).distance, 0.06, 1e-12);
    EXPECT_EQ(found.of(4).column, "tip_gap");
    EXPECT_NEAR(found.of(4).distance, 0.35, 1e-12);
    EXPECT_THAT(ends(0.1).states_of(0), ElementsAre(RungState::clean, RungState::clean, RungState::bad));
}

TEST_F(EndsOfRungs, OfMeasuresThatAreZeroOrScatterDoNotCount) {
    ended(0, "0", "2");
    ended(1, "0", "2.5");  // by 25 %
    ended(2, "1", "9");
    RungEnds found = ends();
    ASSERT_TRUE(found.has_reference());
    EXPECT_FALSE(found.columns()[0].counts() || found.columns()[1].counts());
    EXPECT_EQ(found.of(2).way, RungWay::clean);
    EXPECT_FALSE(found.can_compare(0));
    EXPECT_TRUE(found.can_compare(1)) << "what breaks is seen without";
    const LimitsFacts limits = facts();
    ASSERT_EQ(limits.dials.size(), 2U);
    EXPECT_EQ(limits.dials[0].way, LimitWay::no_measure);
    EXPECT_FALSE(limits.dials[0].margin() || limits.dials[0].clean);
    EXPECT_EQ(limits.dials[1].way, LimitWay::not_measured);
    EXPECT_THAT(limits.notes, ElementsAre(testing::StartsWith("No measure counts: ")));
    EXPECT_THAT(limits_text(limits),
                testing::AllOf(testing::HasSubstr("no measure counts"), testing::HasSubstr(limits.notes[0])));
}

TEST_F(EndsOfRungs, WithoutValuesWhereTheScenesOwnHasSomeDepart) {
    ended(0, "1", "2");
    ended(1, "1", "2");
    ended(2, "1", "nan");
    RungEnds found = ends();
    ASSERT_TRUE(found.has_reference());
    EXPECT_EQ(found.of(2).way, RungWay::departs);
    EXPECT_EQ(found.of(2).column, "tip_gap");
}

TEST_F(EndsOfRungs, OfAPropertyOfWhatIsSimulatedAreBadOnlyWhereTheyBreakOrAreRefused) {
    ended(0, "1", "2");
    ended(1, "1", "2");
    const std::size_t first = limits_->run_of(1, 1);
    ended(first, "10", "20");
    add(first + 1, 2, "refused");
    add(first + 2, 139, "it was ended by signal 11");
    RungEnds found = ends();
    EXPECT_THAT(found.states_of(1), ElementsAre(RungState::clean, RungState::bad, RungState::failed));
    EXPECT_EQ(found.of(first + 1).way, RungWay::refused);
    EXPECT_EQ(found.of(first + 2).way, RungWay::failed);
}

TEST_F(EndsOfRungs, ThatFailedLeaveTheirDialNotMeasured) {
    ended(0, "1", "2");
    ended(1, "1", "2");
    add(3, 4, "the disk is full");  // the middle one of the first dial
    const std::size_t first = limits_->run_of(1, 1);
    add(first, 3, "the simulation diverged");
    add(first + 1, 137, "it was ended by signal 9");  // beyond what is known
    const LimitsFacts found = facts();
    ASSERT_EQ(found.dials.size(), 2U);
    EXPECT_EQ(found.dials[0].way, LimitWay::not_measured);
    EXPECT_EQ(found.dials[0].cause, "run " + points_->at(3).name + " failed: the disk is full");
    EXPECT_FALSE(found.dials[0].bad);
    EXPECT_EQ(found.dials[1].way, LimitWay::breaks);
    EXPECT_EQ(found.dials[1].cause, "the simulation diverged");
}

TEST_F(EndsOfRungs, AtTheBoundOfTheCheckHaveNoBadValue) {
    ended(0, "1", "2");
    ended(1, "1", "2");
    ended(3, "1", "2");
    EXPECT_FALSE(facts().dials.at(0).margin()) << "not measured to its end";
    ended(4, "1", "2");
    ended(6, "1", "2");
    add(7, 3, "the simulation diverged");
    const LimitsFacts found = facts();
    const LimitsFacts::Dial &bound = found.dials.at(0), &broken = found.dials.at(1);
    EXPECT_THAT(broken.keys, ElementsAre("part.blood.viscosity"));
    EXPECT_EQ(bound.way, LimitWay::refused);
    EXPECT_FALSE(bound.bad);
    EXPECT_EQ(bound.bound, 3.9);
    EXPECT_EQ(bound.cause, "the check has a bound");
    EXPECT_NEAR(bound.margin().value(), 1.3, 1e-12);
    EXPECT_FALSE(broken.bound);
    EXPECT_NEAR(broken.bad.value(), 0.0035 * 1.3, 1e-12);
    EXPECT_NEAR(broken.margin().value(), 1.2, 1e-12) << "of the last clean value";
}

TEST(AskedDials, AreThoseOfWhichAnyKeyIsNamed) {
    const auto key = [](const std::string& name) { return study::DialKey{name, 1, "", "", {}}; };
    std::vector<Dial> dials(3);
    dials[0].keys = {key("part.a.bending_stiffness"), key("part.a.axial_stiffness")};
    dials[1].keys = {key("part.a.density")};
    dials[2].keys = {key("part.b.axial_stiffness")};
    EXPECT_THAT(asked_dials(dials, {}), ElementsAre(true, true, true));
    EXPECT_THAT(asked_dials(dials, {"axial_stiffness"}), ElementsAre(true, false, true));
    EXPECT_THAT(asked_dials(dials, {"part.a.axial_stiffness", "density"}), ElementsAre(true, true, false));
    EXPECT_THAT(text_thrown<InputError>([&] { static_cast<void>(asked_dials(dials, {"stiffness"})); }),
                testing::HasSubstr("'part.a.bending_stiffness', 'part.a.axial_stiffness', 'part.a.density'"));
}

}  // namespace
}  // namespace dmp::tests::rung_ends_tests
