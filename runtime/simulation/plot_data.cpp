#include "runtime/simulation/plot_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace gsim::simulation {

using motion::Segment;
using motion::SegmentKind;

namespace {

constexpr double kArcStep_rad = 2 * std::numbers::pi / 180;
constexpr int kMaxArcSteps = 3600;
constexpr int kJointSteps = 8;  // a joint motion need not be straight
constexpr int kMinSpeedSteps = 8;
constexpr int kMaxSpeedSteps = 512;

int path_steps(const Segment& segment) {
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

PathStyle style_of(const MoveInfo& info) {
    if (info.kind == MoveKind::rapid) return PathStyle::rapid;
    return info.jet_on ? PathStyle::jet : PathStyle::feed;
}

}  // namespace

PlotData::PlotData(const machine::Machine& machine) : machine_(machine) {
    const std::size_t last = machine.axes.empty() ? 0 : machine.axes.size() - 1;
    axes_ = {machine.find('X').value_or(0), machine.find('Y').value_or(std::min<std::size_t>(1, last))};
    for (std::size_t i = 0; i < 2 && !machine.axes.empty(); ++i) {
        const machine::Axis& axis = machine.axes[axes_[i]];
        labels_[i] =
            fmt::format("{} ({})", axis.letter, axis.kind == machine::AxisKind::linear ? "mm" : "deg");
    }
}

void PlotData::begin(const rrs::JointPos& start) {
    path_.add(seen_from_above(start), PathStyle::rapid);
}

void PlotData::take(const Segment& segment, const MoveInfo& info) {
    add_path(segment, style_of(info));
    add_speed(segment, info.jet_on);
}

Eigen::Vector2d PlotData::seen_from_above(const rrs::JointPos& joints) const {
    const auto value = [&](std::size_t axis) {
        return axis < machine_.axes.size()
                   ? axis_value(machine_.axes[axis], joints[static_cast<Eigen::Index>(axis)])
                   : 0.0;
    };
    return {value(axes_[0]), value(axes_[1])};
}

void PlotData::add_path(const Segment& segment, PathStyle style) {
    const int steps = path_steps(segment);
    for (int i = 1; i <= steps; ++i) {
        path_.add(seen_from_above(segment.position_at(segment.duration_s * i / steps)), style);
    }
}

void PlotData::add_speed(const Segment& segment, bool jet_on) {
    const double slots = std::ceil(segment.duration_s / speed_.width_s());
    const int steps = static_cast<int>(std::clamp(slots, double{kMinSpeedSteps}, double{kMaxSpeedSteps}));
    for (int i = 0; i <= steps; ++i) {
        const double t_s = segment.duration_s * i / steps;
        speed_.add({segment.start_s + t_s, segment.path_speed_mm_s(t_s), jet_on});
    }
}

}  // namespace gsim::simulation
