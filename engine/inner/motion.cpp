#include "engine/motion.h"

#include "engine/inner/values.h"
#include "runtime/motion/segment.h"

namespace gsim::engine {

static_assert(kMostAxes == rrs::kMaxJoints);

Segment::Segment(const motion::Segment& exact, const machine::Machine& machine, std::uint32_t in_line,
                 bool on)
    : kind(static_cast<SegmentKind>(exact.kind)),
      jet_on(on),
      line(in_line),
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

}  // namespace gsim::engine
