// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "cli/exit_codes.hpp"
#include "cli/failure.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_exit_codes_tests {

namespace {

using namespace cli;
using testing::HasSubstr;

struct Outcome {
    int code;
    std::string text;
};

template <class Thrown>
Outcome outcome_of(const Thrown& thrown) {
    testing::internal::CaptureStderr();
    const int code = exit_code_of([&]() -> int { throw thrown; });
    return {code, testing::internal::GetCapturedStderr()};
}

TEST(ExitCode, OfAnActionThatEndsIsItsOwn) {
    EXPECT_EQ(exit_code_of([] { return 0; }), 0);
    EXPECT_EQ(exit_code_of([] { return 130; }), 130);
}

TEST(ExitCode, InputErrorIsTwoAndSaysWhereAndWhatToDo) {
    const auto outcome = outcome_of(InputError({"scene.toml", 12, 5}, "spacing is negative", "Give a length."));
    EXPECT_EQ(outcome.code, exit_bad_input);
    EXPECT_EQ(outcome.text, "error: scene.toml:12:5: spacing is negative\n  Give a length.\n");
}

TEST(ExitCode, WithoutAPlaceThereIsNoColon) {
    EXPECT_EQ(outcome_of(InputError("no", "do this\nor that")).text, "error: no\n  do this\n  or that\n");
}

TEST(ExitCode, DivergenceIsThreeAndLackIsFour) {
    EXPECT_EQ(outcome_of(DivergenceError("it blew up", "")).code, exit_diverged);
    EXPECT_EQ(outcome_of(ResourceError("disk full", "")).code, exit_out_of_resource);
    EXPECT_EQ(outcome_of(std::bad_alloc()).code, exit_out_of_resource);
}

TEST(ExitCode, FileSystemErrorsAreToldApart) {
    const auto error = [](std::errc code) {
        return std::filesystem::filesystem_error("writing", "out/x", std::make_error_code(code));
    };
    EXPECT_EQ(outcome_of(error(std::errc::no_space_on_device)).code, exit_out_of_resource);
    EXPECT_EQ(outcome_of(error(std::errc::file_too_large)).code, exit_out_of_resource);
    EXPECT_EQ(outcome_of(error(std::errc::permission_denied)).code, exit_bad_input);
    EXPECT_THAT(outcome_of(error(std::errc::not_a_directory)).text, HasSubstr("out/x"));
}

TEST(ExitCode, AnythingElseIsABugOfDmp) {
    const auto outcome = outcome_of(std::logic_error("index 7 of 5"));
    EXPECT_EQ(outcome.code, exit_bug);
    EXPECT_THAT(outcome.text, testing::AllOf(HasSubstr("index 7 of 5"), HasSubstr("bug in dmp")));
}

TEST(ErrorText, IsColouredOnlyWhenAsked) {
    EXPECT_THAT(error_text("a:1", "b", "c", true), HasSubstr("\033[1;31merror:\033[0m"));
    EXPECT_EQ(error_text("a:1", "b", "c", false), "error: a:1: b\n  c\n");
}

}  // namespace

}  // namespace dmp::tests::cli_exit_codes_tests
