#include "lexer/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::lexer {
namespace {

/// One error in line 1 of `text`, as the user sees it.
std::string rendered(const std::string& text, std::uint32_t column) {
    const Source source = Source::from_text(text, "part.nc");
    std::string out;
    Diagnostics diagnostics(source, 10, [&](std::string_view message) { out += message; });
    diagnostics.error({0, 1, column}, "wrong");
    return out;
}

TEST(Diagnostics, LineAndCaret) {
    EXPECT_EQ(rendered("G1 X5\nY2\n", 4),
              "part.nc:1:4: error: wrong\n"
              "  G1 X5\n"
              "     ^\n");
    EXPECT_EQ(rendered("G1\r\n", 3), "part.nc:1:3: error: wrong\n  G1\n    ^\n") << "CR LF";
    EXPECT_EQ(rendered("", 1), "part.nc:1:1: error: wrong\n  \n  ^\n");
    EXPECT_EQ(rendered("G1", 99), "part.nc:1:99: error: wrong\n  G1\n    ^\n") << "no caret beyond the line";
}

TEST(Diagnostics, TabsKeepTheCaretInPlace) {
    EXPECT_EQ(rendered("\tG1\tX5", 5), "part.nc:1:5: error: wrong\n  \tG1\tX5\n  \t  \t^\n");
}

TEST(Diagnostics, ControlCharactersCannotReachTheTerminal) {
    EXPECT_EQ(rendered(std::string("G\x1b[2J\0\r1", 8), 2), "part.nc:1:2: error: wrong\n  G?[2J??1\n   ^\n");
}

TEST(Diagnostics, LongLinesAreCutAroundTheColumn) {
    const std::string digits(1000, '7');
    const std::string start = rendered(digits, 5);
    EXPECT_EQ(start, "part.nc:1:5: error: wrong\n  " + digits.substr(0, 160) + "\n      ^\n");
    const std::string middle = rendered(digits, 501);
    EXPECT_EQ(middle, "part.nc:1:501: error: wrong\n  ..." + digits.substr(0, 160) + "\n     " +
                          std::string(140, ' ') + "^\n");
}

TEST(Diagnostics, StopsAfterTheLastErrorAllowed) {
    const Source source = Source::from_text("X\n", "p.nc");
    std::string out;
    Diagnostics diagnostics(source, 2, [&](std::string_view message) { out += message; });
    diagnostics.warning({0, 1, 1}, "look");
    EXPECT_EQ(diagnostics.error_count(), 0U) << "a warning is no error";
    EXPECT_EQ(diagnostics.first_error(), "");
    diagnostics.error({0, 1, 1}, "one");
    EXPECT_FALSE(diagnostics.full());
    diagnostics.error({0, 1, 2}, "two");
    diagnostics.error({0, 1, 2}, "three");
    diagnostics.warning({0, 1, 2}, "four");
    EXPECT_TRUE(diagnostics.full());
    EXPECT_EQ(diagnostics.error_count(), 2U);
    EXPECT_EQ(diagnostics.first_error(), "p.nc:1:1: one");
    EXPECT_EQ(out,
              "p.nc:1:1: warning: look\n  X\n  ^\n"
              "p.nc:1:1: error: one\n  X\n  ^\n"
              "p.nc:1:2: error: two\n  X\n   ^\n"
              "p.nc: 2 errors, giving up\n");
}

TEST(Printable, EscapesControlCharactersAndNothingElse) {
    EXPECT_EQ(printable("plain (text) --[[ \xc3\xa4"), "plain (text) --[[ \xc3\xa4");
    EXPECT_EQ(printable("a\rb\x1b\x7f\tc"), "a\\x0Db\\x1B\\x7F\tc");
    EXPECT_EQ(printable(std::string_view("\0\n", 2)), "\\x00\\x0A");
}

}  // namespace
}  // namespace gsim::lexer
