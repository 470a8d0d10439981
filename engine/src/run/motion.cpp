#include "engine/motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/src/conversions.h"
#include "machine/model/machine.h"
#include "motion/dynamics/law_ends.h"
#include "motion/segment/segment.h"

namespace gsim::engine {

static_assert(kMaxAxes == rrs::kMaxJoints);

Segment::Segment(const motion::Segment& exact, const machine::Machine& machine, std::uint32_t line_number,
                 bool on)
    : kind(static_cast<SegmentKind>(exact.kind)),
      process_on(on),
      line(line_number),
      start_s(exact.start_s),
      duration_s(exact.duration_s),
      length_mm(exact.length_mm),
      start(axis_values(machine, exact.start)),
      end(axis_values(machine, exact.end_position())),
      exact_(&exact),
      machine_(&machine) {}

AxisValues Segment::axes_at(double t_s) const {
    return axis_values(*machine_, exact_->position_at(t_s));
}

double Segment::speed_mm_s(double t_s) const {
    return exact_->path_speed_mm_s(t_s);
}

namespace {

double speed_share(const motion::Segment& segment, const machine::Machine& machine, double t_s) {
    const rrs::JointPos velocity = segment.at(t_s).velocity;
    double share = 0;
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        const double speed = std::abs(machine::axis_value(axis, velocity[static_cast<Eigen::Index>(i)]) -
                                      machine::axis_value(axis, 0));
        if (std::isfinite(axis.max_speed)) share = std::max(share, speed / axis.max_speed);
    }
    return share;
}

}  // namespace

double Segment::peak_axis_speed_share() const {
    constexpr int kSteps = 8;
    if (kind == SegmentKind::rest) return 0;
    std::vector<double> ends_s{0};
    dynamics::add_law_ends(*exact_, ends_s);
    ends_s.push_back(duration_s);
    std::sort(ends_s.begin(), ends_s.end());
    double share = speed_share(*exact_, *machine_, 0);
    for (std::size_t part = 1; part < ends_s.size(); ++part) {
        const double part_duration_s = ends_s[part] - ends_s[part - 1];
        for (int step = 1; part_duration_s > 0 && step <= kSteps; ++step)
            share = std::max(
                share, speed_share(*exact_, *machine_, ends_s[part - 1] + part_duration_s * step / kSteps));
    }
    return share;
}

}  // namespace gsim::engine
