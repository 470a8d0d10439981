// Tools and their offsets: what T, M6, H, D, G43, G44 and G49 do in each dialect; every value is worked out
// by hand.

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::tools_test {
namespace {

Outcome run_ab9(const std::string& lua) {
    return run_lua(lua, with_tools());
}

Outcome run_rs274(const std::string& lua, const Conditions& setup = with_tools()) {
    return run_ngc_lua(lua, setup);
}

TEST(ToolsNgc, SelectionAndChangeAreReported) {
    const Outcome r = run_rs274("T(1)\nM6()\nT(2)\nM6()");
    EXPECT_EQ(r.events(), "tool_select tool_change tool_select tool_change");
    EXPECT_EQ(r.report.events.at(1).detail, "T1");
    EXPECT_EQ(r.report.events.at(3).detail, "T2");
}

TEST(ToolsNgc, ChangeStopsSpindle) {
    EXPECT_EQ(run_rs274("M3() T(1) M6()").events(), "spindle_cw tool_select spindle_off tool_change");
}

TEST(ToolsNgc, LengthComesFromLoadedToolOrH) {
    expect_end(run_rs274("G43() G0{z=5}"), 0, 0, 5);
    expect_end(run_rs274("T(1) M6()\nG43() G0{z=5}"), 0, 0, 15);
    expect_end(run_rs274("T(1) M6()\nG43{h=2} G0{z=5}"), 0, 0, 30);
    expect_end(run_rs274("G43{h=2} G0{z=5}\nG49() G0{z=5}"), 0, 0, 5);
    expect_end(run_rs274("G43{h=2} G0{z=5}\nG43{h=0} G0{z=5}"), 0, 0, 5);
    expect_end(run_rs274("M61{q=2} G43() G0{z=5}"), 0, 0, 30);
}

TEST(ToolsNgc, OffsetAloneCausesNoMotion) {
    const Outcome r = run_rs274("G0{z=100}\nG43{h=2}\nG0{x=10}\nG91() G0{z=1}");
    expect_end(r, 10, 0, 101);
    EXPECT_EQ(r.moves.size(), 3U);
}

TEST(ToolsNgc, DynamicOffsetsApplyToAnyAxis) {
    expect_end(run_rs274("G43_1{x=5, z=7} G0{x=1, y=2, z=3}"), 6, 2, 10);
    expect_end(run_rs274("G43_1{x=5} G43_1{z=7} G0{x=1, z=3}"), 6, 0, 10);
    expect_end(run_rs274("G20() G43_1{z=1} G0{z=1}"), 0, 0, 50.8);
    expect_end(run_rs274("G43{h=1} G43_2{h=2} G0{z=5}"), 0, 0, 40);
    expect_end(run_rs274("G43{h=1} G43_2{x=3, z=1} G0{x=1, z=5}"), 4, 0, 16);
    expect_alarm(run_rs274("G43_2()"), "G43.2");
    expect_alarm(run_rs274("G43_2{h=1, z=2}"), "G43.2");
}

TEST(ToolsNgc, RejectsNumbersMissingInTable) {
    expect_alarm(run_rs274("T(5)"), "it has 1, 2");
    expect_alarm(run_rs274("G43{h=5}"), "H5");
    expect_alarm(run_rs274("M61{q=5}"), "Q5");
    expect_alarm(run_rs274("M61()"), "needs Q");
    expect_alarm(run_rs274("T(1.5)"), 1, {"[word-value]", "T must be an integer", "1.5"});
}

// Missing lengths can be taken as 0, a missing diameter cannot.
TEST(ToolsNgc, WarnsOfZeroLengthsWithoutTable) {
    const Outcome r = run_rs274("T(1) M6() G43() G0{z=5}", {});
    expect_end(r, 0, 0, 5);
    ASSERT_EQ(r.report.messages.warnings.size(), 1U);
    EXPECT_NE(r.report.messages.warnings[0].find("section TOOL"), std::string::npos);
    expect_alarm(run_rs274("T(1) M6() G41{d=1} G1{x=10}", {}), "section TOOL");
}

TEST(ToolsAb9, G43AddsAndG44SubtractsLength) {
    expect_end(run_ab9("G43{h=2} G0{z=5}"), 0, 0, 30);
    expect_end(run_ab9("G44{h=2} G0{z=50}"), 0, 0, 25);
    expect_end(run_ab9("G43{h=2} G0{z=5}\nG49() G0{z=5}"), 0, 0, 5);
    expect_end(run_ab9("G43{h=2} G0{z=5}\nG43{h=0} G0{z=5}"), 0, 0, 5);
}

TEST(ToolsAb9, HAloneSelectsAnotherOffset) {
    expect_end(run_ab9("H(1) G0{z=5}"), 0, 0, 5);  // no offset is active
    expect_end(run_ab9("H(1) G43() G0{z=5}"), 0, 0, 15);
    expect_end(run_ab9("G43{h=1} H(2) G0{z=5}"), 0, 0, 30);
    expect_end(run_ab9("G44{h=1} H(2) G0{z=50}"), 0, 0, 25);
    expect_end(run_ab9("G43{h=1} H(0) G0{z=5}"), 0, 0, 5);
}

TEST(ToolsAb9, ToolNumbersAreIndependentOfOffsetNumbers) {
    const Outcome r = run_ab9("T(7) M6()\nD(3)");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.events(), "tool_select tool_change");
    expect_alarm(run_ab9("G43{h=5}"), "it has 1, 2");
    expect_alarm(run_ab9("H(-1)"), 1, {"[word-value]", "H must be an integer", "-1"});
    expect_alarm(run_ab9("D(0.5)"), 1, {"[word-value]", "D must be an integer", "0.5"});
}

}  // namespace
}  // namespace gsim::script::tools_test
