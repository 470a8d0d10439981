#include "runtime/simulator/simulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/path/axis_space.h"
#include "runtime/monitors/axes_time_monitor.h"
#include "runtime/monitors/following_monitor.h"
#include "runtime/motion_sources/module_motion.h"
#include "runtime/motion_sources/planner_motion.h"

namespace gsim::simulation {

using text::DiagnosticKind;

using rrs::Status;

namespace {

/// mm or deg: rounding error of rotation and scaling for an axis that does not move.
constexpr double kMinTravel = 1e-9;

constexpr std::size_t kMaxWarnings = 1'000;

double rotary_speed_rad_s(const Feed& feed) {
    return feed.rotary_deg_min / kSecondsPerMinute * kRadPerDeg;
}

std::array<int, 3> space_axes(const machine::Machine& machine) {
    std::array<int, 3> axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto axis = machine.find(static_cast<char>('X' + i));
        axes[i] = axis ? static_cast<int>(*axis) : -1;
    }
    return axes;
}

}  // namespace

Simulator::Simulator(machine::Machine machine, RunLimits limits, std::optional<rrs::RcsModule> module)
    : machine_(std::move(machine)),
      limits_(limits),
      recorder_(machine_, machine::home_position(machine_)),
      centripetal_monitor_(machine_),
      zones_(machine_, recorder_),
      setup_(make_planner_setup(machine_)),
      machine_frames_(setup_.kinematics->chain()),
      path_deviation_monitor_(setup_),
      motion_(make_motion(std::move(module))),
      space_axes_(space_axes(machine_)),
      position_(static_cast<Eigen::Index>(machine_.axes.size())),
      steps_(machine_),
      process_(machine_) {
    for (std::size_t i = 0; i < machine_.axes.size(); ++i)
        position_[static_cast<Eigen::Index>(i)] = machine_.axes[i].home;
    for (const machine::AxisGroup& group : machine_.groups) group_motions_.push_back(group.motion);
    recorder_.add_output(centripetal_monitor_);
    recorder_.add_output(early_braking_monitor_);
    recorder_.add_output(events_);
    recorder_.add_output(violations_);
    if (is_sampled()) recorder_.add_output(steps_);
    recorder_.add_output(process_);
    recorder_.add_output(path_deviation_monitor_);
    start_following_monitor();
    if (!limits_.stop_at_first)
        zones_.continue_after_hits([this](const ZoneHit& hit) { add_zone_violation(hit); });
    start();
}

std::unique_ptr<MotionSource> Simulator::make_motion(std::optional<rrs::RcsModule> module) {
    if (!module) return std::make_unique<PlannerMotion>(setup_, zones_, path_sinks_);
    return std::make_unique<ModuleMotion>(*std::move(module), setup_, limits_.max_time_s, zones_);
}

void Simulator::start() {
    if (const motion::PlanResult started = motion_->start_at(to_joints(position_)); !started)
        report_plan_error(started.error(), {});
    start_interval_monitor();
    warn_about_jerk();
}

rrs::JointPos Simulator::to_joints(const AxisVector& axes) const {
    rrs::JointPos joints(axes.size());
    for (Eigen::Index i = 0; i < axes.size(); ++i)
        joints[i] = machine::joint_value(machine_.axes[static_cast<std::size_t>(i)], axes[i]);
    return joints;
}

AxisVector Simulator::to_axes(const rrs::JointPos& joints) const {
    AxisVector axes(joints.size());
    for (Eigen::Index i = 0; i < joints.size(); ++i)
        axes[i] = machine::axis_value(machine_.axes[static_cast<std::size_t>(i)], joints[i]);
    return axes;
}

std::uint32_t Simulator::add_file(const std::string& name) {
    const auto index =
        static_cast<std::uint32_t>(std::find(files_.begin(), files_.end(), name) - files_.begin());
    if (index == files_.size()) files_.push_back(name);
    return index;
}

bool Simulator::count_block(const SourceLocation& location) {
    if (++blocks_ <= limits_.max_blocks) return has_cpu_time(location);
    --blocks_;
    return stop(DiagnosticKind::run_limit,
                fmt::format("the limit of {} executed blocks is reached (--max-blocks)", limits_.max_blocks),
                location);
}

bool Simulator::is_rotary_only(const AxisVector& target) const {
    bool rotary = false;
    for (Eigen::Index i = 0; i < target.size(); ++i) {
        if (std::abs(target[i] - position_[i]) < kMinTravel) continue;
        if (machine_.axes[static_cast<std::size_t>(i)].kind == machine::AxisKind::linear) return false;
        rotary = true;
    }
    return rotary;
}

void Simulator::exact_stop_once() {
    exact_stop_once_ = true;
    if (observer_ != nullptr) observer_->exact_stop_once(position_);
}

/// Returns the move with the program's present settings, on top of those that clients of the services have
/// selected.
motion::Move Simulator::make_move(const MoveInfo& info) const {
    motion::Move move;
    move.target_id = info.target_id;
    if (tcp_frame_) move.tcp_mm = tcp_frame_->tcp_mm();
    move.move_parameters = motion_->selections().move_parameters;
    move.move_parameters.rapid = info.kind == MoveKind::rapid;
    const PathModeSettings settings = exact_stop_once_ ? PathModeSettings{} : path_mode_settings_;
    move.move_parameters.path_mode = settings.mode;
    move.move_parameters.tolerance_mm = settings.tolerance_mm;
    move.move_parameters.merge_tolerance_mm = settings.merge_tolerance_mm;
    move.move_parameters.motion_time_s = 0;
    move.move_parameters.enabled_overrides = info.enabled_overrides;
    move.move_parameters.follows_spindle = info.follows_spindle;
    if (ramps_) move.move_parameters.ramps = ramps_;
    if (path_limits_) move.move_parameters.machine = path_limits_;
    return move;
}

bool Simulator::check_feed(const Feed& feed, bool rotary, const SourceLocation& location) {
    const motion::PlanResult checked =
        feed.motion_s ? motion::check_motion_time(*feed.motion_s)
        : rotary      ? motion::check_positive(rotary_speed_rad_s(feed), "orientation speed")
                      : motion::check_positive(feed.linear_mm_min / kSecondsPerMinute, "speed");
    return checked || report_plan_error(checked.error(), location);
}

void Simulator::set_move_time(const Feed& feed, bool rotary, motion::Move& move) {
    motion::MoveParameters& move_parameters = move.move_parameters;
    move_parameters.position_speed_mm_s = move_parameters.orientation_speed_rad_s = motion::kUnlimited;
    if (feed.motion_s) {
        move_parameters.motion_time_s = *feed.motion_s;
        return;
    }
    if (rotary) {
        move_parameters.orientation_speed_rad_s = rotary_speed_rad_s(feed);
        return;
    }
    const double speed_mm_s = feed.linear_mm_min / kSecondsPerMinute;
    move_parameters.position_speed_mm_s = speed_mm_s;
    if (speed_mm_s <= machine_.path.max_feed_mm_s || speed_mm_s == warned_feed_mm_s_) return;
    warned_feed_mm_s_ = speed_mm_s;
    warn(
        fmt::format("F of {:.10g} mm/min is above the machine's contour speed limit of {:.10g} "
                    "mm/min, which holds",
                    speed_mm_s * kSecondsPerMinute, machine_.path.max_feed_mm_s * kSecondsPerMinute));
}

MoveInfo Simulator::make_move_info(MoveKind kind, const SourceLocation& location, double feed_per_min) {
    MoveInfo info;
    last_location_ = location;
    info.target_id = next_id_++;
    path_deviation_monitor_.expect(info.target_id, location);
    info.kind = kind;
    info.location = location;
    info.feed_per_min = feed_per_min;
    if (kind != MoveKind::dwell && process_with_motion_)
        process_on_ = *std::exchange(process_with_motion_, std::nullopt);
    info.process_on = process_on_;
    info.switches = process_switches_;
    info.offset = work_offset_;
    info.tcp = tcp_;
    if (!open_programs_.empty()) info.program = open_programs_.back();
    return info;
}

bool Simulator::finish_move(const motion::EnqueueResult& enqueue, const SourceLocation& location) {
    exact_stop_once_ = false;
    for (const std::string& remark : motion_->drain_remarks()) warn(remark);
    if (zones_.hit()) return fail_in_zone();
    if (limits_.stop_at_first && !steps_.found().empty()) return fail_out_of_range(steps_.found().front());
    if (!enqueue) return report_plan_error(enqueue.error(), location);
    add_violations(location);
    if (*enqueue) {
        warn(
            "an inverse time feed (G93) asks for less time than the machine's limits allow; the limits hold");
    }
    if (motion_->time_s() > limits_.max_time_s) return stop_for_time(location);
    return true;
}

/// The program is at a target as soon as the controller has accepted it; `tell` receives the position before.
template <typename NotifyObserver>
bool Simulator::finish_move(const motion::EnqueueResult& enqueue, const AxisVector& target,
                            const SourceLocation& location, const NotifyObserver& notify_observer) {
    if (enqueue) {
        if (observer_ != nullptr) notify_observer(position_);
        position_ = target;
    }
    return finish_move(enqueue, location);
}

/// Returns the feed for reports; for a move with a time of its own (inverse time feed) its mean.
double Simulator::feed_per_min(const LineMove& move, bool rotary) const {
    if (!move.feed.motion_s) return rotary ? move.feed.rotary_deg_min : move.feed.linear_mm_min;
    const double length = rotary ? (move.target - position_).norm()
                                 : (space_point(move.target) - space_point(position_)).norm();
    return length / *move.feed.motion_s * kSecondsPerMinute;
}

double Simulator::feed_per_min(const ArcMove& move) const {
    if (!move.feed.motion_s) return move.feed.linear_mm_min;
    const double length = move.length_mm(space_point(position_), space_point(move.target));
    return length / *move.feed.motion_s * kSecondsPerMinute;
}

bool Simulator::move(const LineMove& move) {
    if (!wait_if_coordinated(move.target, move.location)) return false;
    const bool rotary = is_rotary_only(move.target);
    const bool rapid = move.kind == MoveKind::rapid;
    if (!rapid && !check_feed(move.feed, rotary, move.location)) return false;
    const auto joints = solve_joints(move.target);
    if (!joints) return fail(DiagnosticKind::unreachable, joints.error(), move.location);
    const motion::OvertravelPermit pass(begin_move());
    if (const auto in_range = check_target(*joints); !in_range)
        return report_plan_error(in_range.error(), move.location);
    MoveInfo info = make_move_info(move.kind, move.location, feed_per_min(move, rotary));
    info.timed = move.feed.motion_s.has_value();
    apply_override_rules(info, move.feed);
    recorder_.expect(info);
    motion::Move full_move = make_move(info);
    full_move.goal.joints = *joints;
    if (!rapid) set_move_time(move.feed, rotary, full_move);
    return finish_move(motion_->enqueue(full_move), move.target, move.location,
                       [&](const AxisVector& from) { observer_->line(from, move, rotary); });
}

bool Simulator::move(const ArcMove& move) {
    if (!wait_if_coordinated(move.target, move.location)) return false;
    if (!check_feed(move.feed, false, move.location)) return false;
    const auto joints = solve_joints(move.target);
    if (!joints) return fail(DiagnosticKind::unreachable, joints.error(), move.location);
    const motion::OvertravelPermit pass(begin_move());
    if (const auto in_range = check_target(*joints); !in_range)
        return report_plan_error(in_range.error(), move.location);
    Eigen::Vector3d center = move.center_mm;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int at = space_axes_[static_cast<std::size_t>(i)];
        if (at >= 0) center[i] -= machine_.axes[static_cast<std::size_t>(at)].zero;
    }
    Eigen::Vector3d axis = move.axis();
    if (tcp_frame_) {
        center = tcp_frame_->point(center);
        axis = tcp_frame_->turn_axis(axis);
    }
    MoveInfo info = make_move_info(move.kind, move.location, feed_per_min(move));
    info.timed = move.feed.motion_s.has_value();
    apply_override_rules(info, move.feed);
    info.normal = move.normal;
    info.turns = std::max(1, static_cast<int>(std::ceil(move.sweep_rad / (2 * std::numbers::pi) - 1e-9)));
    recorder_.expect(info);
    motion::Move full_move = make_move(info);
    full_move.goal.joints = *joints;
    full_move.type = rrs::MotionType::circular;
    full_move.circle = motion::Circle{center, axis, move.sweep_rad};
    set_move_time(move.feed, false, full_move);
    return finish_move(motion_->enqueue(full_move), move.target, move.location,
                       [&](const AxisVector& from) { observer_->arc(from, move); });
}

/// Returns X, Y and Z of axis values; 0 for an axis that the machine does not have.
Eigen::Vector3d Simulator::space_point(const AxisVector& axes) const {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int axis = space_axes_[static_cast<std::size_t>(i)];
        if (axis >= 0) point[i] = axes[axis];
    }
    return point;
}

bool Simulator::move(const ViaMove& move) {
    if (!wait_if_coordinated(move.target, move.location)) return false;
    if (!check_feed(move.feed, false, move.location)) return false;
    const auto via = solve_joints(move.via);
    const auto target = solve_joints(move.target);
    if (!via || !target)
        return fail(DiagnosticKind::unreachable, via ? target.error() : via.error(), move.location);
    const motion::OvertravelPermit pass(begin_move());
    if (const auto in_range = check_target(*target); !in_range)
        return report_plan_error(in_range.error(), move.location);
    MoveInfo info = make_move_info(MoveKind::arc_ccw, move.location, move.feed.linear_mm_min);
    info.timed = move.feed.motion_s.has_value();
    apply_override_rules(info, move.feed);
    info.turns = 1;
    set_axis(info, space_point(position_), space_point(move.via), space_point(move.target));
    recorder_.expect(info);
    motion::Move full_move = make_move(info);
    full_move.goal.joints = *target;
    full_move.type = rrs::MotionType::circular;
    full_move.via = motion::Goal{*via, std::nullopt};
    set_move_time(move.feed, false, full_move);
    return finish_move(motion_->enqueue(full_move), move.target, move.location,
                       [&](const AxisVector& from) { observer_->arc(from, move); });
}

motion::EnqueueResult Simulator::enqueue_dwell(const DwellRequest& request) {
    const motion::PlanResult planned = motion_->enqueue_dwell(request);
    if (!planned) return tl::unexpected(planned.error());
    return {};
}

bool Simulator::dwell(double seconds, const SourceLocation& location) {
    const MoveInfo info = make_move_info(MoveKind::dwell, location, 0);
    recorder_.expect(info);
    return finish_move(enqueue_dwell({info.target_id, seconds, {}}), AxisVector(position_), location,
                       [&](const AxisVector& at) { observer_->dwell(at, seconds); });
}

bool Simulator::dwell_for_word(double seconds, std::string key, const SourceLocation& location) {
    if (!machine_.times.before_first_move && time_s() <= 0) return true;
    const MoveInfo info = make_move_info(MoveKind::dwell, location, 0);
    recorder_.expect(info);
    words_s_ += seconds;
    return finish_move(enqueue_dwell({info.target_id, seconds, std::move(key)}), location);
}

double Simulator::time_s() {
    motion_->plan_to_standstill(false);
    return motion_->time_s();
}

void Simulator::set_path_mode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
    path_mode_settings_ = {mode, tolerance_mm, merge_tolerance_mm};
    if (observer_ != nullptr) observer_->path_mode(position_, path_mode_settings_);
}

void Simulator::warn(const std::string& text) {
    if (warnings_.size() < kMaxWarnings &&
        std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) {
        warnings_.push_back(text);
    }
}

}  // namespace gsim::simulation
