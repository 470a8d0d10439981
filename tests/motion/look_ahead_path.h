#pragma once

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "motion/lookahead/look_ahead.h"
#include "tests/motion/collected.h"
#include "tests/motion/machines.h"

namespace gsim::motion {

/// Three linear joints; grbl's settings of a router.
inline PlannerSetup router_setup() {
    PlannerSetup setup = three_slide_machine();
    setup.controller.planner = rrs::PlannerKind::look_ahead;
    setup.controller.blocks.look_ahead = 15;
    setup.controller.corners.continuous = setup.controller.corners.exact_path =
        rrs::CornerRule::junction_deviation;
    setup.controller.corners.stop_between_rapid_and_feed = false;
    setup.controller.ramps.centripetal_share = kUnlimited;
    return setup;
}

/// Consecutive lines and arcs, planned by a look-ahead.
class Path {
  public:
    explicit Path(PlannerSetup setup)
        : setup_(std::move(setup)), at_(rrs::JointPos::Zero(setup_.joint_count())) {}

    void line(rrs::JointPos end, double speed_mm_s = 100) {
        PathMove move = begin(speed_mm_s);
        move.end = std::move(end);
        add(move);
    }
    void line(double x, double y, double speed_mm_s = 100) {
        rrs::JointPos end = at_;
        end[0] = x;
        end[1] = y;
        line(end, speed_mm_s);
    }
    void arc(double radius_mm, double from_rad, double sweep_rad, double speed_mm_s, double lift_mm = 0) {
        PathMove move = begin(speed_mm_s);
        move.kind = SegmentKind::circular;
        move.arc.u = {std::cos(from_rad), std::sin(from_rad), 0};
        move.arc.v = {-std::sin(from_rad), std::cos(from_rad), 0};
        move.arc.center = at_.head<3>() - radius_mm * move.arc.u;
        move.arc.radius_mm = move.arc.end_radius_mm = radius_mm;
        move.arc.sweep_rad = sweep_rad;
        move.arc.lift = {0, 0, lift_mm};
        move.end = at_;
        move.end.head<3>() = move.arc.at(sweep_rad);
        add(move);
    }
    void standstill() { model_.plan_to_standstill(); }

    rrs::PathMode mode = rrs::PathMode::continuous;
    bool rapid = false;
    double tolerance_mm = 0;
    const Collected& out() const { return out_; }
    const rrs::JointPos& position() const { return at_; }
    const PlannerSetup& setup() const { return setup_; }
    double exit_speed(std::size_t segment) const { return out_.segments.at(segment).master.end_speed(); }

  private:
    PathMove begin(double speed_mm_s) {
        PathMove move;
        move.target_id = ++id_;
        move.start = at_;
        move.rules.programmed_speed_mm_s = speed_mm_s;
        move.rapid = rapid;
        move.mode = mode;
        move.tolerance_mm = tolerance_mm;
        return move;
    }
    void add(const PathMove& move) {
        const PlanResult planned = model_.add(move);
        ASSERT_TRUE(planned) << planned.error().message;
        at_ = move.end;
    }

    PlannerSetup setup_;
    Collected out_;
    LookAhead model_{setup_, out_};
    rrs::JointPos at_;
    rrs::TargetId id_ = 0;
};

}  // namespace gsim::motion
