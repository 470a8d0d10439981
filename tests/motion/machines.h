#pragma once

#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "motion/kinematics/gantry.h"
#include "motion/services/default_planner.h"
#include "tests/motion/kinematics/chains.h"

namespace gsim::motion {

using kinematics::joint_pos;
inline constexpr double kPi = std::numbers::pi;

/// The five-axis gantry of the thesis's table, rotary acceleration as calibrated: mm, rad, s.
inline PlannerSetup gantry_setup() {
    const double quarter = kPi / 2;
    PlannerSetup setup;
    setup.joints = {{rrs::JointKind::prismatic, 0, 1828.8, 508, 490.33},
                    {rrs::JointKind::prismatic, 0, 2438.4, 508, 490.33},
                    {rrs::JointKind::prismatic, 0, 609.6, 508, 490.33},
                    {rrs::JointKind::revolute, -2 * kPi, 2 * kPi, quarter, quarter},
                    {rrs::JointKind::revolute, -quarter, quarter, quarter, quarter}};
    setup.path = {.max_feed_mm_s = 254, .max_rapid_mm_s = 508, .max_acceleration_mm_s2 = 490.33};
    setup.position_joints = {0, 1, 2};
    setup.kinematics = kinematics::GantryKinematics::make(kinematics::standard_gantry()).value();
    return setup;
}

/// Three linear joints without ends: 100 mm/s, 1000 mm/s2, and no limits of the path.
inline PlannerSetup three_slide_machine() {
    PlannerSetup setup;
    setup.joints.assign(3, {rrs::JointKind::prismatic, -kUnlimited, kUnlimited, 100, 1000});
    setup.position_joints = {0, 1, 2};
    const kinematics::DhLink slide{.kind = rrs::JointKind::prismatic};
    const auto identity = rrs::CartPos::Identity();
    setup.kinematics = std::make_shared<kinematics::ChainKinematics>(
        kinematics::DhChain(identity, std::vector{slide, slide, slide}, identity));
    return setup;
}

/// Returns seven joints, the position joints neither first nor in order, with random limits: Z W X C Y B V,
/// with W and V as secondary slides.
inline PlannerSetup odd_setup(std::mt19937& random) {
    using kinematics::DhLink;
    std::uniform_real_distribution<double> log_scale(-1.5, 1.5);
    PlannerSetup setup;
    std::vector<DhLink> rows;
    for (const bool revolute : {false, false, false, true, false, true, false}) {
        const auto kind = revolute ? rrs::JointKind::revolute : rrs::JointKind::prismatic;
        setup.joints.push_back({kind, -5000, 5000, (revolute ? 1 : 200) * std::exp(log_scale(random)),
                                (revolute ? 1 : 400) * std::exp(log_scale(random))});
        rows.push_back({.kind = kind});
    }
    setup.path = {.max_feed_mm_s = 200 * std::exp(log_scale(random)),
                  .max_rapid_mm_s = 400 * std::exp(log_scale(random)),
                  .max_acceleration_mm_s2 = 400 * std::exp(log_scale(random))};
    setup.position_joints = {2, 4, 0};
    const auto identity = rrs::CartPos::Identity();
    setup.kinematics =
        std::make_shared<kinematics::ChainKinematics>(kinematics::DhChain(identity, rows, identity));
    return setup;
}

/// Keeps what leaves the planner.
class Collector : public SegmentSink {
  public:
    void on_segment(const Segment& segment) override { segments.push_back(segment); }
    std::vector<Segment> segments;
};

/// A planner that is ready for targets in joint values, and short forms of its services.
class ReadyPlanner {
  public:
    explicit ReadyPlanner(const PlannerSetup& setup, const rrs::JointPos& start)
        : planner(setup, &collector) {
        planner.Initialize();
        planner.SetInitialPosition(rrs::CartPos::Identity(), start, "");
    }

    rrs::Status to(const rrs::JointPos& joints) {
        return planner.SetNextTarget(++id, rrs::TargetParam::end, rrs::CartPos::Identity(), joints, "", 0);
    }
    rrs::Status via(const rrs::JointPos& joints) {
        return planner.SetNextTarget(++id, rrs::TargetParam::via, rrs::CartPos::Identity(), joints, "", 0);
    }
    rrs::Status arc_to(const rrs::JointPos& joints, const Eigen::Vector3d& center,
                       const Eigen::Vector3d& axis, double sweep_rad) {
        return planner.SetNextArcTarget(++id, center, axis, sweep_rad, rrs::CartPos::Identity(), joints);
    }
    /// The segment planned last, made final.
    const Segment& last() {
        planner.flush();
        return collector.segments.back();
    }
    std::string message() {
        std::string text;
        planner.GetMessage(text);
        return text;
    }

    Collector collector;
    DefaultPlanner planner;
    rrs::TargetId id = 0;
};

}  // namespace gsim::motion
