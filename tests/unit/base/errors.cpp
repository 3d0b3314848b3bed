// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/errors.hpp"

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::errors_tests {
namespace {

TEST(PlaceText, ShowsWhatIsKnown) {
    EXPECT_EQ((SourceLocation{"scene.toml", 12, 5}.text()), "scene.toml:12:5");
    EXPECT_EQ((SourceLocation{"scene.toml", 12, 0}.text()), "scene.toml:12");
    EXPECT_EQ((SourceLocation{"scene.toml", 0, 0}.text()), "scene.toml");
    EXPECT_EQ((SourceLocation{"--set a=1", 0, 7}.text()), "--set a=1");  // a column alone says nothing
    EXPECT_EQ(SourceLocation{}.text(), "");
    EXPECT_EQ((SourceLocation{"", 3, 4}.text()), "");
    EXPECT_TRUE((SourceLocation{"scene.toml", 0, 0}.known()));
    EXPECT_FALSE(SourceLocation{}.known());
}

TEST(ErrorText, WhereThenWhatThenWhatToDo) {
    const InputError error({"scene.toml", 12, 5}, "unknown key 'titel'", "did you mean 'title'?");
    EXPECT_STREQ(error.what(), "scene.toml:12:5: unknown key 'titel'\n  did you mean 'title'?");
    EXPECT_EQ(error.where().line, 12);
    EXPECT_EQ(error.problem(), "unknown key 'titel'");
    EXPECT_EQ(error.what_to_do(), "did you mean 'title'?");
}

TEST(ErrorText, LeavesOutWhatIsNotKnown) {
    EXPECT_STREQ(InputError("no scene", "name one").what(), "no scene\n  name one");
    EXPECT_STREQ(InputError({"a.geo", 0, 0}, "it is empty", "").what(), "a.geo: it is empty");
    EXPECT_STREQ(DivergenceError("the speed is not finite", "").what(), "the speed is not finite");
    EXPECT_STREQ(ResourceError("the disk is full", "free some").what(), "the disk is full\n  free some");
    EXPECT_FALSE(DivergenceError("a", "b").where().known());
}

TEST(ErrorKinds, CanBeToldApartAndCaughtTogether) {
    EXPECT_THROW(throw InputError("a", "b"), Error);
    EXPECT_THROW(throw DivergenceError("a", "b"), Error);
    EXPECT_THROW(throw ResourceError("a", "b"), std::runtime_error);
    const ResourceError resource("a", "b");
    const Error* error = &resource;
    EXPECT_EQ(dynamic_cast<const InputError*>(error), nullptr);
    EXPECT_NE(dynamic_cast<const ResourceError*>(error), nullptr);
}

}  // namespace
}  // namespace dmp::tests::errors_tests
