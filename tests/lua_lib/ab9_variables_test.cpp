// System variables by number, and output by DPRNT.

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_variables_test {
namespace {

// Returns the value of an expression after some words, as the program prints it.
std::string variable_value(const std::string& words, const std::string& expression) {
    const Outcome r = run_lua(words + " POPEN() DPRNT(\"%.4f\", " + expression + ")");
    EXPECT_TRUE(r.completed()) << words << expression << r.message();
    for (const simulation::Event& event : r.report.events)
        if (event.kind == "print") return event.detail;
    return {};
}

TEST(PositionVariables, HoldProgramMachineAndWorkPositions) {
    const std::string moved = "G10{l=2, p=1, x=100, y=200} G0{x=5, y=7, b=30}";
    EXPECT_EQ(variable_value(moved, "v[5001]"), "5.0000");
    EXPECT_EQ(variable_value(moved, "v[5002]"), "7.0000");
    EXPECT_EQ(variable_value(moved, "v[5021]"), "105.0000");
    EXPECT_EQ(variable_value(moved, "v[5041]"), "5.0000");
    EXPECT_EQ(variable_value("G20() G0{x=2}", "v[5021]"), "2.0000");
    EXPECT_EQ(variable_value("G20() G0{b=30}", "v[5024]"), "30.0000");  // angles have no inches
    EXPECT_EQ(variable_value("G51_1{x=50} G0{x=10}", "v[5001]"), "10.0000");
    EXPECT_EQ(variable_value("G51_1{x=50} G0{x=10}", "v[5021]"), "90.0000");
    EXPECT_EQ(variable_value("G10{l=10, p=1, r=25} G43{h=1}", "v[5083]"), "25.0000");
    EXPECT_EQ(variable_value("", "v[5101]"), "0.0000");
    expect_alarm(run_lua("v[1]=v[5006]"), 1, {"#5006", "5 axes"});
    expect_alarm(run_lua("v[5021]=1"), 1, {"#5021", "can only be read"});
}

TEST(ModalCodeVariables, HoldActiveCodeOfEachGroup) {
    const std::pair<std::string, std::string> cases[] = {
        {"v[4001]", "0"},  {"v[4002]", "17"}, {"v[4003]", "90"},  {"v[4004]", "23"}, {"v[4005]", "94"},
        {"v[4006]", "21"}, {"v[4007]", "40"}, {"v[4008]", "49"},  {"v[4009]", "80"}, {"v[4010]", "98"},
        {"v[4011]", "14"}, {"v[4012]", "67"}, {"v[4013]", "97"},  {"v[4014]", "54"}, {"v[4015]", "64"},
        {"v[4016]", "69"}, {"v[4017]", "15"}, {"v[4022]", "50.1"}};
    for (const auto& [variable, expected_value] : cases)
        EXPECT_EQ(variable_value("", variable), fmt::format("{:.4f}", std::stod(expected_value))) << variable;
    EXPECT_EQ(variable_value("G18()", "v[4002]"), "18.0000");
    EXPECT_EQ(variable_value("G1()", "v[4001]"), "1.0000");
    EXPECT_EQ(variable_value("G14_1{p=2}", "v[4011]"), "14.1000");
    EXPECT_EQ(variable_value("G14_1{p=2} G14_1()", "v[4011]"), "14.0000");
    EXPECT_EQ(variable_value("G59_2()", "v[4014]"), "59.2000");
    EXPECT_EQ(variable_value("G68{r=1}", "v[4016]"), "68.0000");
    EXPECT_EQ(variable_value("T(12) F(50.0) S(300)", "v[4120]*1e6 + v[4109]*1e3 + v[4119]"), "12050300.0000");
    EXPECT_EQ(variable_value("M8()", "v[4113]"), "8.0000");
    expect_alarm(run_lua("v[1]=v[4018]"), 1, {"#4018", "#4001 to #4017"});
}

TEST(ClockVariables, FollowMachineTime) {
    EXPECT_EQ(variable_value("", "v[3011]"), "20010101.0000");
    EXPECT_EQ(variable_value("G4{p=3661}", "v[3012]"), "10101.0000");
    EXPECT_EQ(variable_value("G4{p=86400*59}", "v[3011]"), "20010301.0000");
    EXPECT_EQ(variable_value("G4{p=2} v[3001]=0 G4{p=1.5}", "v[3001]"), "1500.0000");
    EXPECT_EQ(variable_value("G4{p=5400}", "v[3002]"), "1.5000");
}

TEST(MessageVariables, RaiseAlarmAndStop) {
    expect_alarm(run_lua("\nv[3000]=101"), 2, {"alarm 101"});
    EXPECT_EQ(run_lua("v[3006]=1").events(), "stop");
    expect_alarm(run_lua("v[1]=v[3000]"), 1, {"can only be set"});
    EXPECT_EQ(run_lua("v[3003]=1 v[3003]=0").report.messages.warnings.size(), 1U);
}

TEST(SignalVariables, ReadInputsFromScriptAndReportOutputs) {
    EXPECT_EQ(variable_value("on_input(function(kind, n) return n == 2 end)", "v[1002]*10 + v[1003]"),
              "10.0000");
    EXPECT_EQ(variable_value("on_input(function(kind, n) return n == 2 or n == 0 end)", "v[1032]"), "5.0000");
    EXPECT_EQ(run_lua("v[1]=v[1000] v[1]=v[1001]").report.messages.warnings.size(), 1U);
    const Outcome r = run_lua("v[1103]=1 v[1132]=1 v[1]=v[1132]");
    ASSERT_EQ(r.report.events.size(), 3U);
    EXPECT_EQ(r.report.events[0].detail, "P3 on");
    EXPECT_EQ(r.report.events[2].detail, "P3 off");
    expect_alarm(run_lua("v[1000]=1"), 1, {"#1000", "can only be read"});
}

TEST(SignalVariables, HoldMirroredAxesAsBits) {
    EXPECT_EQ(variable_value("G51_1{x=0, z=0}", "v[3007]"), "5.0000");
}

TEST(Print, RequiresOpenOutput) {
    EXPECT_EQ(run_lua("POPEN() v[1]=-0.0001 DPRNT(\"A%%%.3f %.4f\", v[1], v[1])").report.events.back().detail,
              "A%0.000 -0.0001");
    const Outcome r = run_lua("POPEN() v[1]=1.25 DPRNT(\"X%.3f Y%.1f\", v[1], v[2]) PCLOS()");
    EXPECT_EQ(r.events(), "print_open print print_close");
    EXPECT_EQ(r.report.events.at(1).detail, "X1.250 Y0.0");
    expect_alarm(run_lua("DPRNT(\"X\")"), 1, {"POPEN"});
    expect_alarm(run_lua("POPEN() PCLOS() DPRNT(\"X\")"), 1, {"POPEN"});
    expect_alarm(run_lua("POPEN() DPRNT(\"%.3f\")"), 1, {"DPRNT", "values"});
}

}  // namespace
}  // namespace gsim::script::ab9_variables_test
