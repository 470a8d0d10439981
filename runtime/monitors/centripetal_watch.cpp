#include "runtime/monitors/centripetal_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "machine/model/torque_limit.h"

namespace gsim::simulation {

namespace {

constexpr double kCentripetalRounding = 1 + 1e-9;
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Round a circle an axis speeds up and slows down alike. LinuxCNC has one limit for both.
double both_ways(const machine::Machine& machine, const machine::Axis& axis) {
    if (machine.controller.planner == rrs::PlannerKind::linuxcnc) return axis.max_acceleration;
    return std::min(axis.max_acceleration, axis.deceleration());
}

double weakest_of(const machine::Machine& machine) {
    double least = kUnlimited;
    for (const machine::Axis& axis : machine.axes) {
        if (axis.kind == machine::AxisKind::linear) least = std::min(least, both_ways(machine, axis));
    }
    return least;
}

}  // namespace

CentripetalWatch::CentripetalWatch(const machine::Machine& machine)
    : machine_(machine), weakest_mm_s2_(weakest_of(machine)) {}

/// Returns what all axes of the arc's plane can do, wherever its centre lies.
double CentripetalWatch::limit_in_plane_mm_s2(const motion::Segment& segment) const {
    double limit = kUnlimited;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int joint = segment.position_joints[static_cast<std::size_t>(i)];
        const double share = std::hypot(segment.arc.u[i], segment.arc.v[i]);
        if (joint < 0 || share < motion::kNoShare) continue;
        limit = std::min(limit, both_ways(machine_, machine_.axes[static_cast<std::size_t>(joint)]) / share);
    }
    return limit;
}

void CentripetalWatch::take(const motion::Segment& segment, const MoveInfo& info) {
    if (segment.kind != motion::SegmentKind::circular || machine::is_torque_limited(machine_)) return;
    // No path curves more than its smallest circle: most arcs need no closer check.
    const double speed = segment.lead.peak_speed();
    if (speed * speed <= weakest_mm_s2_ * std::min(segment.arc.radius_mm, segment.arc.end_radius_mm)) return;
    const double asked = segment.peak_centripetal_mm_s2();
    const double limit = limit_in_plane_mm_s2(segment);
    if (asked <= limit * kCentripetalRounding) return;
    ++count_;
    if (asked <= worst_excess_ * limit) return;
    worst_excess_ = asked / limit;
    worst_mm_s2_ = asked;
    worst_limit_mm_s2_ = limit;
    worst_place_ = info.place;
}

std::optional<std::string> CentripetalWatch::warning(const std::vector<std::string>& files) const {
    if (count_ == 0) return std::nullopt;
    const std::string where = worst_place_.line > 0
                                  ? fmt::format("{}:{}", files[worst_place_.file], worst_place_.line)
                                  : "a script";
    return fmt::format(
        "{} arc{} for more centripetal acceleration than the axes have, at worst {:.0f} mm/s2 of {:.0f} in "
        "{}; the planner does not slow down for it, so the real machine takes longer",
        count_, count_ == 1 ? " asks" : "s ask", worst_mm_s2_, worst_limit_mm_s2_, where);
}

}  // namespace gsim::simulation
