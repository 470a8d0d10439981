// Heuristics for a program: of another dialect, or in inches.

#include "codegen/blocks/program_hints.h"

#include <gtest/gtest.h>

#include "grammar/controller_name.h"

namespace gsim::codegen::program_signs_test {
namespace {

std::string display_text(const std::optional<text::Diagnostic>& diagnostic) {
    return diagnostic ? text::to_text(*diagnostic) : "";
}

std::string hint(const std::string& text, const grammar::Dialect& dialect) {
    lexer::Source source = lexer::Source::from_text(text, "part.nc");
    return display_text(find_dialect_hint(source, dialect));
}

std::string as_ab9(const std::string& text) {
    return hint(text, grammar::dialect_ab9());
}
std::string as_ngc(const std::string& text) {
    return hint(text, grammar::dialect_rs274ngc());
}

TEST(DialectHint, RecognizesRs274Ngc) {
    EXPECT_EQ(as_ab9("G21\n#<depth> = 3\n"),
              "part.nc:2: note: #<name> belongs to RS274/NGC (LinuxCNC); try --dialect rs274ngc\n");
    for (const char* line : {"o100 sub\n", "O<hole> CALL [1]\n", "N5 o1 if [#1 GT 2]\n", "o2 endwhile\n"}) {
        EXPECT_EQ(as_ab9(line),
                  "part.nc:1: note: an O-word belongs to RS274/NGC (LinuxCNC); try --dialect rs274ngc\n")
            << line;
    }
    EXPECT_NE(as_ab9("#1 = [2 ** 3]\n"), "");
    EXPECT_NE(as_ab9("#1 = EXISTS[#2]\n"), "");
}

TEST(DialectHint, Recognizes9SeriesDialects) {
    EXPECT_EQ(as_ngc("%\nO0012\nIF [#1 EQ 2] GOTO 8\n"),
              "part.nc:3: note: GOTO belongs to the 9/Series (and related controllers, such as Fanuc and "
              "Haas); try --dialect ab9\n");
    EXPECT_EQ(as_ngc("WHILE [#1 LT 2] DO1\n").find("part.nc:1: note: WHILE belongs to the 9/Series"), 0U);
    EXPECT_EQ(as_ngc("G65 P9010 A1\n").find("part.nc:1: note: G65 belongs to the 9/Series"), 0U);
    EXPECT_EQ(as_ngc("G1 X10 ,R2\n").find("part.nc:1: note: ,R belongs to the 9/Series"), 0U);
    EXPECT_EQ(as_ngc("M98 P1000\n").find("part.nc:1: note: M98 P belongs to the 9/Series"), 0U);
    EXPECT_EQ(as_ngc("%\nO1234 (PART)\nG0 X1\n")
                  .find("part.nc:2: note: O with a program number belongs to the 9/Series"),
              0U);
}

TEST(DialectHint, GivesNoHintForOwnDialect) {
    EXPECT_EQ(as_ngc("o100 sub\no100 endsub\nM98 P5\n"), "");
    EXPECT_EQ(as_ngc("o1 while [#1 LT 5]\no1 endwhile\n"), "") << "an O-word's WHILE is its own";
    EXPECT_EQ(as_ab9("(o100 sub, #<a>)\nG0 X1 ; #<b>\n"), "") << "comments are no signs";
    EXPECT_EQ(as_ab9("IF [#1 EQ 2] GOTO 8\n"), "");
    EXPECT_EQ(as_ab9("G0 X1\n"), "");
}

TEST(DialectHint, NamesUnsupportedLanguages) {
    EXPECT_EQ(as_ab9("0 BEGIN PGM PLATE MM\n"),
              "part.nc:1: note: BEGIN PGM belongs to the language of Heidenhain; gsim does not support it\n");
    EXPECT_EQ(as_ab9("DEF REAL DEPTH\n"),
              "part.nc:1: note: DEF REAL belongs to the language of Sinumerik; gsim does not support it\n");
}

std::string inches(const std::string& text) {
    lexer::Source source = lexer::Source::from_text(text, "part.nc");
    return display_text(find_inch_hint(source));
}

constexpr const char* kHaas = "T1 M6\nG0 X1.125 Y-.375\nZ.1\nG1 Z-.2501 F10.\nX2.4375 F45.\nM30\n";

TEST(InchHint, WarnsAboutSmallPartWithFineStepsAndSlowFeeds) {
    EXPECT_EQ(inches(kHaas),
              "part.nc: warning: the program has neither G20 nor G21 and is read in mm, but seems to be in "
              "inches: its coordinates are within 2.4375, with up to 4 decimals, its feeds within 45; add "
              "G20 or G21, or set units = \"inch\" or \"mm\" under [program] in the machine file\n");
    EXPECT_NE(inches("G1 X30.1255 Y12.0001 Z-.5004 F20\nX20.1\n"), "")
        << "a larger one, in tenths of thousandths";
}

TEST(InchHint, GivesNoHintWithoutStrongEvidence) {
    const std::string haas = kHaas;
    EXPECT_EQ(inches("G20\n" + haas), "");
    EXPECT_EQ(inches(haas + "G21\n"), "");
    EXPECT_NE(inches("(G20)\n" + haas), "") << "a comment says nothing";
    EXPECT_EQ(inches(haas + "G1 X120\n"), "") << "too large";
    EXPECT_EQ(inches(haas + "G1 F600\n"), "") << "too fast";
    EXPECT_EQ(inches(haas + "X1.12345\n"), "") << "no control has such steps";
    EXPECT_EQ(inches("G1 X1.5 Y2.5 Z-.5 F50\nX3 Y4.25\n"), "") << "too coarse to tell";
    EXPECT_EQ(inches("G0 X1.125 Y-.375\nZ.1255\n"), "") << "no feed";
}

TEST(ControllerName, AcceptsUsualSpellings) {
    for (const char* name : {"ab9", "9/Series", "9-series", "Allen-Bradley", "ALLEN BRADLEY"}) {
        const auto control = grammar::find_controller(name);
        ASSERT_TRUE(control) << name;
        EXPECT_EQ(control->dialect, &grammar::dialect_ab9()) << name;
        EXPECT_EQ(control->caution, "") << name;
    }
    const auto linuxcnc = grammar::find_controller("LinuxCNC");
    ASSERT_TRUE(linuxcnc);
    EXPECT_EQ(linuxcnc->dialect, &grammar::dialect_rs274ngc());
    const auto haas = grammar::find_controller("haas");
    ASSERT_TRUE(haas);
    EXPECT_EQ(haas->caution.find("programs of haas are read as ab9 (Allen-Bradley 9/Series): similar"), 0U);
}

TEST(ControllerName, RejectsUnknownName) {
    EXPECT_EQ(grammar::find_controller("fanux").error(),
              "unknown dialect or controller 'fanux'; did you mean 'fanuc'?");
    EXPECT_EQ(grammar::find_controller("Heidenhain").error(),
              "the language of Heidenhain (BEGIN PGM, L X+10 FMAX) is not supported");
    EXPECT_EQ(grammar::find_controller("").error(),
              "unknown dialect or controller ''; the dialects are ab9, rs274ngc and klipper, and "
              "docs/language.md lists the controllers");
    for (const std::string& name : grammar::controller_names())
        EXPECT_TRUE(grammar::find_controller(name)) << name;
}

}  // namespace
}  // namespace gsim::codegen::program_signs_test
