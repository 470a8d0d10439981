#include "lexer/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::lexer::diagnostics_test {
namespace {

/// One error in line 1 of `text`, as the user sees it.
std::string rendered(const std::string& text, std::uint32_t column) {
    const Source source = Source::from_text(text, "part.nc");
    std::string out;
    Diagnostics diagnostics(source, 10,
                            [&](const text::Diagnostic& reported) { out += text::to_text(reported); });
    diagnostics.error({0, 1, column}, DiagnosticKind::syntax, "wrong");
    return out;
}

TEST(Diagnostics, ShowLineAndCaret) {
    EXPECT_EQ(rendered("G1 X5\nY2\n", 4),
              "part.nc:1:4: error: wrong\n"
              "  G1 X5\n"
              "     ^\n");
    EXPECT_EQ(rendered("G1\r\n", 3), "part.nc:1:3: error: wrong\n  G1\n    ^\n") << "CR LF";
    EXPECT_EQ(rendered("", 1), "part.nc:1:1: error: wrong\n  \n  ^\n");
    EXPECT_EQ(rendered("G1", 99), "part.nc:1:99: error: wrong\n  G1\n    ^\n") << "no caret beyond the line";
}

TEST(Diagnostics, AlignCaretAfterTabs) {
    EXPECT_EQ(rendered("\tG1\tX5", 5), "part.nc:1:5: error: wrong\n  \tG1\tX5\n  \t  \t^\n");
}

TEST(Diagnostics, ReplaceControlCharacters) {
    EXPECT_EQ(rendered(std::string("G\x1b[2J\0\r1", 8), 2), "part.nc:1:2: error: wrong\n  G?[2J??1\n   ^\n");
}

TEST(Diagnostics, CutLongLinesAroundColumn) {
    const std::string digits(1000, '7');
    const std::string start = rendered(digits, 5);
    EXPECT_EQ(start, "part.nc:1:5: error: wrong\n  " + digits.substr(0, 160) + "\n      ^\n");
    const std::string middle = rendered(digits, 501);
    EXPECT_EQ(middle, "part.nc:1:501: error: wrong\n  ..." + digits.substr(0, 160) + "\n     " +
                          std::string(140, ' ') + "^\n");
}

TEST(Diagnostics, StopAfterMaxErrors) {
    const Source source = Source::from_text("X\n", "p.nc");
    std::string out;
    Diagnostics diagnostics(source, 2,
                            [&](const text::Diagnostic& reported) { out += text::to_text(reported); });
    diagnostics.warning({0, 1, 1}, DiagnosticKind::syntax, "look");
    EXPECT_EQ(diagnostics.error_count(), 0U) << "a warning is no error";
    EXPECT_FALSE(diagnostics.first_error());
    diagnostics.error({0, 1, 1}, DiagnosticKind::syntax, "one");
    EXPECT_FALSE(diagnostics.full());
    diagnostics.error({0, 1, 2}, DiagnosticKind::syntax, "two");
    diagnostics.error({0, 1, 2}, DiagnosticKind::syntax, "three");
    diagnostics.warning({0, 1, 2}, DiagnosticKind::syntax, "four");
    EXPECT_TRUE(diagnostics.full());
    EXPECT_EQ(diagnostics.error_count(), 2U);
    EXPECT_EQ(diagnostics.first_error().value().text, "one");
    EXPECT_EQ(out,
              "p.nc:1:1: warning: look\n  X\n  ^\n"
              "p.nc:1:1: error: one\n  X\n  ^\n"
              "p.nc:1:2: error: two\n  X\n   ^\n"
              "p.nc: note: stopped after 2 errors\n");
}

TEST(Diagnostics, WordEndsAfterItsNumber) {
    const auto end_of = [](const std::string& line, std::uint32_t column) {
        const Source source = Source::from_text(line, "p.nc");
        std::uint32_t end = 0;
        Diagnostics diagnostics(source, 10,
                                [&](const text::Diagnostic& reported) { end = reported.end_column; });
        diagnostics.error({0, 1, column}, DiagnosticKind::syntax, "wrong");
        return end;
    };
    EXPECT_EQ(end_of("G1 X-5.5 Y2", 4), 9U);
    EXPECT_EQ(end_of("G1 ,R5", 4), 7U);
    EXPECT_EQ(end_of("GOTO 5", 1), 5U);
    EXPECT_EQ(end_of("G1 ?", 4), 5U);
    EXPECT_EQ(end_of("G1", 9), 10U) << "behind the line";
}

TEST(Printable, EscapesOnlyControlCharacters) {
    EXPECT_EQ(printable("plain (text) --[[ \xc3\xa4"), "plain (text) --[[ \xc3\xa4");
    EXPECT_EQ(printable("a\rb\x1b\x7f\tc"), "a\\x0Db\\x1B\\x7F\tc");
    EXPECT_EQ(printable(std::string_view("\0\n", 2)), "\\x00\\x0A");
}

}  // namespace
}  // namespace gsim::lexer::diagnostics_test
