#include "runtime/simulation/centripetal_watch.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

constexpr double kRounding = 1 + 1e-9;

/// What the weakest of the axes X, Y and Z can do.
double least_acceleration(const machine::Machine& machine) {
    double least = std::numeric_limits<double>::infinity();
    for (const machine::Axis& axis : machine.axes) {
        if (axis.kind == machine::AxisKind::linear) least = std::min(least, axis.max_acceleration);
    }
    return least;
}

}  // namespace

CentripetalWatch::CentripetalWatch(const machine::Machine& machine)
    : limit_mm_s2_(least_acceleration(machine)) {}

void CentripetalWatch::take(const motion::Segment& segment, const MoveInfo& info) {
    if (segment.kind != motion::SegmentKind::circular) return;
    // No way curves more than its smallest circle: most arcs need no closer look.
    const double speed = segment.lead.peak_speed();
    if (speed * speed <= limit_mm_s2_ * std::min(segment.arc.radius_mm, segment.arc.end_radius_mm)) return;
    const double asked = segment.peak_centripetal_mm_s2();
    if (asked <= limit_mm_s2_ * kRounding) return;
    ++count_;
    if (asked <= worst_mm_s2_) return;
    worst_mm_s2_ = asked;
    worst_place_ = info.place;
}

std::optional<std::string> CentripetalWatch::warning(const std::vector<std::string>& files) const {
    if (count_ == 0) return std::nullopt;
    const std::string where = worst_place_.line > 0
                                  ? fmt::format("{}:{}", files[worst_place_.file], worst_place_.line)
                                  : "a script";
    return fmt::format(
        "{} arc{} for more centripetal acceleration than the axes have, at worst {:.0f} mm/s2 of {:.0f} in "
        "{}; the "
        "planner does not slow down for it, so the real machine takes longer",
        count_, count_ == 1 ? " asks" : "s ask", worst_mm_s2_, limit_mm_s2_, where);
}

}  // namespace gsim::simulation
