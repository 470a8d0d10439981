#include "runtime/outputs/plot_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/exact_stop/uncoordinated_move.h"

namespace gsim::simulation {

using motion::Segment;
using motion::SegmentKind;

namespace {

constexpr double kArcStep_rad = 2 * kRadPerDeg;
constexpr int kMaxArcSteps = 3600;
constexpr int kJointSteps = 8;  // a joint motion need not be straight
constexpr int kMinSpeedSteps = 8;
constexpr int kMaxSpeedSteps = 512;

int path_steps(const Segment& segment) {
    if (segment.superimposed) return kJointSteps;
    switch (segment.kind) {
        case SegmentKind::circular:
            return static_cast<int>(
                std::clamp(std::ceil(segment.arc.sweep_rad / kArcStep_rad), 2.0, double{kMaxArcSteps}));
        case SegmentKind::joint: return kJointSteps;
        case SegmentKind::linear: return 1;
        case SegmentKind::rest: break;
    }
    return 0;
}

int time_steps(double duration_s, double slot_s) {
    return static_cast<int>(std::clamp(std::ceil(duration_s / slot_s), 1.0, double{kMaxSpeedSteps}));
}

double acceleration_along_path(const Segment& segment, double t_s) {
    const motion::JointState state = segment.at(t_s);
    double along = 0;
    double speed2 = 0;
    for (int joint = 0; joint < state.velocity.size(); ++joint) {
        if (!segment.carries_path(joint)) continue;
        along += state.velocity[joint] * state.acceleration[joint];
        speed2 += state.velocity[joint] * state.velocity[joint];
    }
    return speed2 > 0 ? along / std::sqrt(speed2) : 0;
}

std::array<char, 2> view_axes(Plane plane) {
    switch (plane) {
        case Plane::xy: return {'X', 'Y'};
        case Plane::zx: return {'X', 'Z'};
        case Plane::yz: break;
    }
    return {'Y', 'Z'};
}

PathStyle time_plot_style(const MoveInfo& info) {
    if (info.kind == MoveKind::rapid) return PathStyle::rapid;
    return info.process_on ? PathStyle::jet : PathStyle::feed;
}

PathStyle path_plot_style(const MoveInfo& info) {
    return info.out_of_range != 0 ? PathStyle::out_of_range : time_plot_style(info);
}

}  // namespace

PlotData::PlotData(const machine::Machine& machine, Plane plane) : machine_(machine) {
    const std::size_t last = machine.axes.empty() ? 0 : machine.axes.size() - 1;
    const auto [across, upwards] = view_axes(plane);
    axes_ = {machine.find(across).value_or(0),
             machine.find(upwards).value_or(std::min<std::size_t>(1, last))};
    for (std::size_t i = 0; i < 2 && !machine.axes.empty(); ++i) {
        const machine::Axis& axis = machine.axes[axes_[i]];
        labels_[i] =
            fmt::format("{} ({})", axis.letter, axis.kind == machine::AxisKind::linear ? "mm" : "deg");
    }
}

std::optional<Error> PlotData::find_missing_axes_error(const machine::Machine& machine, Plane plane) {
    const auto [across, upwards] = view_axes(plane);
    if (plane == Plane::xy || (machine.find(across) && machine.find(upwards))) return std::nullopt;
    return fmt::format("--plot-plane {} needs the axes {} and {}, which the machine '{}' does not have",
                       name(plane), across, upwards, machine.name);
}

void PlotData::add_efforts(const dynamics::Dynamics& dynamics) {
    motors_.emplace(dynamics);
    efforts_.resize(machine_.axes.size());
}

void PlotData::add_segment_efforts(const Segment& segment) {
    for (const dynamics::EffortSample& sample : motors_->samples(segment)) {
        for (std::size_t axis = 0; axis < efforts_.size(); ++axis) {
            efforts_[axis].add({.t_s = segment.start_s + sample.t_s,
                                .value = sample.efforts[static_cast<Eigen::Index>(axis)]});
        }
    }
}

void PlotData::add_following(const FollowingSetup& setup) {
    servos_.emplace(setup);
    following_.resize(machine_.axes.size());
}

void PlotData::add_following_at(double t_s) {
    const FollowingInstant instant = servos_->at(t_s);
    for (std::size_t axis = 0; axis < following_.size(); ++axis) {
        const double error = instant.errors[static_cast<Eigen::Index>(axis)];
        const bool linear = machine_.axes[axis].kind == machine::AxisKind::linear;
        following_[axis].add({.t_s = t_s, .value = linear ? error : error * kDegPerRad});
    }
    if (instant.contour_error_mm) contour_.add({.t_s = t_s, .value = *instant.contour_error_mm});
}

void PlotData::begin(const rrs::JointPos& start) {
    at_ = start;
    if (servos_) servos_->begin(start);
    path_.add(project(start), PathStyle::rapid);
}

void PlotData::on_segment(const Segment& segment, const MoveInfo& info) {
    const PathStyle style = time_plot_style(info);
    mark_pierce(segment, info.process_on);
    add_path(segment, path_plot_style(info));
    add_speed(segment, style);
    add_acceleration(segment, style);
    add_feed(segment, info);
    if (motors_) add_segment_efforts(segment);
    if (servos_) {
        const auto add = [this](double, double to_s) { add_following_at(to_s); };
        servos_->enter(segment, info, add);
        servos_->leave(add);
    }
    at_ = segment.end_position();
}

void PlotData::end(double end_s) {
    if (servos_) servos_->go_to(end_s, [this](double, double to_s) { add_following_at(to_s); });
}

void PlotData::mark_pierce(const Segment& segment, bool process_on) {
    const bool spindle = machine_.process && machine_.process->kind == machine::ProcessKind::spindle;
    if (process_on && !jet_ && !spindle && marks_.size() < kMaxPierces)
        marks_.push_back({project(segment.position_at(0)), MarkKind::pierce});
    jet_ = process_on;
}

void PlotData::mark_collision(const rrs::JointPos& joints) {
    marks_.push_back({project(joints), MarkKind::collision});
}

void PlotData::mark_alarm() {
    marks_.push_back({project(at_), MarkKind::alarm});
}

Eigen::Vector2d PlotData::project(const rrs::JointPos& joints) const {
    const auto value = [&](std::size_t axis) {
        return axis < machine_.axes.size()
                   ? axis_value(machine_.axes[axis], joints[static_cast<Eigen::Index>(axis)])
                   : 0.0;
    };
    return {value(axes_[0]), value(axes_[1])};
}

void PlotData::add_path(const Segment& segment, PathStyle style) {
    if (segment.is_uncoordinated()) return add_joint_path(segment, style);
    const int steps = path_steps(segment);
    for (int i = 1; i <= steps; ++i) {
        path_.add(project(segment.position_at(segment.duration_s * i / steps)), style);
    }
}

// Ramps curve the path, and it has a corner at the arrival of a joint.
void PlotData::add_joint_path(const Segment& segment, PathStyle style) {
    double from_s = 0;
    for (const double to_s : motion::uncoordinated_instants_s(segment)) {
        for (int i = 1; i <= kJointSteps; ++i)
            path_.add(project(segment.position_at(from_s + (to_s - from_s) * i / kJointSteps)), style);
        from_s = to_s;
    }
}

void PlotData::add_speed(const Segment& segment, PathStyle style) {
    const int steps = std::max(kMinSpeedSteps, time_steps(segment.duration_s, speed_.width_s()));
    for (int i = 0; i <= steps; ++i) {
        const double t_s = segment.duration_s * i / steps;
        speed_.add({segment.start_s + t_s, segment.path_speed_mm_s(t_s), style});
    }
}

// The acceleration is a straight line in each part of the law, and jumps between them. Points in between keep
// a slot with a jump from hiding later values.
void PlotData::add_acceleration(const Segment& segment, PathStyle style) {
    if (segment.superimposed || segment.is_uncoordinated()) return add_joint_acceleration(segment, style);
    const double length = segment.master.length();
    const double scale = length > 0 ? segment.length_mm / length : 0;
    double start_s = segment.start_s;
    for (const motion::LawSection& section : segment.master.sections()) {
        const int steps = time_steps(section.duration_s, acceleration_.width_s());
        for (int i = 0; i <= steps; ++i) {
            const double t_s = section.duration_s * i / steps;
            acceleration_.add({start_s + t_s, scale * (section.a0 + section.jerk * t_s), style});
        }
        start_s += section.duration_s;
    }
    if (segment.master.sections().empty()) add_standstill(segment, style);
}

void PlotData::add_standstill(const Segment& segment, PathStyle style) {
    const int steps = time_steps(segment.duration_s, acceleration_.width_s());
    for (int i = 0; i <= steps; ++i)
        acceleration_.add({segment.start_s + segment.duration_s * i / steps, 0, style});
}

void PlotData::add_joint_acceleration(const Segment& segment, PathStyle style) {
    const int steps = std::max(kMinSpeedSteps, time_steps(segment.duration_s, acceleration_.width_s()));
    for (int i = 0; i <= steps; ++i) {
        const double t_s = segment.duration_s * i / steps;
        acceleration_.add({segment.start_s + t_s, acceleration_along_path(segment, t_s), style});
    }
}

void PlotData::add_feed(const Segment& segment, const MoveInfo& info) {
    const bool programmed = info.kind != MoveKind::rapid && !info.timed && info.feed_per_min > 0;
    if (!programmed || !(segment.length_mm > 0)) return;
    for (const double t_s : {segment.start_s, segment.end_s()})
        feed_.add({t_s, info.feed_per_min / kSecondsPerMinute});
}

}  // namespace gsim::simulation
