// Variables, expressions and the flow of control as a program uses them at run time.

#include <cmath>

#include "tests/lua_lib/run.h"

namespace gsim::script::variables_test {
namespace {

// Returns the value of an expression, by a move: X moves to 500 + the value.
double variable_value(const std::string& expression) {
    const Outcome r = run("G0 X[500+" + expression + "]\nG91 G0 Y1\n");
    EXPECT_TRUE(r.completed()) << expression << ": " << r.message();
    return r.moves.empty() ? NAN : r.end()[0] - 500;
}

TEST(Expressions, ArithmeticFollowsPrecedence) {
    EXPECT_DOUBLE_EQ(variable_value("[1+2*3]"), 7);
    EXPECT_DOUBLE_EQ(variable_value("[[1+2]*3]"), 9);
    EXPECT_DOUBLE_EQ(variable_value("[10-2-3]"), 5);
    EXPECT_DOUBLE_EQ(variable_value("[7/2]"), 3.5);
    EXPECT_DOUBLE_EQ(variable_value("[-2*3]"), -6);
    EXPECT_DOUBLE_EQ(variable_value("[2--3]"), 5);
    EXPECT_DOUBLE_EQ(variable_value("[17 MOD 5]"), 2);
    EXPECT_DOUBLE_EQ(variable_value("[12 AND 10]"), 8);
    EXPECT_DOUBLE_EQ(variable_value("[12 OR 10]"), 14);
    EXPECT_DOUBLE_EQ(variable_value("[12 XOR 10]"), 6);
}

TEST(Expressions, FunctionsReturnExpectedValues) {
    EXPECT_NEAR(variable_value("SIN[30]"), 0.5, 1e-9);
    EXPECT_NEAR(variable_value("COS[60]"), 0.5, 1e-9);
    EXPECT_NEAR(variable_value("TAN[45]"), 1, 1e-9);
    EXPECT_NEAR(variable_value("ASIN[0.5]"), 30, 1e-9);
    EXPECT_NEAR(variable_value("ACOS[0.5]"), 60, 1e-9);
    EXPECT_NEAR(variable_value("ATAN[1]"), 45, 1e-9);
    EXPECT_NEAR(variable_value("ATAN[1]/[-1]"), 135, 1e-9);
    EXPECT_NEAR(variable_value("ATAN[-1]/[-1]"), 225, 1e-9);
    EXPECT_NEAR(variable_value("SQRT[2]"), std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(variable_value("ABS[-4.5]"), 4.5, 1e-9);
    EXPECT_NEAR(variable_value("LN[10]"), std::log(10.0), 1e-9);
    EXPECT_NEAR(variable_value("EXP[2]"), std::exp(2.0), 1e-9);
    EXPECT_NEAR(variable_value("ROUND[2.5]"), 3, 1e-9);
    EXPECT_NEAR(variable_value("ROUND[-2.5]"), -3, 1e-9);
    EXPECT_NEAR(variable_value("FIX[2.9]"), 2, 1e-9);
    EXPECT_NEAR(variable_value("FIX[-2.9]"), -2, 1e-9);
    EXPECT_NEAR(variable_value("FUP[2.1]"), 3, 1e-9);
    EXPECT_NEAR(variable_value("FUP[-2.1]"), -3, 1e-9);
    EXPECT_NEAR(variable_value("BIN[18]"), 12, 1e-9);  // 12 in BCD is 0x12, 18
    EXPECT_NEAR(variable_value("BCD[12]"), 18, 1e-9);
}

TEST(Expressions, RejectsValuesOutsideDomain) {
    for (const char* expression :
         {"[1/0]", "[5 MOD 0]", "SQRT[-1]", "LN[0]", "ASIN[1.1]", "ACOS[-2]", "BCD[-1]", "[1/#5]"}) {
        const Outcome r = run(std::string("#1=") + expression + "\n");
        EXPECT_EQ(r.report.status, simulation::RunStatus::alarm) << expression;
        EXPECT_EQ(r.line(), 1U) << expression;
    }
    expect_alarm(run("G0 X[EXP[1000]]\n"), 1, {"X", "not a number"});
}

TEST(Variables, VacantIsZeroInArithmeticAndComparison) {
    EXPECT_DOUBLE_EQ(variable_value("[#1+2]"), 2);
    EXPECT_DOUBLE_EQ(variable_value("[#1*#2]"), 0);
    EXPECT_DOUBLE_EQ(variable_value("[-#1]"), 0);
    EXPECT_DOUBLE_EQ(variable_value("COS[#1]"), 1);
    expect_end(run("IF[#1 LT 1]GOTO5\nG0 X9\nN5 G0 Y1\n"), 0, 1, 0);
    expect_end(run("IF[#1 GE 0]GOTO5\nG0 X9\nN5 G0 Y1\n"), 0, 1, 0);
}

TEST(Variables, VacantOmitsWord) {
    expect_end(run("G0 X5 Y5\nX#1 Y7\n"), 5, 7, 0);
    expect_end(run("G0 X5\nG1 F100 X6\nF#1 X7\nG4 P#1\nS#1\n"), 7, 0, 0);
    EXPECT_EQ(run("G0 X5\nX#1\n").moves.size(), 1U);
}

TEST(Variables, VacantEqualsOnlyItself) {
    expect_end(run("IF[#1 EQ 0]GOTO5\nG0 X9\nN5 G0 Y1\n"), 9, 1, 0);
    expect_end(run("IF[#1 EQ #0]GOTO5\nG0 X9\nN5 G0 Y1\n"), 0, 1, 0);
    expect_end(run("#1=0\nIF[#1 EQ #0]GOTO5\nG0 X9\nN5 G0 Y1\n"), 9, 1, 0);
    expect_end(run("#1=5\n#1=#0\nIF[#1 EQ #0]GOTO5\nG0 X9\nN5 G0 Y1\n"), 0, 1, 0);
}

TEST(Variables, AcceptIndirectAndComputedNumbers) {
    expect_end(run("#1=100\n#100=7\nG0 X##1\n"), 7, 0, 0);
    expect_end(run("#3=1\n#[#3+1]=8\nG0 X#2\n"), 8, 0, 0);
    expect_end(run("#2=8\nG0 X#[0.1*20]\n"), 8, 0, 0);
}

TEST(Variables, StartWithValuesOfMachineData) {
    Conditions setup;
    setup.options.data.variables[500] = 12.5;
    expect_end(run("G0 X#500\n#500=3\nG0 Y#500\n", setup), 12.5, 3, 0);
}

TEST(Variables, RejectsUnknownNumbers) {
    expect_alarm(run("G0 X1\nG0 X#34\n"), 2, {"#34"});
    expect_alarm(run("G0 X1\n#200=1\n"), 2, {"#200"});
    expect_alarm(run("G0 X1\n#0=1\n"), 2, {"#0"});
    expect_alarm(run("G0 X1\n#[1.5]=1\n"), 2, {"#1.5"});
    expect_alarm(run("G0 X1\n#[0-1]=1\n"), 2, {"#-1"});
    expect_alarm(run("G0 X1\nG0 X#1999\n"), 2, {"#1999", "system variables"});
}

TEST(ProgramFlow, ThenAssignsOnlyIfTrue) {
    expect_end(run("#1=5\nIF[#1 EQ 5]THEN #2=3\nIF[#1 NE 5]THEN #2=4\nG0 X#2\n"), 3, 0, 0);
}

TEST(ProgramFlow, GotoJumpsForwardsAndBackwards) {
    expect_end(run("#1=0\nN10 #1=#1+1\nG91 G0 X1\nIF[#1 LT 5]GOTO10\nG90 G0 Y1\n"), 5, 1, 0);
    expect_end(run("GOTO20\nN10 G0 X1\nGOTO30\nN20 G0 X2\nGOTO10\nN30 G0 Y1\n"), 1, 1, 0);
}

TEST(ProgramFlow, GotoAcceptsComputedTarget) {
    expect_end(run("#1=20\nGOTO#1\nN10 G0 X1\nN20 G0 Y2\n"), 0, 2, 0);
    expect_end(run("GOTO[10*2]\nN10 G0 X1\nN20 G0 Y2\n"), 0, 2, 0);
    expect_alarm(run("G0 X1\nGOTO[#1+15]\nN10 G0 X1\n"), 2, {"15"});
}

TEST(ProgramFlow, WhileLoopsNest) {
    expect_end(
        run("#1=0\nWHILE[#1 LT 3]DO1\n#2=0\nWHILE[#2 LT 4]DO2\nG91 G0 X1\n#2=#2+1\nEND2\n#1=#1+1\nEND1\n"),
        12, 0, 0);
    expect_end(run("G0 Y1\nWHILE[#1 GT 0]DO1\nG0 X9\nEND1\n"), 0, 1, 0);
    expect_end(run("#1=0\nWHILE[#1 LT 9]DO1\n#1=#1+1\nIF[#1 EQ 4]GOTO99\nEND1\nN99 G0 X#1\n"), 4, 0, 0);
}

TEST(ProgramFlow, ComparisonsSelectJump) {
    for (const auto& [condition, truth] : std::vector<std::pair<std::string, bool>>{{"1 EQ 1", true},
                                                                                    {"1 NE 1", false},
                                                                                    {"2 GT 1", true},
                                                                                    {"1 GT 1", false},
                                                                                    {"1 GE 1", true},
                                                                                    {"1 LT 1", false},
                                                                                    {"1 LE 1", true}}) {
        expect_end(run("IF[" + condition + "]GOTO5\nG0 X9\nN5 G0 Y1\n"), truth ? 0 : 9, 1, 0);
    }
}

TEST(Globals, RejectsUnknownNameWithSuggestion) {
    expect_alarm(run_lua("local _ENV = require \"gsim\"\ng0{x=1}\n"), 2, {"'g0'", "did you mean G0?"});
    expect_alarm(run_lua("local _ENV = require \"gsim\"\n\nG0{x=speed}\n"), 3, {"'speed'"});
    expect_alarm(run_lua("G0{x=1}\nmovelinear{x=1}\n"), 2, {"did you mean MoveLinear?"});
}

TEST(Globals, AcceptsUserDefinitions) {
    expect_end(run_lua("function corner(x, y) G0{x=x, y=y} end\nfor i = 1, 3 do corner(i, 2*i) end\n"), 3, 6,
               0);
}

}  // namespace
}  // namespace gsim::script::variables_test
