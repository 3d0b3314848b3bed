// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/html.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::report_html_tests {
namespace {

TEST(Html, NothingInATextIsMarkup) {
    EXPECT_EQ(escaped("<script>a && \"b\" 'c'</script>"),
              "&lt;script&gt;a &amp;&amp; &quot;b&quot; &#39;c&#39;&lt;/script&gt;");
    EXPECT_EQ(escaped("tab\tline\nbell\a\x7f"), "tab\tline\nbell\xEF\xBF\xBD\xEF\xBF\xBD");
    EXPECT_EQ(escaped("\xC3\xA9t\xC3\xA9"), "\xC3\xA9t\xC3\xA9") << "UTF-8 stays";
    EXPECT_EQ(escaped("a\xEF\xBF\xBE"
                      "b\xEF\xBF\xBF"),
              "a\xEF\xBF\xBD"
              "b\xEF\xBF\xBD")
        << "not in XML";
    EXPECT_EQ(escaped("\xEF\xBF\xBD\xEF\xBF"), "\xEF\xBF\xBD\xEF\xBF");
}

TEST(Html, LongTextsAreCutBetweenCharacters) {
    EXPECT_EQ(shortened("abc", 3), "abc");
    EXPECT_EQ(shortened("abcd", 3), "abc ...");
    EXPECT_EQ(shortened("ab\xC3\xA9t", 3), "ab ...");
}

TEST(Html, Base64IsThatOfTheStandard) {  // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Html, NumbersThatAreNoneAreNotKnown) {
    EXPECT_EQ(number_text(1.0 / 3, "m"), "0.333333 m");
    EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN(), "m"), "not known");
    EXPECT_EQ(short_cell("1.77827941004e-06"), "1.77828e-06");
    EXPECT_EQ(short_cell("hexagonal"), "hexagonal");
    EXPECT_EQ(short_cell("2 mm"), "2 mm");
    EXPECT_EQ(short_cell("nan"), "nan");
    EXPECT_EQ(wall_time_text(26.32), "26.3 s");
    EXPECT_EQ(wall_time_text(1800), "30.0 min");
    EXPECT_EQ(wall_time_text(36000), "10.0 h");
}

TEST(Html, TablesAndListsEscapeTheirCells) {
    EXPECT_THAT(table("<caption>", {"<a>"}, {{"<b>", "<c>"}}),
                testing::AllOf(testing::HasSubstr("&lt;caption&gt;"), testing::HasSubstr("&lt;a&gt;"),
                               testing::HasSubstr("&lt;b&gt;"), testing::HasSubstr("&lt;c&gt;")));
    EXPECT_EQ(list({{"<n>", "<v>"}, {"", "more"}}),
              "<dl>\n<dt>&lt;n&gt;</dt><dd>&lt;v&gt;</dd>\n<dd>more</dd>\n</dl>\n");
}

}  // namespace
}  // namespace dmp::tests::report_html_tests
