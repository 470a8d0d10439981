#include "motion/moves/dwells.h"

#include <cmath>

#include <fmt/format.h>

#include "motion/exact_stop/line_move.h"
#include "motion/path/master_path.h"

namespace gsim::motion {

PlanResult Dwells::enqueue(rrs::TargetId id, double dwell_s) {
    if (PlanResult ready = motion_stop_.check_ready_for_move(); !ready) return ready;
    if (PlanResult free_slots = timeline_.reserve(1); !free_slots) return free_slots;
    if (!(dwell_s >= 0 && dwell_s <= kMaxDuration_s)) {
        return make_plan_error(
            rrs::Status::RRS_INVALID_PARAMETER,
            fmt::format("A dwell must be from 0 to {} s, not {}.", kMaxDuration_s, dwell_s));
    }
    plan_to_standstill(true);
    append(id, dwell_s);
    return {};
}

void Dwells::append(rrs::TargetId id, double dwell_s) {
    append_exactly(id, counted_s(dwell_s));
}

void Dwells::plan_to_standstill(bool waits) {
    buffered_moves_.plan_to_standstill();
    if (!waits || timeline_.time_s() == last_wait_s_) return;
    const double dwell_s = machine_.setup().controller.standstill.dwell_s;
    if (dwell_s > 0) append_exactly(kNoTarget, dwell_s);
    last_wait_s_ = timeline_.time_s();
}

// LinuxCNC's position loop delays by a period, and smooths over another one.
void Dwells::plan_to_final_standstill() {
    plan_to_standstill();
    const double delay_s = 2 * machine_.setup().controller.position_loop.servo_period_s;
    if (timeline_.time_s() > 0 && delay_s > 0) append_exactly(kNoTarget, delay_s);
}

// A dwell waits for the program's next block, so motion that was queued before it ends at standstill.
void Dwells::append_exactly(rrs::TargetId id, double dwell_s) {
    buffered_moves_.plan_to_standstill();
    Segment& segment = timeline_.begin(id);
    segment.kind = SegmentKind::rest;
    segment.start = segment.end = buffered_moves_.standstill_position();
    plan_standstill(segment, dwell_s);
    tracked_frame_.superimpose(segment);
    timeline_.finish();
}

double Dwells::counted_s(double programmed_s) const {
    const double step_s = machine_.setup().controller.standstill.dwell_step_s;
    if (step_s <= 0) return programmed_s;
    return step_s * std::ceil(programmed_s / step_s * (1 - 1e-12));
}

}  // namespace gsim::motion
