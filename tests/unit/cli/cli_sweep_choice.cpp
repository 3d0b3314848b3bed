// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/sweep/sweep_choice.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::sweep_choice_tests {
namespace {

using namespace cli;
using testing::ElementsAre;
using testing::SizeIs;

class Only : public testing::Test {
  protected:
    [[nodiscard]] std::vector<std::size_t> chosen(const std::vector<std::string>& only) const {
        return chosen_runs(study_, points_, only);
    }
    [[nodiscard]] std::string fault(const std::string& only) const {
        return text_thrown<InputError>([&] { static_cast<void>(chosen({only})); });
    }

    Study study_ = study_of(good_study);
    Points points_{study_};
};

TEST_F(Only, ChoosesByQuantityInAnyUnit) {
    EXPECT_THAT(chosen({}), SizeIs(6));
    EXPECT_THAT(chosen({"particles.spacing=0.2 mm"}), ElementsAre(1, 4));
    EXPECT_THAT(chosen({"particles.spacing=\"200 um\"", "part.leaflets.bending_stiffness=3e-6 N*m^2"}), ElementsAre(4));
}

TEST_F(Only, RefusesWhatNoRunHas) {
    EXPECT_EQ(fault("particles.spacing"),
              "--only particles.spacing: expected KEY=VALUE\n"
              "  Write for example --only particles.spacing=\"0.1 mm\".");
    EXPECT_EQ(fault("particles.spacin=1 mm"),
              "--only particles.spacin=1 mm: the study does not vary 'particles.spacin'\n"
              "  Did you mean 'particles.spacing'?");
    EXPECT_EQ(fault("particles.spacing=1 s"),
              "--only particles.spacing=1 s: particles.spacing: found \"1 s\" (time), expected a length such as "
              "\"0.1 mm\"\n  give a length for spacing");
    EXPECT_EQ(fault("particles.spacing=0.3 mm"),
              "--only particles.spacing=0.3 mm: no run of the study has this value\n"
              "  'dmp sweep STUDY --dry-run' lists the runs and their values.");
}

}  // namespace
}  // namespace dmp::tests::sweep_choice_tests
