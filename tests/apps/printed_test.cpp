// Limits on what untrusted files may print on a terminal: no control characters, and a limited length.

#include <algorithm>

#include "tests/apps/run_program.h"

namespace gsim::apps::printed_test {
namespace {

class PrintedText : public Apps {
  protected:
    static bool acts(const Ended& ended) {
        const auto is_control = [](char c) {
            return (c >= 0 && c < ' ' && c != '\n' && c != '\t') || c == 0x7f;
        };
        return std::any_of(ended.out.begin(), ended.out.end(), is_control) ||
               std::any_of(ended.err.begin(), ended.err.end(), is_control);
    }
};

TEST_F(PrintedText, EscapesControlCharacters) {
    write("part.nc", "G1 X1 F100\n(\x1b]0;title\x07 and \x1b[2J) Q\x1b[31m\n");
    const Ended wrong = gcode2lua({"--check", "part.nc"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_FALSE(acts(wrong)) << wrong.out << wrong.err;
    write("part.lua", "require \"gsim\"\nprint(\"\\27[2J\", \"caf\\233\")\nprogram(1, function() end)\n");
    const Ended printed = gsim_run({"part.lua"});
    EXPECT_TRUE(contains(printed.err, "\\u001b[2J\tcaf\\xe9\n")) << printed.err;
    EXPECT_FALSE(acts(printed));
    write("message.ngc", "(MSG, \x1b[2J)\n(DEBUG, \x1b[2J)\n(PRINT, \x1b[2J)\nM2\n");
    EXPECT_FALSE(acts(gsim_run({"--dialect", "rs274ngc", "message.ngc"})));
    write("\x1b[31m.nc", "G1 X1\nbad\n");
    EXPECT_FALSE(acts(gsim_run({"\x1b[31m.nc"})));
}

TEST_F(PrintedText, LimitsLengthOfScriptOutput) {
    write("part.lua",
          "require \"gsim\"\nlocal line = string.rep(\"x\", 10000)\n"
          "program(1, function() for i = 1, 2000 do print(line) end end)\n");
    const Ended ended = gsim_run({"part.lua"});
    EXPECT_EQ(ended.status, 0) << ended.out;
    EXPECT_LT(ended.err.size(), std::size_t{5} << 20U);
    EXPECT_TRUE(ended.err.ends_with("the script has printed 4 MB; further output is suppressed\n"))
        << ended.err.substr(ended.err.size() - 200);
}

}  // namespace
}  // namespace gsim::apps::printed_test
