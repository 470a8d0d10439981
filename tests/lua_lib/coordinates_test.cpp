// Work frames, offsets, units, absolute and incremental dimensions; every expected value is worked out by
// hand.

#include "tests/lua_lib/run.h"

namespace gsim::script::coordinates_test {
namespace {

TEST(Coordinates, AcceptAbsoluteAndIncrementalValues) {
    const Outcome r = run("G90 G0 X100 Y50 Z10\nG91 X20 Y-5\nX1\nG90 Z3\n");
    ASSERT_EQ(r.moves.size(), 4U);
    EXPECT_NEAR(r.to(1, 'X'), 120, 1e-9);
    EXPECT_NEAR(r.to(1, 'Y'), 45, 1e-9);
    expect_end(r, 121, 45, 3);
}

TEST(Coordinates, UnnamedAxesStay) {
    expect_end(run("G0 X10 Y20 Z30 B40 C50\nG1 Y21 F1000\n"), 10, 21, 30, 40, 50);
}

TEST(Coordinates, UvwAreIncrementsInAbsoluteDimensions) {
    expect_end(run("G90 G0 X100 Y100 Z100\nU5 V-6 W7\nX10 V1\n"), 10, 95, 107);
}

TEST(Coordinates, RejectsAxisAndItsIncrementInOneBlock) {
    expect_alarm(run("G0 X10\nX20 U5\n"), 2, {"axis X", "twice"});
}

TEST(Coordinates, UnitsScaleLinearAxesOnly) {
    expect_end(run("G20 G0 X1 Y2 Z.5 B30 C-10\nG91 X1 B1\nG21 Y1\n"), 50.8, 51.8, 12.7, 31, -10);
}

TEST(Coordinates, UnitChangeKeepsPositionAndActiveOffsets) {
    // The offset was given in inches: 1 in = 25.4 mm, and holds its length when millimetres come into force.
    expect_end(run("G20 G52 X1\nG21 G90 G0 X10\n"), 35.4, 0, 0);
}

TEST(Coordinates, UseFramesOfMachineData) {
    Conditions setup;
    auto& offsets = setup.options.data.offsets;
    offsets["54"] = {{'X', 100}, {'Y', 10}};
    offsets["59"] = {{'X', 200}};
    offsets["59.3"] = {{'Z', 30}, {'B', 45}};
    offsets["505"] = {{'X', 300}};
    offsets["599"] = {{'Y', 400}};
    const Outcome r = run("G0 X1 Y1\nG59 X1\nG59.3 X1 Z1 B1\nG505 X1\nG599 X1 Y1\nG20 G54 X1\n", setup);
    EXPECT_NEAR(r.to(0, 'X'), 101, 1e-9);  // G54 is in force from the start
    EXPECT_NEAR(r.to(0, 'Y'), 11, 1e-9);
    EXPECT_NEAR(r.to(1, 'X'), 201, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 1, 1e-9);
    EXPECT_NEAR(r.to(2, 'Z'), 31, 1e-9);
    EXPECT_NEAR(r.to(2, 'B'), 46, 1e-9);
    EXPECT_NEAR(r.to(3, 'X'), 301, 1e-9);
    EXPECT_NEAR(r.to(4, 'Y'), 401, 1e-9);
    EXPECT_NEAR(r.to(5, 'X'), 125.4, 1e-9);  // machine data are in mm, whatever the program's unit
}

TEST(Coordinates, FrameDoesNotShiftIncrements) {
    Conditions setup;
    setup.options.data.offsets["55"] = {{'X', 100}};
    expect_end(run("G0 X10\nG55 G91 X5\n", setup), 15, 0, 0);
}

TEST(Coordinates, G92AssignsCoordinatesToPosition) {
    const Outcome r = run("G0 X100 Y50 B90\nG92 X0 Y10 B0\nX5 Y5 B-10\nG92.1\nX7\n");
    ASSERT_EQ(r.moves.size(), 3U);
    EXPECT_NEAR(r.to(1, 'X'), 105, 1e-9);
    EXPECT_NEAR(r.to(1, 'Y'), 45, 1e-9);
    EXPECT_NEAR(r.to(1, 'B'), 80, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 7, 1e-9);
}

TEST(Coordinates, RepeatedG92AppliesOnce) {
    expect_end(run("G0 X100\nG92 X10\nG92 X10\nX20\n"), 110, 0, 0);
}

TEST(Coordinates, G52MovesZeroPoint) {
    Conditions setup;
    setup.options.data.offsets["54"] = {{'X', 100}};
    const Outcome r = run("G52 X10\nG0 X1\nG52 X20\nX1\nG52 X0\nX1\n", setup);
    EXPECT_NEAR(r.to(0, 'X'), 111, 1e-9);
    EXPECT_NEAR(r.to(1, 'X'), 121, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 101, 1e-9);
}

TEST(Coordinates, G52AndG92AndFramesAdd) {
    Conditions setup;
    setup.options.data.offsets["55"] = {{'X', 100}};
    // At X0 of the machine G92 X-5 sets the program's zero to 5; G52 adds 10, G55 adds 100.
    expect_end(run("G92 X-5\nG52 X10\nG55 G0 X1\n", setup), 116, 0, 0);
}

TEST(Coordinates, G53UsesMachineCoordinatesForOneBlock) {
    Conditions setup;
    setup.options.data.offsets["54"] = {{'X', 100}, {'Y', 100}};
    const Outcome r = run("G0 X1 Y1\nG53 X5\nX6\nG91 G53 G1 Y7 F1000\nY1\n", setup);
    EXPECT_NEAR(r.to(1, 'X'), 5, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 106, 1e-9);
    EXPECT_NEAR(r.to(3, 'Y'), 7, 1e-9);  // absolute, in G91 too
    EXPECT_NEAR(r.to(4, 'Y'), 8, 1e-9);
}

TEST(Coordinates, G53IgnoresPolarMode) {
    Conditions setup;
    setup.options.data.offsets["54"] = {{'X', 100}};
    const Outcome r = run("G16 G0 X10 Y90\nG53 X20 Y30\nX5 Y0\n", setup);
    EXPECT_NEAR(r.to(0, 'X'), 100, 1e-9);
    EXPECT_NEAR(r.to(0, 'Y'), 10, 1e-9);
    EXPECT_NEAR(r.to(1, 'X'), 20, 1e-9);
    EXPECT_NEAR(r.to(1, 'Y'), 30, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 105, 1e-9);
}

TEST(Coordinates, G53EndsWithItsBlockWithoutMove) {
    Conditions setup;
    setup.options.data.offsets["54"] = {{'X', 100}};
    expect_end(run("G53 G0 X#1\nX5\n", setup), 105, 0, 0);  // #1 is vacant: the word is left out
    expect_end(run("G53 G1 F100\nG0 X5\n", setup), 105, 0, 0);
    expect_end(run("G53\nG0 X5\n", setup), 105, 0, 0);
}

TEST(Coordinates, AbsolutePolarTargetsWorkInThreePlanes) {
    const double half = 50, root = 86.60254037844386;  // of a radius of 100 at 30 or 60 degrees
    expect_end(run("G17 G16 G0 X100 Y30\n"), root, half, 0);
    expect_end(run("G18 G16 G0 Z100 X30\n"), half, 0, root);
    expect_end(run("G19 G16 G0 Y100 Z30\n"), 0, root, half);
    expect_end(run("G16 G0 X100 Y30\nY60\n"), half, root, 0);           // the radius is kept
    expect_end(run("G16 G0 X100 Y30\nX200\n"), 2 * root, 2 * half, 0);  // the angle is kept
    expect_end(run("G16 G0 X100 Y30\nG15\nX10\n"), 10, half, 0);        // off again
    expect_end(run("G52 X7 Y9\nG16 G0 X100 Y90 Z5\n"), 7, 109, 5);      // about the zero point in force
    expect_end(run("G20 G16 G1 X10 Y90 F100\n"), 0, 254, 0);            // the radius has the unit
    expect_end(run("G0 X50\nG16 G1 X60 Y0 F99\nY90\nZ3\n"), 0, 60, 3);  // modal, and other axes as ever
}

TEST(Coordinates, IncrementalPolarMoveUsesTurnedDirection) {
    expect_end(run("G0 X500 Y500\nG91 G16 X100 Y90\nX100 Y90\n"), 400, 600, 0);
    expect_end(run("G0 X500 Y500\nG91 G16 X100 Y0\nX100\n"), 700, 500, 0);
    expect_end(run("G18 G0 X500 Z300\nG91 G16 Z100 X90\n"), 600, 0, 300);
    expect_end(run("G19 G0 Y500 Z300\nG91 G16 Y100 Z-90\n"), 0, 500, 200);
}

TEST(Coordinates, PolarArcEndIsRadiusAndAngle) {
    const Outcome r = run("G0 X100\nG16 G3 X100 Y90 I-100 J0 F1000\n");
    expect_end(r, 0, 100, 0);
    EXPECT_NEAR(r.moves.back().length_mm, 100 * 3.14159265358979 / 2, 1e-6);
}

TEST(Coordinates, ReportsAxisValueAndLimitOfTargetOutOfRange) {
    const Outcome r = run("G0 X10\n\nG0 X2000\n");
    expect_alarm(r, 3, {"axis X", "2000", "1828.8", "mm"});
    EXPECT_EQ(r.report.alarm->axis, 'X');
    EXPECT_DOUBLE_EQ(r.report.alarm->value.value(), 2000);
    EXPECT_DOUBLE_EQ(r.report.alarm->limit.value(), 1828.8);
    expect_alarm(run("G1 C-90.5 F100\n"), 1, {"axis C", "-90.5", "-90 deg"});
    expect_alarm(run("G91 G0 Z-1\n"), 1, {"axis Z", "-1", "0 mm"});
}

TEST(Coordinates, RejectsArcPastLimitBetweenItsEnds) {
    // Both ends lie in range, but the lowest point of the arc does not: Y moves to 5 - 10.
    expect_alarm(run("G0 X100 Y5\nG3 X120 I10 J0 F1000\n"), 2, {"axis Y", "limit of 0"});
}

TEST(Coordinates, RejectsAxisUnknownToMachine) {
    expect_alarm(run("G0 A10\n"), 1, {"no axis A"});
    expect_alarm(run("G92 A10\n"), 1, {"no axis A"});
}

}  // namespace
}  // namespace gsim::script::coordinates_test
