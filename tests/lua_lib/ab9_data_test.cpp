// G10 and the system variables that hold the same data.

#include "tests/lua_lib/run.h"

namespace gsim::script::ab9_data_test {
namespace {

TEST(DataSetting, G10L2SetsWorkCoordinateSystems) {
    expect_end(run_lua("G10{l=2, p=1, x=10, y=5} G0{x=1, y=1}"), 11, 6, 0);
    expect_end(run_lua("G10{l=2, p=9, x=10} G0{x=1} G59_3() G0{x=1}"), 11, 0, 0);
    expect_end(run_lua("G10{l=2, p=1, x=10} G91() G10{l=2, p=1, x=5} G90() G0{x=1}"), 16, 0, 0);
    expect_end(run_lua("G20() G10{l=2, p=1, x=1} G21() G0{x=1}"), 26.4, 0, 0);
    expect_end(run_lua("G10{l=2, p=1, c=30} G0{c=10}"), 0, 0, 0, 0, 40);
    EXPECT_TRUE(run_lua("G10{l=2, p=1, x=10}").moves.empty());
}

TEST(DataSetting, ExternalOffsetMovesAllSystems) {
    expect_end(run_lua("G10{l=2, p=0, x=10} G10{l=2, p=2, x=5} G55() G0{x=1}"), 16, 0, 0);
    expect_end(run_lua("G10{l=2, p=0, x=10} G0{x=1}"), 11, 0, 0);
}

TEST(DataSetting, G10L20SetsSettableFrames) {
    expect_end(run_lua("G10{l=20, p=5, x=10} G505() G0{x=1}"), 11, 0, 0);
    expect_end(run_lua("G10{l=20, p=99, x=10} G599() G0{x=1}"), 11, 0, 0);
    expect_end(run_lua("G10{l=20, p=4, x=10} G57() G0{x=1}"), 11, 0, 0);
}

TEST(DataSetting, ToolOffsetIsSumOfGeometryAndWear) {
    const std::string set = "G10{l=10, p=3, r=50} G10{l=11, p=3, r=-1} ";
    expect_end(run_lua(set + "G43{h=3} G0{z=0}"), 0, 0, 49);
    expect_end(run_lua(set + "G91() G10{l=11, p=3, r=0.5} G90() G43{h=3} G0{z=0}"), 0, 0, 49.5);
    expect_end(run_lua(set + "G10{l=12, p=3, r=8} G0{x=v[2003], y=v[2403], z=v[2203]+1}"), 50, 8, 0);
    expect_end(run_lua("v[2003]=50.0 v[2203]=1.0 G43{h=3} G0{z=0}"), 0, 0, 51);
}

TEST(DataSetting, ActiveOffsetStaysUntilNextCall) {
    expect_end(run_lua("G10{l=10, p=3, r=50} G43{h=3} G10{l=10, p=3, r=60} G0{z=0}"), 0, 0, 50);
    expect_end(run_lua("G10{l=10, p=3, r=50} G43{h=3} G10{l=10, p=3, r=60} H(3) G0{z=0}"), 0, 0, 60);
}

TEST(DataSetting, RejectsMissingOrInvalidWords) {
    expect_alarm(run_lua("\nG10{p=1, x=1}"), 2, {"[word-missing]", "G10", "L:", "L2", "L10"});
    expect_alarm(run_lua("G10{l=5, p=1, x=1}"), 1, {"L5", "L2, L20"});
    expect_alarm(run_lua("G10{l=2, x=1}"), 1, {"P", "0 to 9", "missing"});
    expect_alarm(run_lua("G10{l=2, p=10, x=1}"), 1, {"0 to 9", "10"});
    expect_alarm(run_lua("G10{l=2, p=1}"), 1, {"axis words"});
    expect_alarm(run_lua("G10{l=2, p=1, q=1}"), 1, {"'q' is not a word of G10"});
    expect_alarm(run_lua("G10{l=10, p=1, x=1}"), 1, {"L10", "by R", "X"});
    expect_alarm(run_lua("G10{l=13, p=1}"), 1, {"[word-missing]", "G10 L13", "R,"});
    expect_alarm(run_lua("F(100.0) G10{l=12, p=1, r=2} G41{d=1} G1{x=9} G10{l=12, p=1, r=3}"), 1,
                 {"G10", "cutter compensation"});
}

TEST(SystemVariables, ReadAndSetZeroPoints) {
    expect_end(run_lua("G10{l=2, p=1, x=10, y=5} G53() G0{x=v[5221], y=v[5222]}"), 10, 5, 0);
    expect_end(run_lua("v[5221]=10.0 v[5202]=4.0 G0{x=1, y=1}"), 11, 5, 0);
    expect_end(run_lua("v[5381]=7.0 G59_3() G0{x=1}"), 8, 0, 0);
}

}  // namespace
}  // namespace gsim::script::ab9_data_test
