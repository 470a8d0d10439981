#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion/linuxcnc/linuxcnc_model.h"
#include "motion/path/circle.h"
#include "tests/motion/machines.h"

namespace gsim::motion {

/// The model between a program and a list of segments.
class LinuxcncRun final : public SegmentOutput {
  public:
    explicit LinuxcncRun(const PlannerSetup& machine, double servo_period_s = 1e-3,
                         std::size_t look_ahead = 50)
        : setup(machine), model(setup, make_rules(machine, servo_period_s, look_ahead), *this) {
        next.start = rrs::JointPos::Zero(setup.joint_count());
        next.rules.programmed_speed_mm_s = 100;
        next.rules.orientation_speed_rad_s = 1;
    }

    Segment& begin(rrs::TargetId id) override {
        slot_ = Segment();
        slot_.target_id = id;
        slot_.position_joints = setup.position_joints;
        slot_.start_s = end_s;
        return slot_;
    }
    void finish() override {
        end_s = slot_.end_s();
        segments.push_back(slot_);
    }

    double time_s() const override { return end_s; }

    /// Plans the move that `next` describes from the end of the last one to `joints`.
    PlanResult go(const rrs::JointPos& joints) {
        next.kind = SegmentKind::linear;
        next.end = joints;
        return add();
    }
    /// X and Y; the other joints stay.
    PlanResult line(double x, double y) {
        rrs::JointPos joints = next.start;
        joints[setup.position_joints[0]] = x;
        joints[setup.position_joints[1]] = y;
        return go(joints);
    }
    /// Plans an arc counter-clockwise in XY by `sweep_rad`, or clockwise if it is negative.
    PlanResult arc(double center_x, double center_y, double sweep_rad) {
        const int x = setup.position_joints[0], y = setup.position_joints[1];
        const int up = setup.position_joints[2];
        const Eigen::Vector3d start(next.start[x], next.start[y], next.start[up]);
        const Eigen::Vector3d center(center_x, center_y, start.z());
        const double c = std::cos(sweep_rad), s = std::sin(sweep_rad);
        const Eigen::Vector3d from = start - center;
        const Eigen::Vector3d end =
            center + Eigen::Vector3d(c * from.x() - s * from.y(), s * from.x() + c * from.y(), 0);
        const Eigen::Vector3d axis(0, 0, sweep_rad > 0 ? 1 : -1);
        EXPECT_TRUE(arc_about(start, end, center, axis, std::abs(sweep_rad), 0.01, next.arc));
        next.kind = SegmentKind::circular;
        next.end = next.start;
        next.end[x] = end.x();
        next.end[y] = end.y();
        return add();
    }
    /// Ends the program and returns its time.
    double end() {
        model.plan_to_standstill();
        return end_s;
    }

    rrs::JointPos position_at(double t_s) const {
        const auto over = std::find_if(segments.begin(), segments.end(),
                                       [&](const Segment& segment) { return segment.end_s() >= t_s; });
        const Segment& segment = over == segments.end() ? segments.back() : *over;
        return segment.position_at(t_s - segment.start_s);
    }

    PlannerSetup setup;
    LinuxcncModel model;
    PathMove next;
    std::vector<Segment> segments;
    double end_s = 0;
    rrs::TargetId last_id = 0;

  private:
    PlanResult add() {
        next.target_id = last_id + 1;
        PlanResult planned = model.add(next);
        if (planned) {
            ++last_id;
            next.start = next.end;
        }
        return planned;
    }
    static rrs::ControllerRules make_rules(const PlannerSetup& machine, double servo_period_s,
                                           std::size_t look_ahead) {
        rrs::ControllerRules rules = machine.controller;
        rules.blocks.look_ahead = look_ahead;
        rules.position_loop.servo_period_s = servo_period_s;
        return rules;
    }

    Segment slot_;
};

/// X, Y, Z 508 mm/s and 490.3 mm/s2, B and C 90 deg/s and 20 deg/s2.
inline PlannerSetup fast_machine() {
    PlannerSetup setup;
    for (int i = 0; i < 3; ++i) setup.joints.push_back({.max_speed = 508, .max_acceleration = 490.3});
    for (int i = 0; i < 2; ++i) {
        setup.joints.push_back(
            {.kind = rrs::JointKind::revolute, .max_speed = kPi / 2, .max_acceleration = kPi / 9});
    }
    setup.position_joints = {0, 1, 2};
    return setup;
}

/// X, Y, Z 100 mm/s and 1000 mm/s2, B 90 deg/s and 200 deg/s2, on LinuxCNC 2.10 with straight ramps.
inline PlannerSetup router_2_10() {
    PlannerSetup setup;
    for (int i = 0; i < 3; ++i) setup.joints.push_back({.max_speed = 100, .max_acceleration = 1000});
    setup.joints.push_back(
        {.kind = rrs::JointKind::revolute, .max_speed = kPi / 2, .max_acceleration = kPi / 0.9});
    setup.position_joints = {0, 1, 2};
    setup.controller.linuxcnc.release = rrs::LinuxcncRelease::v2_10;
    return setup;
}

/// The same with S-curves of this jerk along the path and of X, Y and Z; B has 2000 deg/s3.
inline PlannerSetup router_2_10(double jerk_mm_s3) {
    PlannerSetup setup = router_2_10();
    setup.controller.ramps.limit_jerk = true;
    setup.path.max_jerk_mm_s3 = jerk_mm_s3;
    for (JointSetup& joint : setup.joints) joint.max_jerk = jerk_mm_s3;
    setup.joints[3].max_jerk = 2000 * kPi / 180;
    return setup;
}

/// Expects that each segment starts at the end of the one before.
inline void expect_chain(const LinuxcncRun& run) {
    rrs::JointPos at = rrs::JointPos::Zero(run.setup.joint_count());
    rrs::TargetId id = 0;
    for (const Segment& segment : run.segments) {
        ASSERT_LT((segment.start - at).cwiseAbs().maxCoeff(), 1e-9) << "target " << segment.target_id;
        ASSERT_NEAR(segment.master.duration_s(), segment.duration_s, 1e-9);
        ASSERT_GE(segment.target_id, id);
        id = segment.target_id;
        at = segment.end_position();
    }
    ASSERT_LT((run.next.start - at).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace gsim::motion
