#include "runtime/motion_sources/step_range_monitor.h"

#include <algorithm>
#include <cmath>

namespace gsim::simulation {

namespace {

constexpr double kRangeRounding = 1e-6;  // mm or deg

}  // namespace

void StepRangeMonitor::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    for (std::size_t axis = 0; axis < machine_.axes.size(); ++axis) {
        const double end = segment.end[static_cast<Eigen::Index>(axis)];
        check_axis_range(axis, machine::axis_value(machine_.axes[axis], end), segment.end_s(), info);
    }
}

void StepRangeMonitor::check_axis_range(std::size_t axis, double value, double t_s, const MoveInfo& info) {
    const machine::Axis& range = machine_.axes[axis];
    const double tolerance = kRangeRounding + range.step / 2;
    if (value >= range.min - tolerance && value <= range.max + tolerance) return;
    const auto known = std::find_if(found_.begin(), found_.end(),
                                    [axis](const RangeExcess& step) { return step.axis == axis; });
    if (known == found_.end()) {
        const double limit = value < range.min ? range.min : range.max;
        found_.push_back({.t_s = t_s, .move = info, .axis = axis, .value = value, .limit = limit});
    } else if ((value < known->limit) == (known->value < known->limit) &&
               std::abs(value - known->limit) > std::abs(known->value - known->limit)) {
        known->value = value;
    }
}

}  // namespace gsim::simulation
