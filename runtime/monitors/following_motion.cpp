#include "runtime/monitors/following_motion.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace gsim::simulation {

namespace {

constexpr double kTimeConstants = 20;  // exp(-20) is 2e-9
constexpr double kSlopeStep_s = 1e-5;  // over which the speed of the TCP is taken

std::vector<bool> turning_joints(const machine::Machine& machine) {
    std::vector<bool> turns;
    for (const machine::Axis& axis : machine.axes) turns.push_back(axis.kind == machine::AxisKind::rotary);
    return turns;
}

double memory_of(const std::vector<dynamics::ServoLoop>& loops) {
    double memory_s = 0;
    for (const dynamics::ServoLoop& loop : loops)
        memory_s = std::max(memory_s, kTimeConstants / loop.slowest_1_s() + loop.delay_s);
    return memory_s;
}

}  // namespace

bool has_servos(const machine::Machine& machine) {
    return std::any_of(machine.axes.begin(), machine.axes.end(),
                       [](const machine::Axis& axis) { return axis.servo.has_value(); });
}

std::vector<dynamics::ServoLoop> servo_loops(const machine::Machine& machine) {
    std::vector<dynamics::ServoLoop> loops;
    for (const machine::Axis& axis : machine.axes) {
        const machine::Servo servo = axis.servo.value_or(machine::Servo{});
        dynamics::ServoLoop loop{.velocity_share = servo.velocity_feed_forward,
                                 .acceleration_share = servo.acceleration_feed_forward,
                                 .lag_s = servo.velocity_lag_s,
                                 .delay_s = servo.command_delay_s};
        if (servo.position_gain_1_s > 0) {
            loop.gain_1_s = servo.position_gain_1_s;
        } else if (machine.controller.position_gain_1_s > 0) {
            loop.gain_1_s = machine.controller.position_gain_1_s;
        }
        loops.push_back(loop);
    }
    return loops;
}

FollowingMotion::FollowingMotion(const FollowingSetup& setup, double step_s)
    : setup_(setup),
      servos_(servo_loops(setup.machine), turning_joints(setup.machine), step_s),
      tip_(setup.planner, Eigen::Vector3d::Zero()),
      memory_s_(memory_of(servo_loops(setup.machine))) {}

void FollowingMotion::begin(const rrs::JointPos& start) {
    servos_.begin(start);
    tip_.stand_at(start);
    way_.begin(tip_.at(start));
}

void FollowingMotion::enter(const motion::Segment& segment, const MoveInfo& info, const Look& look) {
    servos_.enter(segment, [&](const dynamics::SetPointStep& step) { take(step, look); });
    if (info.tip != tip_number_) change_tip(info.tip);
    tip_.stand_at(segment.start);
    turning_ = tip_.turns(segment.start, segment.end_position()) || segment.orientation;
    lines_begun_ = false;
    if (program_ != nullptr) enter_program(segment);
}

void FollowingMotion::enter_program(const motion::Segment& segment) {
    const bool carried = segment.beside && segment.off_way == motion::OffWay::no;
    if (carried) {
        program_->lose();
        program_settling_ = true;
    } else if (segment.kind != motion::SegmentKind::rest && program_->is_told()) {
        const bool told = program_->drive(segment.target_id, segment.start_s, tip_);
        program_settling_ = program_settling_ || !told;
    }
}

void FollowingMotion::go_to(double t_s, const Look& look) {
    servos_.go_to(t_s, [&](const dynamics::SetPointStep& step) { take(step, look); });
}

void FollowingMotion::leave(const Look& look) {
    servos_.leave([&](const dynamics::SetPointStep& step) { take(step, look); });
}

void FollowingMotion::change_tip(std::uint16_t tip) {
    tip_number_ = tip;
    PartTip changed(setup_.planner, setup_.tips_mm[tip]);
    if (!tip_.ever_turns() && !changed.ever_turns()) return;  // all that counts is distances
    tip_ = std::move(changed);
    settling_ = true;
    if (program_ != nullptr) program_->lose();
    const rrs::JointPos at = servos_.set_points(servos_.now_s());
    tip_.stand_at(at);
    way_.begin(tip_.at(at));
}

/// Returns an end with an exact slope, except for rounding, if the TCP moves straight with the joints.
SetPointWay::End FollowingMotion::end_of(const motion::JointState& state, double duration_s) const {
    const rrs::JointPos ahead = kSlopeStep_s * state.velocity;
    const Eigen::Vector3d change = tip_.at(state.position + ahead) - tip_.at(state.position - ahead);
    return {tip_.at(state.position), duration_s / (2 * kSlopeStep_s) * change};
}

void FollowingMotion::take(const dynamics::SetPointStep& step, const Look& look) {
    const double end_s = step.start_s + step.duration_s;
    if (step.straight && !turning_) {
        const Eigen::Vector3d to = tip_.at(step.to.position);
        if (!step.to.velocity.isZero(0) || !step.from.velocity.isZero(0)) {
            way_.add_line(to, end_s, lines_begun_);
            lines_begun_ = true;
        }
    } else {
        way_.add_curve(end_of(step.from, step.duration_s), end_of(step.to, step.duration_s), end_s);
    }
    way_.forget_before(end_s - memory_s_);
    if (program_ != nullptr) program_->forget_before(end_s - memory_s_);
    if (settling_ || program_settling_) {
        const bool settled = in_bands(errors(end_s));
        settling_ = settling_ && !settled;
        program_settling_ = program_settling_ && !settled;
    }
    if (look) look(step.start_s, end_s);
}

bool FollowingMotion::in_bands(const rrs::JointPos& errors) const {
    const rrs::ControllerRules& controller = setup_.machine.controller;
    for (std::size_t i = 0; i < setup_.machine.axes.size(); ++i) {
        const double error = std::abs(errors[static_cast<Eigen::Index>(i)]);
        const bool linear = setup_.machine.axes[i].kind == machine::AxisKind::linear;
        if (error > (linear ? controller.in_position_mm : controller.in_position_deg * kRadPerDeg))
            return false;
    }
    return true;
}

/// Handles a controller that reports no paths: it drives them as programmed.
std::optional<double> FollowingMotion::program_distance_mm(const FollowingInstant& instant) {
    if (program_settling_) return std::nullopt;
    return program_->is_told() ? program_->distance_mm(instant.tip_mm) : instant.contour_mm;
}

FollowingInstant FollowingMotion::at(double t_s) {
    const rrs::JointPos places = servos_.places(t_s);
    FollowingInstant instant{.t_s = t_s,
                             .errors = servos_.set_points(t_s) - places,
                             .tip_mm = tip_.at(places),
                             .contour_mm = std::nullopt,
                             .program_mm = std::nullopt};
    if (settling_) return instant;
    instant.contour_mm = way_.distance_mm(instant.tip_mm);
    if (program_ != nullptr) instant.program_mm = program_distance_mm(instant);
    return instant;
}

rrs::JointPos FollowingMotion::errors(double t_s) const {
    return servos_.set_points(t_s) - servos_.places(t_s);
}

}  // namespace gsim::simulation
