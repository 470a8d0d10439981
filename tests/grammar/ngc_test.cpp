// RS274/NGC: O-words, settings among words, and how its operators bind.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/parse.h"

namespace gsim::grammar::ngc_test {
namespace {

using testing::ElementsAre;

std::string block(const std::string& text) {
    const Parsed parsed = parse_ngc(text + "\n");
    EXPECT_EQ(parsed.messages, "") << text;
    return parsed.blocks.size() == 1 ? parsed.blocks[0] : "not one block";
}

std::string messages(const std::string& text) {
    const Parsed parsed = parse_ngc(text + "\nX1\n");
    EXPECT_TRUE(parsed.finished) << text;
    EXPECT_THAT(parsed.blocks, ElementsAre("bad", "words X=1")) << text;
    return parsed.messages;
}

TEST(OWords, AcceptEveryKeyword) {
    EXPECT_EQ(block("o100 sub"), "sub o100");
    EXPECT_EQ(block("o100 endsub"), "endsub o100");
    EXPECT_EQ(block("o100 endsub [#1+2]"), "endsub o100 (+ #1 2)");
    EXPECT_EQ(block("o100 call"), "call o100");
    EXPECT_EQ(block("o100 call [1] [-2]#3 #<a>"), "call o100 1 (neg 2) #3 #<a>");
    EXPECT_EQ(block("o100 return"), "return o100");
    EXPECT_EQ(block("o100 return [1]"), "return o100 1");
    EXPECT_EQ(block("o100 if [#1 GT 2]"), "if o100 (GT #1 2)");
    EXPECT_EQ(block("o100 elseif [#1]"), "elseif o100 #1");
    EXPECT_EQ(block("o100 else"), "else o100");
    EXPECT_EQ(block("o100 endif"), "endif o100");
    EXPECT_EQ(block("o100 while [1]"), "while o100 1");
    EXPECT_EQ(block("o100 endwhile"), "endwhile o100");
    EXPECT_EQ(block("o100 do"), "do o100");
    EXPECT_EQ(block("o100 repeat [5]"), "repeat o100 5");
    EXPECT_EQ(block("o100 endrepeat"), "endrepeat o100");
    EXPECT_EQ(block("o100 break"), "break o100");
    EXPECT_EQ(block("o100 continue"), "continue o100");
    EXPECT_EQ(block("o100"), "O100 words") << "a program";
}

TEST(OWords, AcceptNumbersNamesAndExpressions) {
    EXPECT_EQ(block("O 0 1 SUB"), "sub o1");
    EXPECT_EQ(block("o<A Name>call[1]"), "call oaname 1");
    EXPECT_EQ(block("o[#1+1] call"), "call o(+ #1 1)");
    EXPECT_EQ(block("o#1 call [2]"), "call o#1 2");
    EXPECT_EQ(block("o#<a> call"), "call o#<a>");
    EXPECT_EQ(block("/2 N10 o1 call"), "N10 /2 call o1");
    const char* message =
        "an O-word whose number is an expression can only be called; others must be numbers or <names>";
    for (const char* keyword : {"sub", "endsub", "if [1]", "while [1]", "do", "break", "return"}) {
        EXPECT_EQ(messages(fmt::format("o#1 {}", keyword)), fmt::format("1:2: error: {}\n", message))
            << keyword;
        EXPECT_EQ(messages(fmt::format("o[1] {}", keyword)), fmt::format("1:3: error: {}\n", message))
            << keyword;
    }
    EXPECT_EQ(messages("o#1"),
              "1:2: error: the name of a program must be a number or a name, not an expression\n");
}

TEST(OWords, RejectWrongNumberOfValues) {
    for (const char* keyword : {"sub", "else", "endif", "endwhile", "do", "endrepeat", "break", "continue"}) {
        EXPECT_EQ(messages(fmt::format("o1 {} [1]", keyword)),
                  "1:4: error: this keyword must be followed by nothing\n");
        EXPECT_EQ(messages(fmt::format("o1 {} [1] [2]", keyword)),
                  "1:4: error: this keyword must be followed by nothing\n");
    }
    for (const char* keyword : {"if", "elseif", "while"}) {
        for (const char* values : {"", " [1] [2]"}) {
            EXPECT_EQ(messages(fmt::format("o1 {}{}", keyword, values)),
                      "1:4: error: this keyword must be followed by its condition in brackets\n");
        }
    }
    EXPECT_EQ(messages("o1 repeat"),
              "1:4: error: this keyword must be followed by the number of repetitions in brackets\n");
    EXPECT_EQ(messages("o1 repeat [1][2]"),
              "1:4: error: this keyword must be followed by the number of repetitions in brackets\n");
    EXPECT_EQ(messages("o1 endsub [1][2]"),
              "1:4: error: this keyword must be followed by at most one value\n");
    EXPECT_EQ(messages("o1 return [1][2]"),
              "1:4: error: this keyword must be followed by at most one value\n");
    EXPECT_EQ(parse_ngc(repeated("o1 call", " [1]", 30) + "\n").messages, "");
    EXPECT_EQ(messages(repeated("o1 call", " [1]", 31)),
              "1:4: error: this keyword must be followed by up to 30 values, each in brackets\n");
    EXPECT_EQ(messages(repeated("o1 call", " [1]", 600)),
              "1:4: error: this keyword must be followed by up to 30 values, each in brackets\n");
}

TEST(OWords, RejectInvalidSyntax) {
    EXPECT_EQ(messages("o1 call 5"), "1:9: error: values after an O-word must be in brackets\n");
    EXPECT_EQ(block("o1 5"), "O15 words") << "blanks mean nothing: a program";
    EXPECT_EQ(messages("G1 X1 o1 call"),
              "1:7: error: an O-word must be at the start of a block, and only once\n");
    EXPECT_EQ(messages("o1 call o2 call"), "1:9: error: 'o' is not a keyword after an O-word\n");
    EXPECT_EQ(messages("o1 call [1"), "1:11: error: ']' is missing at the end of the block\n");
    EXPECT_EQ(messages("o1 call []"), "1:10: error: ']' is not allowed here\n");
    EXPECT_EQ(messages("o1 else while"),
              "1:9: error: an O-word must be followed by one keyword, with its values in brackets\n");
    EXPECT_EQ(block("o1 else if [#1]"), block("o1 elseif [#1]"));
    EXPECT_EQ(messages("o1 sub G1 X1"), "1:8: error: 'G' is not a keyword after an O-word\n");
    EXPECT_EQ(messages("o1 if #1 = 2"), "1:10: error: '=' is not allowed here\n");
    EXPECT_EQ(
        messages("IF[#1 EQ 2]GOTO5"),
        "1:1: error: I has no value; IF, WHILE, GOTO and END belong to the 9/Series, see --dialect ab9\n");
    EXPECT_EQ(
        messages("WHILE[#1]DO1"),
        "1:1: error: W has no value; IF, WHILE, GOTO and END belong to the 9/Series, see --dialect ab9\n");
}

/// LinuxCNC removes all blanks from a block before it reads it.
TEST(NgcBlanks, AreIgnored) {
    EXPECT_EQ(block("X[1 2 . 5] Y[. 5] Z#1 2"), "words X=12.5 Y=.5 Z=#12");
    EXPECT_EQ(block("#1 2=1 2"), "words #12:=12");
    EXPECT_EQ(block("X s i n [#1 m o d 2] Y[1 e q 2and3]"), "words X=(SIN (MOD #1 2)) Y=(AND (EQ~ 1 2) 3)");
    EXPECT_EQ(block("X[4modsin[90]]"), "words X=(MOD 4 (SIN 90))") << "names end without blanks too";
    EXPECT_EQ(block("o1 e n d i f"), block("o1 endif"));
    EXPECT_EQ(messages("X[1 mod foo 2]"),
              "1:9: error: 'foo' is not a function or operator of an expression\n");
    EXPECT_EQ(parse("X[1 2]\n").messages, "1:5: error: a number without its letter\n")
        << "but in the 9/Series";
}

TEST(NgcNumbers, ParameterNumbersMayHaveZeroDecimals) {
    EXPECT_EQ(block("#1.0=2 X#1. Y[#2.00+1]"), "words X=#1 Y=(+ #2 1) #1:=2");
    EXPECT_EQ(messages("X#1.5"), "1:2: error: the number of a variable must be an integer, not 1.5\n");
    EXPECT_EQ(messages("X#.5"), "1:2: error: the number of a variable must be an integer, not .5\n");
}

TEST(NgcSigns, CanBeRepeated) {
    EXPECT_EQ(block("X--5 Y+-3 Z- -#1 #2=--3"),
              "words X=(neg (neg 5)) Y=(neg 3) Z=(neg (neg #1)) #2:=(neg (neg 3))");
    EXPECT_EQ(block("X[--3] Y[2---3] Z[--2**2] A--[3]"),
              "words X=(neg (neg 3)) Y=(- 2 (neg (neg 3))) Z=(** (neg (neg 2)) 2) A=(neg (neg 3))");
    EXPECT_EQ(block("X[--atan[1]/[2]] Y--sin[1]"), "words X=(neg (neg (ATAN 1 2))) Y=(neg (neg (SIN 1)))");
}

TEST(NgcAssignments, AreAllowedAmongWords) {
    EXPECT_EQ(block("G1 #1=2 X#1 #<a>=#1 F5"), "words G=1 X=#1 F=5 #1:=2 #<a>:=#1");
    EXPECT_EQ(block("# 1 = 2"), "words #1:=2");
    EXPECT_EQ(block("#1=exists[#<a>] #2=exists[#3]"), "words #1:=(EXISTS #<a>) #2:=(EXISTS #3)");
    EXPECT_EQ(block("X[exists[#[1+2]]+1]"), "words X=(+ (EXISTS (# (+ 1 2))) 1)");
    EXPECT_EQ(messages("#1=#2+3"), "1:6: error: '+' is not allowed here\n");
    EXPECT_EQ(messages("#1=2+3"), "1:5: error: '+' is not allowed here\n");
    EXPECT_EQ(messages("X1=2"), "1:3: error: '=' is not allowed here\n");
    EXPECT_EQ(messages("X[** 2]"), "1:3: error: the operator has no value before it\n");
    EXPECT_EQ(messages("X[1 AND OR 2]"), "1:9: error: the operator has no value before it\n");
    EXPECT_EQ(messages("SIN[1]"),
              "1:1: error: a function must be in the value of a word or in an expression\n");
    EXPECT_EQ(block("#atan[1]/[1]=3"), "words (# (ATAN 1 1)):=3");
    EXPECT_EQ(block("#-[-3]=3 X#sin[90]"), "words X=(# (SIN 90)) (# (neg (neg 3))):=3");
    EXPECT_EQ(messages("#1"), "1:1: error: a variable must be the value of a word, or precede '='\n");
    EXPECT_EQ(messages("X1 #<a>"), "1:4: error: a variable must be the value of a word, or precede '='\n");
    EXPECT_EQ(messages("X[EXISTS[1]]"), "1:10: error: a number without its letter\n");
    EXPECT_EQ(messages("X[EXISTS[#1+1]]"), "1:12: error: '+' is not allowed here\n");
}

std::string tree(const std::string& expression, const Dialect& dialect) {
    const Parsed parsed = parse("F[" + expression + "]\n", dialect);
    EXPECT_EQ(parsed.messages, "") << expression;
    const std::string start = "words F=";
    return parsed.blocks.size() == 1 && parsed.blocks[0].starts_with(start)
               ? parsed.blocks[0].substr(start.size())
               : "no expression";
}

std::string ngc(const std::string& expression) {
    return tree(expression, dialect_rs274ngc());
}

TEST(NgcExpressions, PowersBindStrongestFromLeftToRight) {
    EXPECT_EQ(ngc("2**3**2"), "(** (** 2 3) 2)");
    EXPECT_EQ(ngc("2*3**2*4"), "(* (* 2 (** 3 2)) 4)");
    EXPECT_EQ(ngc("-2**2"), "(** (neg 2) 2)") << "the sign belongs to the number";
    EXPECT_EQ(ngc("2**-1"), "(** 2 (neg 1))");
    EXPECT_EQ(ngc("-#1**[2+1]"), "(** (neg #1) (+ 2 1))");
    EXPECT_EQ(ngc("[1+2]**SIN[3]"), "(** (+ 1 2) (SIN 3))");
    EXPECT_EQ(ngc("8/2**2 MOD 3"), "(MOD (/ 8 (** 2 2)) 3)");
    EXPECT_EQ(ngc("1+2**3 EQ 9"), "(EQ~ (+ 1 (** 2 3)) 9)");
}

TEST(NgcExpressions, ComparisonsMayBeChained) {
    EXPECT_EQ(ngc("1 LT 2 LT 3"), "(LT (LT 1 2) 3)");
    EXPECT_EQ(ngc("1 EQ 2 NE 3 GE 4"), "(GE (NE~ (EQ~ 1 2) 3) 4)");
    EXPECT_EQ(ngc("1+2 GT 3-4 LE 5*6"), "(LE (GT (+ 1 2) (- 3 4)) (* 5 6))");
}

TEST(NgcExpressions, LogicBindsWeakest) {
    EXPECT_EQ(ngc("1 OR 2 AND 3"), "(AND (OR 1 2) 3)") << "all three alike";
    EXPECT_EQ(ngc("1 XOR 2 OR 3 AND 4"), "(AND (OR (XOR 1 2) 3) 4)");
    EXPECT_EQ(ngc("#1 GT 2 AND #3 LT 4 OR 5"), "(OR (AND (GT #1 2) (LT #3 4)) 5)");
    EXPECT_EQ(ngc("1+2 AND 3*4"), "(AND (+ 1 2) (* 3 4))");
    EXPECT_EQ(ngc("1 AND [2 OR 3]"), "(AND 1 (OR 2 3))");
}

/// In the 9/Series AND binds as *, OR and XOR as +, and comparisons weakest.
TEST(NgcExpressions, BindDifferentlyFrom9Series) {
    const auto ab9 = [](const std::string& expression) { return tree(expression, dialect_ab9()); };
    EXPECT_EQ(ab9("1 OR 2 AND 3"), "(OR 1 (AND 2 3))");
    EXPECT_EQ(ab9("1+2 AND 3*4"), "(+ 1 (* (AND 2 3) 4))");
    EXPECT_EQ(ab9("1 XOR 2+3"), "(+ (XOR 1 2) 3)");
    EXPECT_EQ(ab9("1 EQ 2 AND 3"), "(EQ 1 (AND 2 3))");
    EXPECT_EQ(ngc("1 EQ 2 AND 3"), "(AND (EQ~ 1 2) 3)");
    EXPECT_EQ(parse("F[1 LT 2 LT 3]\n").messages,
              "1:10: error: a comparison is not allowed here; comparisons are combined as [..] AND [..]\n");
}

}  // namespace
}  // namespace gsim::grammar::ngc_test
