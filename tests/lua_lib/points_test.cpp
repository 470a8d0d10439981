// FIXED and REFERENCE points of the machine data in scripts: whatever is active, the machine's axes are where
// the data say.

#include <cmath>
#include <string>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::points_test {
namespace {

Conditions with_points(Conditions setup = {}) {
    machine::MachineData& data = setup.options.data;
    data.fixed = {{1, {{'X', 254}, {'Y', 50.8}, {'Z', 127}, {'B', 30}, {'C', -45}}},
                  {3, {{'X', 10}, {'Y', 20}, {'Z', 30}}}};
    data.fixed_names = {{1, "CLAMP1"}};
    data.references = {{2, {{'X', 100}, {'Y', 200}, {'Z', 50}}}};
    data.reference_names = {{2, "Clamp1"}};
    return setup;
}

Outcome run_ab9(const std::string& lua) {
    return run_lua(lua, with_points());
}

Outcome run_rs274(const std::string& lua) {
    return run_ngc_lua(lua, with_points(ngc_conditions()));
}

TEST(Points, AreFoundByNameAndNumber) {
    expect_end(run_ab9("G53() G0(fixed \"CLAMP1\")"), 254, 50.8, 127, 30, -45);
    expect_end(run_ab9("G53() G0(fixed(1))"), 254, 50.8, 127, 30, -45);
    expect_end(run_ab9("G53() G0(fixed \"clamp1\")"), 254, 50.8, 127, 30, -45);
    expect_end(run_ab9("G53() G0(reference \"CLAMP1\")"), 100, 200, 50);
    expect_end(run_ab9("G53() G0(reference(2))"), 100, 200, 50);
}

TEST(Points, AxesWithoutValueStay) {
    expect_end(run_ab9("G0{b=15, c=20}\nG53() G0(fixed(3))"), 10, 20, 30, 15, 20);
}

TEST(Points, AreConvertedToActiveUnit) {
    expect_end(run_ab9("G20()\nG53() G0(fixed \"CLAMP1\")"), 254, 50.8, 127, 30, -45);
    expect_end(run_ab9("G20()\nG0{x=fixed(1).x - 1}"), 254 - 25.4, 0, 0);
    expect_end(run_ab9("local place = fixed(1)\nG20()\nG21()\nG53() G0(place)"), 254, 50.8, 127, 30, -45);
    expect_end(run_rs274("G20()\nG53() G0(fixed \"CLAMP1\")"), 254, 50.8, 127, 30, -45);
}

TEST(Points, IgnoreActiveOffsetsAndModes) {
    Conditions setup = with_points(with_tools());
    setup.options.data.offsets["55"] = {{'X', 30}, {'Y', 40}, {'Z', 50}, {'B', 5}};
    const Outcome r = run_lua(
        "G55() G52{x=3, y=4} G43{h=2}\nG68{x=10, y=0, r=30}\nG0{x=20, y=20}\nG91()\nG53() G0(fixed "
        "\"CLAMP1\")",
        setup);
    expect_end(r, 254, 50.8, 127, 30, -45);
    expect_end(run_rs274("G92{x=7, z=8} G43{h=2}\nG53() G0(fixed \"CLAMP1\")"), 254, 50.8, 127, 30, -45);
}

// With G7 a word X is a diameter, and the machine is at half of it.
TEST(Points, WorkInDiameterMode) {
    expect_end(run_rs274("G7()\nG53() G0(fixed \"CLAMP1\")"), 254, 50.8, 127, 30, -45);
    expect_end(run_rs274("G7() G20()\nG53() G0(fixed \"CLAMP1\")"), 254, 50.8, 127, 30, -45);
}

TEST(Points, FeedMoveReachesPointInLine) {
    const Outcome r = run_ab9("F(6000) G53() G1(reference(2))");
    expect_end(r, 100, 200, 50);
    EXPECT_NEAR(r.report.distances.feed_mm, std::sqrt(100.0 * 100 + 200 * 200 + 50 * 50), 1e-9);
}

TEST(Points, ScriptMayChangeItsCopy) {
    expect_end(
        run_ab9("local p = fixed \"CLAMP1\"\np.z, p.b, p.c = nil, nil, nil\np.x = p.x + 1\nG53() G0(p)\n"
                "G53() G0{z=fixed(1).z}"),
        255, 50.8, 127);
}

TEST(Points, UserMCodeUsesPointByNumber) {
    Conditions setup = with_points();
    expect_end(run_lua("M[101] = function(words) G53() G0(fixed(words.p)) end\n"
                       "program(1, function()\nM[101]{p=3}\nM30()\nend)",
                       setup),
               10, 20, 30);
}

// X, Y and Z are in each entry of a file, even if a machine has no such axis.
TEST(Points, IgnoreAxesUnknownToMachine) {
    Conditions setup = with_points();
    setup.options.data.fixed[1]['U'] = 5;
    expect_end(run_lua("G53() G0(fixed(1))", setup), 254, 50.8, 127, 30, -45);
}

TEST(Points, RejectsUnknownPoint) {
    expect_alarm(run_ab9("M0()\nG53() G0(fixed \"VISE\")"), 2,
                 {"fixed \"VISE\": no fixed point has that name; available: 1 (CLAMP1), 3. A line of section "
                  "FIXED of the machine data defines one: number X Y Z NAME=VISE"});
    expect_alarm(
        run_ab9("G53() G0(reference(7))"), 1,
        {"reference(7): no reference point has that number; available: 2 (Clamp1). A line of section "
         "REFERENCE of the machine data defines one: number X Y Z"});
    expect_alarm(run_ab9("fixed(1.5)"), 1, {"fixed(1.5): no fixed point has that number"});
    expect_alarm(run_ab9("fixed \"3\""), 1, {"no fixed point has that name"});
    expect_alarm(run_lua("fixed(1)"), 1, {"fixed(1): no fixed point has that number; none are defined."});
    for (const char* call : {"fixed()", "fixed{}", "fixed(v[1])"})
        expect_alarm(run_ab9(call), 1,
                     {"fixed needs the name or the number of a fixed point: fixed \"CLAMP1\", fixed(1)"});
}

TEST(Points, ListsFirstOfManyPoints) {
    Conditions setup;
    for (int number = 1; number <= 13; ++number) setup.options.data.fixed[number] = {{'X', 0}};
    expect_alarm(run_lua("fixed(99)", setup), 1, {"available: 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 and 3 more."});
}

}  // namespace
}  // namespace gsim::script::points_test
