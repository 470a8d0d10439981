#include "runtime/monitors/following_motion.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace gsim::simulation {

namespace {

constexpr double kSettlingTimeConstants = 20;  // exp(-20) is 2e-9
constexpr double kDifferenceStep_s = 1e-5;     // over which the speed of the TCP is taken

std::vector<bool> rotary_joint_flags(const machine::Machine& machine) {
    std::vector<bool> turns;
    for (const machine::Axis& axis : machine.axes) turns.push_back(axis.kind == machine::AxisKind::rotary);
    return turns;
}

double settling_time(const std::vector<dynamics::ServoLoop>& loops) {
    double history_s = 0;
    for (const dynamics::ServoLoop& loop : loops)
        history_s = std::max(history_s, kSettlingTimeConstants / loop.slowest_1_s() + loop.delay_s);
    return history_s;
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
        } else if (machine.controller.position_loop.gain_1_s > 0) {
            loop.gain_1_s = machine.controller.position_loop.gain_1_s;
        }
        loops.push_back(loop);
    }
    return loops;
}

FollowingMotion::FollowingMotion(const FollowingSetup& setup, double step_s)
    : setup_(setup),
      servos_(servo_loops(setup.machine), rotary_joint_flags(setup.machine), step_s),
      tcp_(setup.planner, Eigen::Vector3d::Zero()),
      settling_time_s_(settling_time(servo_loops(setup.machine))) {}

void FollowingMotion::begin(const rrs::JointPos& start) {
    servos_.begin(start);
    tcp_.set_position(start);
    set_point_path_.begin(tcp_.at(start));
}

void FollowingMotion::enter(const motion::Segment& segment, const MoveInfo& info,
                            const StepHandler& on_step) {
    servos_.enter(segment, [&](const dynamics::SetPointStep& step) { on_set_point_step(step, on_step); });
    if (info.tcp != tcp_index_) change_tcp(info.tcp);
    tcp_.set_position(segment.start);
    tcp_rotates_ = tcp_.turns(segment.start, segment.end_position()) || segment.orientation;
    extends_line_ = false;
    if (program_ != nullptr) enter_programmed_path(segment);
}

void FollowingMotion::enter_programmed_path(const motion::Segment& segment) {
    const bool is_on_conveyor = segment.superimposed && segment.path_deviation == motion::PathDeviation::no;
    if (is_on_conveyor) {
        program_->mark_lost();
        program_settling_ = true;
    } else if (segment.kind != motion::SegmentKind::rest && program_->is_reported()) {
        const bool is_tracked = program_->drive(segment.target_id, segment.start_s, tcp_);
        program_settling_ = program_settling_ || !is_tracked;
    }
}

void FollowingMotion::go_to(double t_s, const StepHandler& on_step) {
    servos_.go_to(t_s, [&](const dynamics::SetPointStep& step) { on_set_point_step(step, on_step); });
}

void FollowingMotion::leave(const StepHandler& on_step) {
    servos_.leave([&](const dynamics::SetPointStep& step) { on_set_point_step(step, on_step); });
}

void FollowingMotion::change_tcp(std::uint16_t tcp) {
    tcp_index_ = tcp;
    WorkpieceTcp changed(setup_.planner, setup_.tcp_offsets_mm[tcp]);
    if (!tcp_.can_rotate() && !changed.can_rotate()) return;  // all that counts is distances
    tcp_ = std::move(changed);
    settling_ = true;
    if (program_ != nullptr) program_->mark_lost();
    const rrs::JointPos at = servos_.history().set_points(servos_.now_s());
    tcp_.set_position(at);
    set_point_path_.begin(tcp_.at(at));
}

/// Returns an end with an exact slope, except for rounding, if the TCP moves straight with the joints.
SetPointPath::EndPoint FollowingMotion::end_state(const motion::JointState& state, double duration_s) const {
    const rrs::JointPos ahead = kDifferenceStep_s * state.velocity;
    const Eigen::Vector3d change = tcp_.at(state.position + ahead) - tcp_.at(state.position - ahead);
    return {tcp_.at(state.position), duration_s / (2 * kDifferenceStep_s) * change};
}

void FollowingMotion::on_set_point_step(const dynamics::SetPointStep& step, const StepHandler& on_step) {
    const double end_s = step.start_s + step.duration_s;
    if (step.straight && !tcp_rotates_) {
        const Eigen::Vector3d to = tcp_.at(step.to.position);
        if (!step.to.velocity.isZero(0) || !step.from.velocity.isZero(0)) {
            set_point_path_.add_line(to, end_s, extends_line_);
            extends_line_ = true;
        }
    } else {
        set_point_path_.add_curve(end_state(step.from, step.duration_s), end_state(step.to, step.duration_s),
                                  end_s);
    }
    set_point_path_.discard_before(end_s - settling_time_s_);
    if (program_ != nullptr) program_->discard_before(end_s - settling_time_s_);
    if (settling_ || program_settling_) {
        const bool is_settled = is_in_position(errors(end_s));
        settling_ = settling_ && !is_settled;
        program_settling_ = program_settling_ && !is_settled;
    }
    if (on_step) on_step(step.start_s, end_s);
}

bool FollowingMotion::is_in_position(const rrs::JointPos& errors) const {
    const rrs::PositionLoopRules& loop = setup_.machine.controller.position_loop;
    for (std::size_t i = 0; i < setup_.machine.axes.size(); ++i) {
        const double error = std::abs(errors[static_cast<Eigen::Index>(i)]);
        const bool linear = setup_.machine.axes[i].kind == machine::AxisKind::linear;
        if (error > (linear ? loop.in_position_mm : loop.in_position_deg * kRadPerDeg)) return false;
    }
    return true;
}

/// Handles a controller that reports no paths: it drives them as programmed.
std::optional<double> FollowingMotion::program_distance_mm(const FollowingInstant& instant) {
    if (program_settling_) return std::nullopt;
    return program_->is_reported() ? program_->distance_mm(instant.tcp_mm) : instant.contour_error_mm;
}

FollowingInstant FollowingMotion::at(double t_s) {
    const rrs::JointPos positions = servos_.history().positions(t_s);
    FollowingInstant instant{.t_s = t_s,
                             .errors = servos_.history().set_points(t_s) - positions,
                             .tcp_mm = tcp_.at(positions),
                             .contour_error_mm = std::nullopt,
                             .program_deviation_mm = std::nullopt};
    if (settling_) return instant;
    instant.contour_error_mm = set_point_path_.distance_mm(instant.tcp_mm);
    if (program_ != nullptr) instant.program_deviation_mm = program_distance_mm(instant);
    return instant;
}

rrs::JointPos FollowingMotion::errors(double t_s) const {
    return servos_.history().set_points(t_s) - servos_.history().positions(t_s);
}

}  // namespace gsim::simulation
