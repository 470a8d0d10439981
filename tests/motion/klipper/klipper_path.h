#pragma once

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "motion/klipper/klipper_model.h"
#include "tests/motion/collected.h"
#include "tests/motion/machines.h"

namespace gsim::motion {

/// Returns three slides without limits of their own, except Z (20 mm/s, 200 mm/s2), on a path of 100 mm/s and
/// 1000 mm/s2. The square corner velocity is 5 mm/s, the minimum cruise ratio 0.5, chords are 1 mm.
inline PlannerSetup klipper_setup() {
    PlannerSetup setup = three_slide_machine();
    for (JointSetup& joint : setup.joints) joint.max_speed = joint.max_acceleration = kUnlimited;
    setup.joints[2].max_speed = 20;
    setup.joints[2].max_acceleration = 200;
    setup.path = {.max_feed_mm_s = 100, .max_acceleration_mm_s2 = 1000};
    setup.controller.planner = rrs::PlannerKind::klipper;
    setup.controller.klipper.arc_resolution_mm = 1;
    return setup;
}

/// Returns the same with an extruder as its fourth joint: 80 mm/s, 800 mm/s2, and a permitted jump of 1 mm/s.
inline PlannerSetup printer_setup() {
    PlannerSetup setup = klipper_setup();
    setup.joints.push_back({.max_speed = 80, .max_acceleration = 800, .max_speed_step = 1});
    const kinematics::DhLink slide{.kind = rrs::JointKind::prismatic};
    const auto identity = rrs::CartPos::Identity();
    setup.kinematics = std::make_shared<kinematics::ChainKinematics>(
        kinematics::DhChain(identity, std::vector{slide, slide, slide, slide}, identity));
    return setup;
}

/// Consecutive lines and arcs, planned as Klipper does.
class KlipperPath {
  public:
    explicit KlipperPath(PlannerSetup setup = klipper_setup())
        : setup_(std::move(setup)), at_(rrs::JointPos::Zero(setup_.joint_count())) {}

    PlanResult enqueue(const rrs::JointPos& end, double speed_mm_s = 100) {
        PathMove move = begin(speed_mm_s);
        move.end = end;
        const PlanResult planned = model_.add(move);
        if (planned) at_ = end;
        return planned;
    }
    void line(const rrs::JointPos& end, double speed_mm_s = 100) { ASSERT_TRUE(enqueue(end, speed_mm_s)); }
    void line(double x, double y, double z = 0) {
        rrs::JointPos end = at_;
        end.head<3>() = Eigen::Vector3d(x, y, z);
        line(end);
    }
    PlanResult arc(double radius_mm, double sweep_rad) {
        PathMove move = begin(100);
        move.kind = SegmentKind::circular;
        move.arc.u = {1, 0, 0};
        move.arc.v = {0, 1, 0};
        move.arc.center = at_.head<3>() - radius_mm * move.arc.u;
        move.arc.radius_mm = move.arc.end_radius_mm = radius_mm;
        move.arc.sweep_rad = sweep_rad;
        move.end = at_;
        move.end.head<3>() = move.arc.at(sweep_rad);
        const PlanResult planned = model_.add(move);
        if (planned) at_ = move.end;
        return planned;
    }
    void standstill() { model_.plan_to_standstill(); }

    rrs::PathMode mode = rrs::PathMode::continuous;
    bool rapid = false;
    PlannerSetup& setup() { return setup_; }
    const std::deque<Segment>& segments() const { return out_.segments; }
    double time_s() const { return out_.time_s(); }
    const rrs::JointPos& position() const { return at_; }

  private:
    PathMove begin(double speed_mm_s) {
        PathMove move;
        move.target_id = ++id_;
        move.start = at_;
        move.rules.programmed_speed_mm_s = speed_mm_s;
        move.rules.max_path_speed_mm_s = setup_.path.max_feed_mm_s;
        move.rules.path_acceleration_mm_s2 = setup_.path.max_acceleration_mm_s2;
        move.mode = mode;
        move.rapid = rapid;
        return move;
    }

    PlannerSetup setup_;
    Collected out_;
    KlipperModel model_{setup_, out_};
    rrs::JointPos at_;
    rrs::TargetId id_ = 0;
};

}  // namespace gsim::motion
