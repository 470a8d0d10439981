#include "runtime/monitors/centripetal_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "machine/model/torque_limit.h"

namespace gsim::simulation {

namespace {

constexpr double kCentripetalRounding = 1 + 1e-9;
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Round a circle an axis speeds up and slows down alike. Some planners have one limit for both.
double symmetric_acceleration(const machine::Machine& machine, const machine::Axis& axis) {
    if (!machine.controller.capabilities().has_deceleration_limits) return axis.max_acceleration;
    return std::min(axis.max_acceleration, axis.deceleration());
}

double min_linear_acceleration(const machine::Machine& machine) {
    double min = kUnlimited;
    for (const machine::Axis& axis : machine.axes) {
        if (axis.kind == machine::AxisKind::linear)
            min = std::min(min, symmetric_acceleration(machine, axis));
    }
    return min;
}

}  // namespace

CentripetalMonitor::CentripetalMonitor(const machine::Machine& machine)
    : machine_(machine), min_acceleration_mm_s2_(min_linear_acceleration(machine)) {}

/// Returns what all axes of the arc's plane can do, wherever its centre lies.
double CentripetalMonitor::limit_in_plane_mm_s2(const motion::Segment& segment) const {
    double limit = kUnlimited;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int joint = segment.position_joints[static_cast<std::size_t>(i)];
        const double share = std::hypot(segment.arc.u[i], segment.arc.v[i]);
        if (joint < 0 || share < motion::kMinShare) continue;
        limit = std::min(
            limit, symmetric_acceleration(machine_, machine_.axes[static_cast<std::size_t>(joint)]) / share);
    }
    return limit;
}

void CentripetalMonitor::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    if (segment.kind != motion::SegmentKind::circular || machine::is_torque_limited(machine_)) return;
    // No path curves more than its smallest circle: most arcs need no closer check.
    const double speed = segment.master.peak_speed();
    if (speed * speed <= min_acceleration_mm_s2_ * std::min(segment.arc.radius_mm, segment.arc.end_radius_mm))
        return;
    const double requested = segment.peak_centripetal_mm_s2();
    const double limit = limit_in_plane_mm_s2(segment);
    if (requested <= limit * kCentripetalRounding) return;
    ++count_;
    if (requested <= worst_excess_ * limit) return;
    worst_excess_ = requested / limit;
    worst_mm_s2_ = requested;
    worst_limit_mm_s2_ = limit;
    worst_location_ = info.location;
}

std::optional<std::string> CentripetalMonitor::warning(const std::vector<std::string>& files) const {
    if (count_ == 0) return std::nullopt;
    const std::string where = worst_location_.line > 0
                                  ? fmt::format("{}:{}", files[worst_location_.file], worst_location_.line)
                                  : "a script";
    return fmt::format(
        "{} arc{} for more centripetal acceleration than the axes permit, at worst {:.0f} mm/s2 of {:.0f} in "
        "{}; the planner does not slow down for it, so the real machine takes longer",
        count_, count_ == 1 ? " is programmed" : "s are programmed", worst_mm_s2_, worst_limit_mm_s2_, where);
}

}  // namespace gsim::simulation
