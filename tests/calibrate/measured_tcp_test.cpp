// Lists of measured TCPs.

#include "calibrate/geometry/measured_tcp.h"

#include <gtest/gtest.h>

#include "calibrate/geometry/pose_selection.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::calibrate::measured_tip_test {
namespace {

machine::Machine mill() {
    return machine::load_machine(tests::source_path("samples/machines/mill-table-table.toml")).value();
}

std::string error_of(const std::string& list) {
    const auto read = read_tcps(list, mill());
    return read ? "none" : read.error().message;
}

TEST(MeasuredTcps, ReadColumnsInAnyOrder) {
    const auto list = read_tcps(
                          "note,z_mm,x_mm,y_mm,C,Y,X,A,sigma_mm\r\n"
                          "first,3,1,2,90,-5,10,-30,0.002\r\n"
                          "\r\n"
                          "second,,,,0,1,2,3,\r\n",
                          mill())
                          .value();
    ASSERT_EQ(list.tcps.size(), 1U);
    EXPECT_EQ(list.tcps[0].readings, (std::vector<double>{10, -5, 450, -30, 90}));  // Z is at home
    EXPECT_EQ(list.tcps[0].tcp.translation(), Eigen::Vector3d(1, 2, 3));
    EXPECT_FALSE(list.tcps[0].has_orientation);
    EXPECT_EQ(list.tcps[0].sigma_mm, 0.002);
    EXPECT_EQ(list.tcps[0].sigma_deg, std::nullopt);
    ASSERT_EQ(list.unmeasured.size(), 1U);
    EXPECT_EQ(list.unmeasured[0].readings, (std::vector<double>{2, 1, 450, 3, 0}));
}

TEST(MeasuredTcps, UseOrientationOfMachineFiles) {
    const auto list =
        read_tcps("x_mm\ty_mm\tz_mm\troll_deg\tpitch_deg\tyaw_deg\n0\t0\t0\t90\t0\t0\n", mill()).value();
    ASSERT_TRUE(list.tcps.at(0).has_orientation);
    EXPECT_TRUE(list.tcps[0].tcp.linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-15));
}

TEST(MeasuredTcps, RejectInvalidLists) {
    EXPECT_EQ(error_of(""), "it is empty");
    EXPECT_EQ(error_of("X,x_mm,y_mm\n"), "line 1: it must name the columns, 'z_mm' among them");
    EXPECT_EQ(error_of("x_mm,y_mm,z_mm,roll_deg\n"),
              "line 1: an orientation requires all of the columns 'roll_deg', 'pitch_deg' and 'yaw_deg'");
    EXPECT_EQ(error_of("X,x_mm,y_mm,z_mm\n\n1,2,x,4\n"), "line 3: 'x' must be a number");
    EXPECT_EQ(error_of("X,x_mm,y_mm,z_mm\n1,2,,4\n"), "line 2: a column is missing or empty");
    EXPECT_EQ(error_of("X,x_mm,y_mm,z_mm\n1,2\n"), "line 2: a column is missing or empty");
    EXPECT_EQ(error_of("X,x_mm,y_mm,z_mm\nnan,2,3,4\n"), "line 2: 'nan' must be a number");
    EXPECT_EQ(error_of("x_mm,y_mm,z_mm,sigma_mm\n1,2,3,0\n"),
              "line 2: '0' must be a standard deviation greater than 0");
}

TEST(MeasuredTcps, PrintedListReadsBackUnchanged) {
    const auto poses = spread_poses(mill(), 1, 5, true);
    const auto empty = read_tcps(print_tcps(poses, mill(), true, false), mill()).value();
    EXPECT_TRUE(empty.tcps.empty());
    ASSERT_EQ(empty.unmeasured.size(), 5U);
    EXPECT_EQ(empty.unmeasured[4].readings, poses[4].readings);
    const auto full = read_tcps(print_tcps(poses, mill(), true, true), mill()).value();
    ASSERT_EQ(full.tcps.size(), 5U);
    EXPECT_EQ(full.tcps[3].readings, poses[3].readings);
    EXPECT_TRUE(full.tcps[3].has_orientation);
}

TEST(MeasuredTcps, ProgramMovesToEachPose) {
    std::vector<MeasuredTcp> poses(1);
    poses[0].readings = {1, 2.5, 3, -4, 5};
    EXPECT_EQ(pose_program(poses, mill()),
              "(poses to measure: clear the machine first, collisions are not checked)\nG21 G90\nG53 G0 "
              "X1.000 Y2.500 Z3.000 A-4.000 C5.000\nM0 (measure 1)\nM2\n");
}

}  // namespace
}  // namespace gsim::calibrate::measured_tip_test
