#include "runtime/simulator/simulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/path/axis_space.h"
#include "runtime/monitors/axes_time_watch.h"
#include "runtime/monitors/following_watch.h"
#include "runtime/motion_sources/module_motion.h"
#include "runtime/motion_sources/planner_motion.h"

namespace gsim::simulation {

using text::DiagnosticKind;

using rrs::Status;

namespace {

/// mm or deg: rounding error of rotation and scaling for an axis that does not move.
constexpr double kNoTravel = 1e-9;

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
      centripetal_(machine_),
      zones_(machine_, recorder_),
      setup_(setup_of_machine(machine_)),
      machine_frames_(setup_.kinematics->chain()),
      way_deviation_(setup_),
      motion_(make_motion(std::move(module))),
      space_axes_(space_axes(machine_)),
      position_(static_cast<Eigen::Index>(machine_.axes.size())),
      steps_(machine_),
      process_(machine_) {
    for (std::size_t i = 0; i < machine_.axes.size(); ++i)
        position_[static_cast<Eigen::Index>(i)] = machine_.axes[i].home;
    for (const machine::AxisGroup& group : machine_.groups) group_motions_.push_back(group.motion);
    recorder_.add_output(centripetal_);
    recorder_.add_output(short_brakes_);
    recorder_.add_output(events_);
    recorder_.add_output(violations_);
    if (sampled()) recorder_.add_output(steps_);
    recorder_.add_output(process_);
    recorder_.add_output(way_deviation_);
    follow_servos();
    if (!limits_.stop_at_first) zones_.go_on([this](const ZoneHit& hit) { add_zone_violation(hit); });
    start();
}

std::unique_ptr<MotionSource> Simulator::make_motion(std::optional<rrs::RcsModule> module) {
    if (!module) return std::make_unique<PlannerMotion>(setup_, zones_, ways_);
    return std::make_unique<ModuleMotion>(*std::move(module), setup_, limits_.max_time_s, zones_);
}

void Simulator::start() {
    if (const motion::Planned stands = motion_->start_at(to_joints(position_)); !stands)
        refused(stands.error(), {});
    watch_interval();
    warn_of_jerk();
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

bool Simulator::count_block(const Place& place) {
    if (++blocks_ <= limits_.max_blocks) return has_cpu_time(place);
    --blocks_;
    return stop(DiagnosticKind::run_limit,
                fmt::format("the limit of {} executed blocks is reached (--max-blocks)", limits_.max_blocks),
                place);
}

bool Simulator::rotary_alone(const AxisVector& target) const {
    bool rotary = false;
    for (Eigen::Index i = 0; i < target.size(); ++i) {
        if (std::abs(target[i] - position_[i]) < kNoTravel) continue;
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
motion::Move Simulator::new_move(const MoveInfo& info) const {
    motion::Move move;
    move.target_id = info.target_id;
    if (tip_frame_) move.tip_mm = tip_frame_->tip_mm();
    move.terms = motion_->selections().terms;
    move.terms.rapid = info.kind == MoveKind::rapid;
    const PathPassing passing = exact_stop_once_ ? PathPassing{} : passing_;
    move.terms.path_mode = passing.mode;
    move.terms.tolerance_mm = passing.tolerance_mm;
    move.terms.merge_tolerance_mm = passing.merge_tolerance_mm;
    move.terms.motion_time_s = 0;
    move.terms.obeyed = info.obeyed;
    move.terms.follows_spindle = info.follows_spindle;
    if (ramps_) move.terms.ramps = ramps_;
    if (path_limits_) move.terms.machine = path_limits_;
    return move;
}

bool Simulator::check_feed(const Feed& feed, bool rotary, const Place& place) {
    const motion::Planned checked =
        feed.motion_s ? motion::check_motion_time(*feed.motion_s)
        : rotary      ? motion::check_positive(rotary_speed_rad_s(feed), "orientation speed")
                      : motion::check_positive(feed.linear_mm_min / kSecondsPerMinute, "speed");
    return checked || refused(checked.error(), place);
}

void Simulator::set_time_of(const Feed& feed, bool rotary, motion::Move& move) {
    motion::MoveTerms& terms = move.terms;
    terms.position_speed_mm_s = terms.orientation_speed_rad_s = motion::kUnlimited;
    if (feed.motion_s) {
        terms.motion_time_s = *feed.motion_s;
        return;
    }
    if (rotary) {
        terms.orientation_speed_rad_s = rotary_speed_rad_s(feed);
        return;
    }
    const double speed_mm_s = feed.linear_mm_min / kSecondsPerMinute;
    terms.position_speed_mm_s = speed_mm_s;
    if (speed_mm_s <= machine_.path.max_feed_mm_s || speed_mm_s == warned_feed_mm_s_) return;
    warned_feed_mm_s_ = speed_mm_s;
    warn(
        fmt::format("F of {:.10g} mm/min is above the machine's contour speed limit of {:.10g} "
                    "mm/min, which holds",
                    speed_mm_s * kSecondsPerMinute, machine_.path.max_feed_mm_s * kSecondsPerMinute));
}

MoveInfo Simulator::next_move(MoveKind kind, const Place& place, double feed_per_min) {
    MoveInfo info;
    last_place_ = place;
    info.target_id = next_id_++;
    way_deviation_.expect(info.target_id, place);
    info.kind = kind;
    info.place = place;
    info.feed_per_min = feed_per_min;
    if (kind != MoveKind::dwell && process_with_motion_)
        process_on_ = *std::exchange(process_with_motion_, std::nullopt);
    info.jet_on = process_on_;
    info.switches = process_switches_;
    info.offset = work_offset_;
    info.tip = tip_;
    if (!open_programs_.empty()) info.program = open_programs_.back();
    return info;
}

bool Simulator::finish_move(const motion::Put& put, const Place& place) {
    exact_stop_once_ = false;
    for (const std::string& remark : motion_->take_remarks()) warn(remark);
    if (zones_.hit()) return fail_in_zone();
    if (limits_.stop_at_first && !steps_.found().empty()) return fail_past_range(steps_.found().front());
    if (!put) return refused(put.error(), place);
    add_violations(place);
    if (*put) {
        warn(
            "an inverse time feed (G93) asks for less time than the machine's limits allow; the limits hold");
    }
    if (motion_->time_s() > limits_.max_time_s) return stop_for_time(place);
    return true;
}

/// The program is at a target as soon as the controller has accepted it; `tell` receives the position before.
template <typename Tell>
bool Simulator::finish_move(const motion::Put& put, const AxisVector& target, const Place& place,
                            const Tell& tell) {
    if (put) {
        if (observer_ != nullptr) tell(position_);
        position_ = target;
    }
    return finish_move(put, place);
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
    if (!wait_if_led(move.target, move.place)) return false;
    const bool rotary = rotary_alone(move.target);
    const bool rapid = move.kind == MoveKind::rapid;
    if (!rapid && !check_feed(move.feed, rotary, move.place)) return false;
    const auto joints = joints_of(move.target);
    if (!joints) return fail(DiagnosticKind::unreachable, joints.error(), move.place);
    const motion::RangePass pass(begin_move());
    if (const auto in_range = check_target(*joints); !in_range) return refused(in_range.error(), move.place);
    MoveInfo info = next_move(move.kind, move.place, feed_per_min(move, rotary));
    info.timed = move.feed.motion_s.has_value();
    obey_overrides(info, move.feed);
    recorder_.expect(info);
    motion::Move whole = new_move(info);
    whole.goal.joints = *joints;
    if (!rapid) set_time_of(move.feed, rotary, whole);
    return finish_move(motion_->put(whole), move.target, move.place,
                       [&](const AxisVector& from) { observer_->line(from, move, rotary); });
}

bool Simulator::move(const ArcMove& move) {
    if (!wait_if_led(move.target, move.place)) return false;
    if (!check_feed(move.feed, false, move.place)) return false;
    const auto joints = joints_of(move.target);
    if (!joints) return fail(DiagnosticKind::unreachable, joints.error(), move.place);
    const motion::RangePass pass(begin_move());
    if (const auto in_range = check_target(*joints); !in_range) return refused(in_range.error(), move.place);
    Eigen::Vector3d center = move.center_mm;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int at = space_axes_[static_cast<std::size_t>(i)];
        if (at >= 0) center[i] -= machine_.axes[static_cast<std::size_t>(at)].zero;
    }
    Eigen::Vector3d axis = move.axis();
    if (tip_frame_) {
        center = tip_frame_->point(center);
        axis = tip_frame_->turn_axis(axis);
    }
    MoveInfo info = next_move(move.kind, move.place, feed_per_min(move));
    info.timed = move.feed.motion_s.has_value();
    obey_overrides(info, move.feed);
    info.normal = move.normal;
    info.turns = std::max(1, static_cast<int>(std::ceil(move.sweep_rad / (2 * std::numbers::pi) - 1e-9)));
    recorder_.expect(info);
    motion::Move whole = new_move(info);
    whole.goal.joints = *joints;
    whole.type = rrs::MotionType::circular;
    whole.circle = motion::Circle{center, axis, move.sweep_rad};
    set_time_of(move.feed, false, whole);
    return finish_move(motion_->put(whole), move.target, move.place,
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
    if (!wait_if_led(move.target, move.place)) return false;
    if (!check_feed(move.feed, false, move.place)) return false;
    const auto via = joints_of(move.via);
    const auto target = joints_of(move.target);
    if (!via || !target)
        return fail(DiagnosticKind::unreachable, via ? target.error() : via.error(), move.place);
    const motion::RangePass pass(begin_move());
    if (const auto in_range = check_target(*target); !in_range) return refused(in_range.error(), move.place);
    MoveInfo info = next_move(MoveKind::arc_ccw, move.place, move.feed.linear_mm_min);
    info.timed = move.feed.motion_s.has_value();
    obey_overrides(info, move.feed);
    info.turns = 1;
    set_axis(info, space_point(position_), space_point(move.via), space_point(move.target));
    recorder_.expect(info);
    motion::Move whole = new_move(info);
    whole.goal.joints = *target;
    whole.type = rrs::MotionType::circular;
    whole.via = motion::Goal{*via, std::nullopt};
    set_time_of(move.feed, false, whole);
    return finish_move(motion_->put(whole), move.target, move.place,
                       [&](const AxisVector& from) { observer_->arc(from, move); });
}

motion::Put Simulator::put_rest(const AskedRest& rest) {
    const motion::Planned planned = motion_->put_rest(rest);
    if (!planned) return tl::unexpected(planned.error());
    return {};
}

bool Simulator::dwell(double seconds, const Place& place) {
    const MoveInfo info = next_move(MoveKind::dwell, place, 0);
    recorder_.expect(info);
    return finish_move(put_rest({info.target_id, seconds, {}}), AxisVector(position_), place,
                       [&](const AxisVector& at) { observer_->dwell(at, seconds); });
}

bool Simulator::take_time(double seconds, std::string key, const Place& place) {
    if (!machine_.times.before_first_move && time_s() <= 0) return true;
    const MoveInfo info = next_move(MoveKind::dwell, place, 0);
    recorder_.expect(info);
    words_s_ += seconds;
    return finish_move(put_rest({info.target_id, seconds, std::move(key)}), place);
}

double Simulator::time_s() {
    motion_->come_to_rest(false);
    return motion_->time_s();
}

void Simulator::set_path_mode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
    passing_ = {mode, tolerance_mm, merge_tolerance_mm};
    if (observer_ != nullptr) observer_->path_mode(position_, passing_);
}

void Simulator::warn(const std::string& text) {
    if (warnings_.size() < kMaxWarnings &&
        std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) {
        warnings_.push_back(text);
    }
}

}  // namespace gsim::simulation
