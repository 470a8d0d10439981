// G7 and G8 of RS274/NGC: diameter words and others. The wanted values are those that LinuxCNC's interpreter
// prints for the same programs.

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::ngc_lathe_test {
namespace {

constexpr double kSamePoint_mm = 1e-9;

/// Returns X of the machine at the end of a program in mm and G7.
double end_x(const std::string& gcode) {
    const Outcome r = run_ngc("G21 F600\nG7\n" + gcode + "\nM2\n");
    EXPECT_TRUE(r.completed()) << gcode << r.message();
    return r.end()[0];
}

std::string reported(const std::string& gcode) {
    return debug_texts(run_ngc("G21 F600\nG7\n" + gcode + "\nM2\n"));
}

TEST(NgcLathe, XWordsAreDiametersFromG7ToG8) {
    const Outcome r = run_ngc("G21 G0 X10 Y4\nG7 X12 Y4\nX30\nG8 X12\nX14\nM2\n");
    ASSERT_EQ(r.moves.size(), 5U) << r.message();
    EXPECT_EQ(r.to(0, 'X'), 10) << "a program begins with G8";
    EXPECT_EQ(r.to(1, 'X'), 6);
    EXPECT_EQ(r.to(1, 'Y'), 4);
    EXPECT_EQ(r.to(2, 'X'), 15);
    EXPECT_EQ(r.to(3, 'X'), 12);
    EXPECT_EQ(r.to(4, 'X'), 14);
}

TEST(NgcLathe, DiameterModeAppliesToIncrementsInchesAndMachineCoordinates) {
    EXPECT_NEAR(end_x("G0 X20\nG91 X6"), 13, kSamePoint_mm);
    EXPECT_NEAR(end_x("G20\nG0 X2"), 25.4, kSamePoint_mm);
    EXPECT_NEAR(end_x("G10 L2 P1 X100\nG53 G0 X8"), 4, kSamePoint_mm);
    EXPECT_NEAR(end_x("G10 L2 P1 X8 Y6 R90\nG0 X20 Y10"), -6, kSamePoint_mm) << "a rotated system";
}

TEST(NgcLathe, ArcCentresAndRadiiStayRadii) {
    const Outcome r = run_ngc(
        "G21 F600 G18 G7\nG0 X20 Z0\nG2 X40 Z-10 I10\nG2 X20 Z0 R10\nG90.1\nG3 X40 Z-10 I10 K-10\nM2\n");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    for (const std::size_t n : {1U, 2U, 3U}) {
        ASSERT_TRUE(r.moves[n].arc) << n;
        EXPECT_NEAR(r.moves[n].arc->radius_mm, 10, kSamePoint_mm) << n;
    }
    EXPECT_NEAR(r.to(1, 'X'), 20, kSamePoint_mm);
    EXPECT_NEAR(r.to(2, 'X'), 10, kSamePoint_mm);
    EXPECT_NEAR(r.moves[3].arc->center[0], 10, kSamePoint_mm) << "I as a point (G90.1)";
}

TEST(NgcLathe, PolarTargetsAreRadii) {
    EXPECT_NEAR(end_x("G0 @10 ^60"), 5, kSamePoint_mm);
    EXPECT_NEAR(end_x("G0 X20\nG91 G0 @4"), 14, kSamePoint_mm);
    EXPECT_NEAR(end_x("G0 X4\nG81 @10 ^60 Z-1 R1\nG80"), 5, kSamePoint_mm);
}

TEST(NgcLathe, OffsetsAreSetByDiameters) {
    EXPECT_EQ(reported("G10 L2 P2 X25.4\n(debug,%f#5241)"), "0.5000\n");
    EXPECT_NEAR(end_x("G0 X20\nG92 X8\nG0 X0"), 6, kSamePoint_mm);
    EXPECT_NEAR(end_x("G52 X10\nG0 X0"), 5, kSamePoint_mm);
    EXPECT_NEAR(end_x("G0 X20\nG10 L20 P1 X8\nG0 X0"), 6, kSamePoint_mm);
    EXPECT_NEAR(end_x("G43.1 X4\nG0 X0"), 2, kSamePoint_mm);
    EXPECT_NEAR(end_x("G10 L1 P1 X6\nG43 H1\nG0 X0"), 3, kSamePoint_mm);
    EXPECT_EQ(reported("G10 L1 P1 R2\nT1 M6\n(debug,%f#5410)"), "0.1575\n") << "4 mm: R is a radius";
}

TEST(NgcLathe, DiameterModeAppliesToHomeProbesThreadsAndSplines) {
    const Outcome home = run_ngc("G21 G7\nG28 X10\nM2\n");
    EXPECT_EQ(home.to(0, 'X'), 5) << "on the way";
    EXPECT_NEAR(end_x("G38.3 X30"), 15, kSamePoint_mm);
    EXPECT_NEAR(end_x("S100 M3\nG33 X40 Z-5 K1"), 20, kSamePoint_mm);
    EXPECT_NEAR(end_x("G5.1 X50 Y10 I4 J4"), 25, kSamePoint_mm);
}

TEST(NgcLathe, CyclePositionAndDepthAreDiameters) {
    EXPECT_NEAR(end_x("G0 Z5\nG81 X20 Z-2 R2\nX8\nG80"), 4, kSamePoint_mm);
    EXPECT_NEAR(end_x("G91 G81 X4 Z-2 R-1 L3\nG80"), 6, kSamePoint_mm);
    const Outcome r = run_ngc("G21 F600\nG7 G19\nG0 X40\nG81 X-10 R12 Y1 Z1\nG80\nM2\n");
    double min = 0, r_level = 0;
    for (std::size_t n = 0; n < r.moves.size(); ++n) {
        if (r.to(n, 'X') < min) min = r.to(n, 'X');
        if (r.moves[n].info.kind == simulation::MoveKind::rapid && n > 0 && r_level == 0 && r.to(n, 'X') < 20)
            r_level = r.to(n, 'X');
    }
    EXPECT_NEAR(min, -5, kSamePoint_mm) << r.message();
    EXPECT_NEAR(r_level, 12, kSamePoint_mm) << "R is no diameter, though it is along X here";
}

TEST(NgcLathe, DepthsOfG76AreDiameters) {
    const Outcome r = run_ngc("G21 G18 S100 M3 G7\nG0 X20 Z5\nG76 P1 Z-10 I-1 J0.5 K2 H0\nM2\n");
    double min = 10;
    for (std::size_t n = 0; n < r.moves.size(); ++n) min = std::min(min, r.to(n, 'X'));
    EXPECT_NEAR(min, 10 - 0.5 - 1, kSamePoint_mm) << "half of I, and half of K";
    ASSERT_GT(r.moves.size(), 2U) << r.message();
    EXPECT_NEAR(r.to(2, 'X'), 10.75 - 0.5 - 1, kSamePoint_mm) << "the first cut is half of J deep";
}

TEST(NgcLathe, ParametersReportRadius) {
    EXPECT_EQ(reported("G0 X20\n(debug,%d#5420 %d#<_x> %d#<_abs_x>)"), "10 10 10\n");
    EXPECT_EQ(reported("G38.3 X30\n(debug,%d#5061)"), "15\n");
    EXPECT_EQ(reported("(debug,%d#<_lathe_diameter_mode> %d#<_lathe_radius_mode>)"), "1 0\n");
    EXPECT_EQ(reported("G8\n(debug,%d#<_lathe_diameter_mode> %d#<_lathe_radius_mode>)"), "0 1\n");
}

TEST(NgcLathe, DiameterModeIsSavedAndRestored) {
    EXPECT_NEAR(end_x("M70\nG8\nM72\nG0 X10"), 5, kSamePoint_mm);
    EXPECT_NEAR(end_x("G8\nM70\nG7\nM72\nG0 X10"), 10, kSamePoint_mm);
    EXPECT_NEAR(end_x("o1 sub\nM73\nG8\no1 endsub\no1 call\nG0 X10"), 5, kSamePoint_mm);
    EXPECT_NEAR(end_x("o1 sub\nG8\no1 endsub\no1 call\nG0 X10"), 10, kSamePoint_mm) << "without M73 it stays";
    EXPECT_NEAR(end_x("#1=8\nG#1\nG0 X10"), 10, kSamePoint_mm) << "by a computed number";
}

TEST(NgcLathe, CompensationFollowsHalvedPath) {
    const Outcome r = run_ngc("G21 F600 G7\nG41.1 D2\nG1 X30 Y10\nX60\nY20\nG40 X80 Y30\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    double max = 0;
    for (std::size_t n = 0; n + 1 < r.moves.size(); ++n) max = std::max(max, r.to(n, 'X'));
    EXPECT_NEAR(max, 29, kSamePoint_mm) << "the tool's radius is 1, left of X30";
}

TEST(NgcLathe, RejectsG7AndG8InOneBlock) {
    EXPECT_NE(diagnostics_text("G7 G8\n", "rs274ngc").find("G7 and G8 are in one modal group"),
              std::string::npos);
}

}  // namespace
}  // namespace gsim::script::ngc_lathe_test
