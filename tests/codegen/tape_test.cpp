// Text around the program in a file: tape marks, the leader before them, the end of a DOS file.
#include <gtest/gtest.h>

#include "tests/codegen/translated.h"

namespace gsim::codegen::tape_test {
namespace {

using namespace std::string_literals;

constexpr const char* kProgram = "%\nO7\nG0 X1\nM30\n%\n";

TEST(Tape, SkipsLeaderBeforeFirstMark) {
    const Translated result = translated("part 12, rev (b\nmade by Meier\n"s + kProgram);
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(
        result.messages,
        "1:1: warning: the 2 lines before the first % are skipped: the leader of a tape, not a program\n");
    EXPECT_EQ(result.code(1), "");
    EXPECT_NE(result.lua.find("-- (made by Meier)"), std::string::npos) << "as remarks";
    EXPECT_EQ(result.code(4), "program(7, function()");
    EXPECT_EQ(result.code(5), "G0{x=1}");
    EXPECT_EQ(translated("part 12\n%\nG0 X1\n").messages,
              "1:1: warning: the line before the first % is skipped: the leader of a tape, not a program\n");
}

TEST(Tape, ReadsProgramBeforeFirstMark) {
    const Translated result = translated("G0 X5\n%\nG0 X1\n%\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(result.code(1), "G0{x=5}");
    EXPECT_EQ(translated("(head)\n\n%\nG0 X1\n").messages, "");
    EXPECT_EQ(translated("G0 X5\nGG1\n%\nG0 X1\n").messages.substr(0, 4), "2:1:") << "an error in a program";
    EXPECT_EQ(translated("part 12\n%\n").messages.substr(0, 4), "1:1:") << "nothing stands behind the mark";
    EXPECT_FALSE(translated_ngc("part 12\n%\nG0 X1\n%\n").ok) << "LinuxCNC does not pass it over";
}

TEST(Tape, TreatsTextAfterMarkAsComment) {
    const Translated result = translated("%123 some text\nO7\nG0 X1\nM30\n% the end\n");
    ASSERT_TRUE(result.ok) << result.messages;
    EXPECT_EQ(result.code(2), "program(7, function()");
    EXPECT_NE(result.lua.find("-- (123 some text)"), std::string::npos) << result.lua;
    EXPECT_EQ(translated("%O1200(LATHE)\nG0 X1\nM30\n").code(1), "program(1200, function()")
        << "but for the number of a program";
    EXPECT_EQ(translated("G0 X1 %\n").messages, "1:7: error: a tape mark % must be at the start of a line\n");
    EXPECT_FALSE(translated_ngc("% text\nG0 X1\n%\n").ok) << "LinuxCNC refuses it";
}

TEST(Tape, DosEndOfFileByteEndsFile) {
    for (const std::string& end : {"\n\x1A"s, "\x1A"s, "\n%\n\x1A"s, "\r\n\x1A\x1A\0\0"s, "\n\x1A\n\n"s}) {
        const Translated result = translated("G0 X1\nM30" + end);
        EXPECT_EQ(result.messages, "");
        EXPECT_EQ(result.code(2).substr(0, 5), "M30()");
    }
    EXPECT_EQ(translated("#1=2\x1A").messages, "");
    EXPECT_EQ(translated("G0 X1\n\x1A\nG0 X2\n").messages,
              "3:1: error: there is text after the byte 0x1A, which ends a DOS file\n");
    EXPECT_EQ(translated("G0 X1 \x1A Y2\n").messages,
              "1:9: error: there is text after the byte 0x1A, which ends a DOS file\n");
    EXPECT_TRUE(translated_ngc("G0 X1\nM2\n\x1A").ok);
    EXPECT_FALSE(translated_ngc("G0 X1\n\x1A").ok) << "LinuxCNC refuses it before M2 or %";
}

TEST(Tape, RejectsNestedComments) {
    EXPECT_EQ(translated_ngc("(a (b) G1 X2 F100\n").messages,
              "1:4: error: a comment must not contain another '('; LinuxCNC also rejects it\n");
    EXPECT_TRUE(translated_ngc("G1 X2 F100 ; (c (d))\n").ok) << "a remark is no such comment";
    EXPECT_EQ(
        translated("O7 (PART (REV B))\nG0 X1\n").messages,
        "1:17: error: ')' without '('; a comment ends at its first ')', even if it contains another '('\n");
    EXPECT_TRUE(translated("O7 (PART (REV B)\nG0 X1\n").ok);
}

}  // namespace
}  // namespace gsim::codegen::tape_test
