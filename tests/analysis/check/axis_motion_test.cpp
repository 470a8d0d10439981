// Directions in which axes move the tool: messages, senses, the picture; axes by directions and by tables.

#include "analysis/check/axis_motion.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/check/machine_check.h"
#include "collision/cell/machine_shapes.h"
#include "machine/file/machine_file.h"
#include "motion/kinematics/dh_chain.h"
#include "motion/kinematics/pose.h"
#include "tests/build_files/build_files.h"
#include "tests/support/machine_path.h"

namespace gsim::check::axis_motion_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

machine::Machine read(const std::string& axes) {
    const auto machine = machine::read_machine("[machine]\nname = \"m\"\n" + axes, "m.toml");
    EXPECT_TRUE(machine) << machine.error().message;
    return machine.value_or(machine::Machine{});
}

machine::Machine sample(const std::string& name) {
    return machine::load_machine(tests::source_path("samples/machines/") + name).value();
}

std::string axis(char letter, const std::string& joint) {
    const bool linear = std::string_view("XYZUVW").find(letter) != std::string_view::npos;
    return fmt::format("[[axis]]\nletter = \"{}\"\nkind = \"{}\"\n{}\n", letter, linear ? "linear" : "rotary",
                       joint);
}

std::string directed(char letter, const std::string& direction) {
    return axis(letter, fmt::format("direction = \"{}\"", direction));
}

std::vector<std::string> sentences(const machine::Machine& machine) {
    std::vector<std::string> list;
    for (const AxisMotion& motion : axis_motions(machine)) list.push_back(to_message(motion));
    return list;
}

TEST(AxisMotion, MessagesDescribeDirectionOfMotion) {
    EXPECT_THAT(
        sentences(sample("mill-table-table.toml")),
        ElementsAre(
            "+X moves the workpiece to the left (-x), so the tool moves to the right (+x) relative to it",
            "+Y moves the tool to the back (+y)", "+Z moves the tool up (+z)",
            "+A turns the workpiece clockwise seen from the right (about -x), so the tool moves around it in "
            "the opposite direction",
            "+C turns the workpiece clockwise seen from above (about -z), so the tool moves around it in the "
            "opposite direction"));
    EXPECT_THAT(sentences(read(directed('Y', "-y") + directed('B', "y") +
                               axis('W', "frame = { roll_deg = 0.0, pitch_deg = 45.0 }"))),
                ElementsAre("+Y moves the tool to the front (-y)",
                            "+B turns the tool clockwise seen from the front (about +y)",
                            "+W moves the tool along (0.707 0 0.707)"));
}

// Comparison with moves of the TCP: the direction in a message is that of the TCP.
TEST(AxisMotion, DirectionsMatchTcpMotion) {
    for (const char* name : {"af5.toml", "router3.toml", "mill-head-table.toml", "mill-table-table.toml",
                             "gantry-offset-head.toml", "unlimited.toml", "linuxcnc-gantry.toml"}) {
        const machine::Machine machine = sample(name);
        const auto kinematics = machine::make_kinematics(machine);
        const rrs::JointPos home = machine::home_position(machine);
        const rrs::CartPos before = kinematics->forward(home);
        const std::vector<AxisMotion> motions = axis_motions(machine);
        for (std::size_t i = 0; i < motions.size(); ++i) {
            if (motions[i].is_rotary) continue;
            rrs::JointPos moved = home;
            moved[static_cast<Eigen::Index>(i)] += 1;
            const Eigen::Vector3d displacement =
                kinematics->forward(moved).translation() - before.translation();
            EXPECT_NEAR((displacement - motions[i].direction).norm(), 0, 1e-9)
                << name << ' ' << motions[i].letter;
        }
    }
}

TEST(AxisMotion, ReportsLeftHandedAxesIfXAndYAreSwapped) {
    const machine::Machine machine = read(directed('Y', "x") + directed('X', "y") + directed('Z', "z"));
    const MachineCheck check = check_machine(machine, cell::make_machine_cell(machine).value());
    EXPECT_FALSE(check.is_clean());
    const std::string text = to_text(check);
    EXPECT_THAT(text,
                HasSubstr("error      X Y Z are left-handed: turning +X to +Y advances a right-hand screw "
                          "against +Z, so parts are mirrored; reverse one axis, or exchange two letters\n"));
    EXPECT_THAT(text, HasSubstr("found: 1 left-handed sets of axes\n"));
    EXPECT_THAT(to_json(check), HasSubstr("\"left_handed\": [\n    \"X Y Z are left-handed"));
}

TEST(AxisMotion, FindsLeftHandedPrimaryAndSecondaryAxes) {
    EXPECT_EQ(find_left_handed_axes(
                  axis_motions(read(directed('X', "x") + directed('Y', "y") + directed('Z', "-z"))))
                  .size(),
              1U);
    EXPECT_THAT(find_left_handed_axes(
                    axis_motions(read(directed('U', "x") + directed('V', "z") + directed('W', "y")))),
                ElementsAre(testing::StartsWith("U V W are left-handed")));
    // A table that moves in the direction of its letter carries the work under the tool in the wrong
    // direction.
    EXPECT_EQ(find_left_handed_axes(
                  axis_motions(read(axis('X', "carries = \"work\"\nframe = { pitch_deg = 90.0 }") +
                                    directed('Y', "y") + directed('Z', "z"))))
                  .size(),
              1U);
    EXPECT_THAT(find_left_handed_axes(axis_motions(read(directed('X', "x") + directed('Z', "-z")))),
                IsEmpty());
}

TEST(AxisMotion, SamplesHaveNoLeftHandedAxes) {
    for (const std::filesystem::path& file : tests::machine_files()) {
        const machine::Machine machine = machine::load_machine(file).value();
        EXPECT_THAT(find_left_handed_axes(axis_motions(machine)), IsEmpty()) << file;
    }
}

TEST(AxisMotion, ReportsReversedRotaryAxes) {
    const std::string linear = directed('X', "x") + directed('Y', "y") + directed('Z', "z");
    EXPECT_THAT(
        find_left_handed_rotations(axis_motions(read(linear + directed('A', "-x")))),
        ElementsAre(
            "+A turns against the right-hand rule about +X; ISO 841 requires the opposite direction"));
    EXPECT_THAT(
        find_left_handed_rotations(axis_motions(read(linear + directed('A', "x") + directed('C', "y")))),
        IsEmpty());
}

TEST(AxisMotion, PictureHasArrowForEachAxis) {
    const std::string svg = axes_svg(sample("mill-table-table.toml"));
    for (const char* letter : {"+X", "+Y", "+Z", "+A", "+C"})
        EXPECT_THAT(svg, HasSubstr(fmt::format(">{}</text>", letter)));
    // Z runs straight up from the middle, and X to the right.
    EXPECT_THAT(svg, HasSubstr("d=\"M320.0 220.0L450.0 220.0\""));
    EXPECT_THAT(svg, HasSubstr("d=\"M320.0 220.0L320.0 90.0\""));
    EXPECT_THAT(axes_svg(read(directed('Y', "x") + directed('X', "y") + directed('Z', "z"))),
                HasSubstr("X Y Z are left-handed"));
}

/// A machine by the rows of a table, and the same by directions.
struct Twin {
    std::string rows;
    std::string directions;
};

// The base turns the first Z along X, and its X along Z.
constexpr const char* kBase = "[base]\nroll_deg = 180.0\npitch_deg = -90.0\n";

std::string row(char letter, double theta_deg, double alpha_deg) {
    return axis(letter,
                fmt::format("dh = {{ theta_deg = {:.1f}, alpha_deg = {:.1f} }}", theta_deg, alpha_deg));
}

rrs::JointPos random_joints(Eigen::Index count, std::mt19937& random) {
    rrs::JointPos joints(count);
    for (double& value : joints) value = std::uniform_real_distribution(-3.0, 3.0)(random);
    return joints;
}

TEST(AxisMotion, TablesAndDirectionsGiveSameKinematics) {
    const std::string linear = row('X', 0, 90) + row('Y', 90, 90);
    const Twin af5{kBase + linear + row('Z', 0, 0) + row('C', 0, -90) + row('B', 0, 90),
                   directed('X', "x") + directed('Y', "y") + directed('Z', "z") + directed('C', "z") +
                       directed('B', "y")};
    const Twin trivial{kBase + linear + row('Z', 0, -90) + row('B', 0, 90) + row('C', 0, 0),
                       directed('X', "x") + directed('Y', "y") + directed('Z', "z") + directed('B', "y") +
                           directed('C', "z")};
    std::mt19937 random(7);
    for (const Twin& twin : {af5, trivial}) {
        const auto by_rows = machine::make_kinematics(read(twin.rows));
        const auto by_directions = machine::make_kinematics(read(twin.directions));
        for (int i = 0; i < 100; ++i) {
            const rrs::JointPos joints = random_joints(5, random);
            EXPECT_TRUE(by_rows->forward(joints).isApprox(by_directions->forward(joints), 1e-12)) << i;
        }
    }
}

// To a Denavit-Hartenberg table and back: modules are given the table.
TEST(AxisMotion, DirectionsConvertToTableAndBack) {
    std::mt19937 random(8);
    for (const char* name : {"mill-table-table.toml", "mill-head-table.toml", "linuxcnc-router.toml"}) {
        const machine::Machine machine = sample(name);
        const auto kinematics = machine::make_kinematics(machine);
        const kinematics::DhTable table = kinematics::dh_table(kinematics->chain());
        const kinematics::DhChain chain(table.base, table.rows, table.tool);
        for (int i = 0; i < 100; ++i) {
            const rrs::JointPos joints = random_joints(5, random);
            rrs::JointPos of_rows(5);
            for (std::size_t at = 0; at < table.joints.size(); ++at) {
                const auto joint = static_cast<Eigen::Index>(table.joints[at]);
                of_rows[static_cast<Eigen::Index>(at)] = joints[joint];
            }
            EXPECT_TRUE(chain.forward(of_rows).isApprox(kinematics->forward(joints), 1e-9))
                << name << ' ' << i;
        }
        EXPECT_EQ(machine::read_machine(machine::print_machine(machine), "printed").value(), machine) << name;
    }
}

}  // namespace
}  // namespace gsim::check::axis_motion_test
