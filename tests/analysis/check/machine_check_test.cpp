#include "analysis/check/machine_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "collision/cell/machine_shapes.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::check::machine_check_test {
namespace {

using cell::Verdict;
using testing::HasSubstr;

machine::Machine sample(const std::string& name) {
    return machine::load_machine(tests::source_path("samples/machines/") + name).value();
}

MachineCheck check_of(const machine::Machine& machine) {
    return check_machine(machine, cell::make_machine_cell(machine).value());
}

/// Returns the router with a ball at its TCP and a post next to its box, at a distance.
machine::Machine router_beside_post(double distance_mm) {
    machine::Machine machine = sample("router3.toml");
    machine.shapes = {{"ball", "tool", machine::SphereShape{20}, {}},
                      {"post", "base", machine::BoxShape{10, 10, 10}, {}}};
    machine.shapes[1].frame = {.x_mm = 600 + 10 + 5 + distance_mm};
    return machine;
}

MachineCheck post_check(double distance_mm) {
    machine::Machine machine = router_beside_post(distance_mm);
    return check_of(machine);
}

TEST(JointBoxSearch, ProvesSmallClearanceAndFindsSlightContact) {
    const MachineCheck free = post_check(0.5);
    ASSERT_EQ(free.pair_findings.size(), 1U);
    EXPECT_EQ(free.pair_findings[0].verdict, Verdict::free);
    EXPECT_GE(free.pair_findings[0].nearest_mm, 0.5 - 1e-6);
    EXPECT_TRUE(free.is_clean());
    const MachineCheck touching = post_check(-0.01);
    EXPECT_EQ(touching.pair_findings[0].verdict, Verdict::contact);
    EXPECT_FALSE(touching.is_clean());
}

// If a contact is reported, the bodies do touch, according to the monitor of runs.
TEST(JointBoxSearch, FindingsOfArmMatchDistances) {
    const machine::Machine machine = sample("arm6.toml");
    const cell::Cell cell = cell::make_machine_cell(machine).value();
    const auto kinematics = machine::make_kinematics(machine);
    const MachineCheck check = check_machine(machine, cell);
    EXPECT_GT(check.count(Verdict::contact), 0U);
    EXPECT_GT(check.count(Verdict::free), 0U);
    for (const cell::CandidatePair& pair : cell::candidate_pairs(cell, *kinematics)) {
        for (const cell::PairFinding& pair_finding : check.pair_findings) {
            if (pair_finding.items.first != pair.items.first ||
                pair_finding.items.second != pair.items.second)
                continue;
            const auto links = cell::link_frames(*kinematics, pair_finding.joints);
            const double upper_mm = pair.bodies.distance_at(links, 1e4).upper_mm;
            if (pair_finding.verdict == Verdict::contact) {
                EXPECT_LE(upper_mm, cell::kContactTolerance_mm);
            } else {
                EXPECT_NEAR(upper_mm, pair_finding.nearest_mm, 1e-3);
            }
        }
    }
}

// No random configuration contradicts what is proven.
TEST(JointBoxSearch, FreePairsAreFreeInRandomConfigurations) {
    const machine::Machine machine = sample("mill-table-table.toml");
    const cell::Cell cell = cell::make_machine_cell(machine).value();
    const auto kinematics = machine::make_kinematics(machine);
    const MachineCheck check = check_machine(machine, cell);
    const auto pairs = cell::candidate_pairs(cell, *kinematics);
    ASSERT_EQ(pairs.size(), check.pair_findings.size());
    EXPECT_EQ(check.count(Verdict::undecided), 0U);
    for (int number = 5001; number <= 8000; ++number) {
        const auto links = cell::link_frames(*kinematics, check.box.at(machine::halton_point(number, 5)));
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (check.pair_findings[i].verdict != Verdict::free) continue;
            EXPECT_GT(pairs[i].bodies.distance_at(links, 1).upper_mm, cell::kContactTolerance_mm);
        }
    }
}

TEST(MachineCheck, InversesOfSamplesAreConsistent) {
    for (const char* name :
         {"af5.toml", "gantry-offset-head.toml", "mill-head-table.toml", "arm6.toml", "arm6-cell.toml"}) {
        const machine::Machine machine = sample(name);
        const InverseCheck inverse = check_inverse(machine, machine::joint_box(machine));
        EXPECT_GT(inverse.poses, 0) << name;
        EXPECT_TRUE(inverse.is_consistent()) << name << ": " << inverse.message;
    }
    const machine::Machine none = sample("unlimited.toml");
    EXPECT_EQ(check_inverse(none, machine::joint_box(none)).poses, 0);
}

TEST(MachineCheck, FindsSingularRangesOfArm) {
    const machine::Machine machine = sample("arm6.toml");
    const SingularCheck check = check_singular(machine, machine::joint_box(machine));
    ASSERT_EQ(check.ranges.size(), 2U);
    // The elbow is straight if the forearm's 431.8 and 20.3 mm point along the upper arm.
    const double straight = -std::atan2(431.8, 20.3);
    EXPECT_EQ(check.ranges[0].joint, 2);
    EXPECT_LT(check.ranges[0].low, straight);
    EXPECT_GT(check.ranges[0].high, straight);
    EXPECT_EQ(check.ranges[1].joint, 4);
    EXPECT_NEAR(check.ranges[1].low + check.ranges[1].high, 0, 0.01);
    EXPECT_EQ(check.ranges[1].aligned_joints, (std::vector<int>{3, 5}));
}

TEST(MachineCheck, PrintsTextAndJson) {
    const MachineCheck check = post_check(-0.01);
    const std::string text = to_text(check);
    EXPECT_THAT(text, HasSubstr("machine    3-axis router"));
    EXPECT_THAT(text, HasSubstr("ball and post"));
    EXPECT_THAT(text, HasSubstr("found: 1 pairs can touch"));
    const auto json = text::parse_json<nlohmann::json>(to_json(check));
    EXPECT_EQ(json["clean"], false);
    EXPECT_EQ(json["axes"].size(), 3U);
    EXPECT_EQ(json["pairs"][0]["verdict"], "touch");
    EXPECT_EQ(json["inverse"]["unsolved"], 0);
    EXPECT_EQ(text, to_text(post_check(-0.01)));
}

TEST(MachineCheck, ReportsAxisGroups) {
    machine::Machine machine = sample("arm6-cell.toml");
    machine.shapes.clear();
    machine.ignored.clear();
    const MachineCheck check = check_of(machine);
    EXPECT_THAT(to_text(check), HasSubstr("group      turntable: Z (work), coordinated\n"));
    const auto groups = text::parse_json<nlohmann::json>(to_json(check))["groups"];
    EXPECT_EQ(groups, text::parse_json<nlohmann::json>(R"([
        {"name": "track", "axes": ["X"], "carries": "tool", "motion": "coordinated"},
        {"name": "turntable", "axes": ["Z"], "carries": "work", "motion": "coordinated"}])"));
}

TEST(MachineCheck, NotesUnlimitedRangeAndMissingInverseAndBodies) {
    const MachineCheck check = check_of(sample("unlimited.toml"));
    EXPECT_TRUE(check.is_clean());
    EXPECT_THAT(check.notes, testing::Contains(HasSubstr("axis X has an unlimited range")));
    EXPECT_THAT(check.notes, testing::Contains(HasSubstr("the machine has no inverse")));
    EXPECT_THAT(check.notes, testing::Contains(HasSubstr("the machine has no bodies")));
}

}  // namespace
}  // namespace gsim::check::machine_check_test
