#include "motion/moves/tracked_frame.h"

#include <utility>

#include "motion/planner/range_check.h"

namespace gsim::motion {

void TrackedFrame::enter(int conveyor, ConveyorFrame frame) {
    tracking_.emplace(Tracking{conveyor, std::move(frame), machine_.setup()});
}

void TrackedFrame::leave() {
    tracking_.reset();
    left_s_ = timeline_.time_s();
}

void TrackedFrame::restart() {
    tracking_.reset();
    left_s_ = 0;
}

const PlannerSetup& TrackedFrame::setup_for_motion() {
    if (!tracking_) return machine_.setup();
    tracking_->setup = tracking_->frame.remaining_setup(machine_.setup());
    return tracking_->setup;
}

void TrackedFrame::superimpose(Segment& segment) const {
    if (tracking_) tracking_->frame.superimpose(segment);
}

PlanResult TrackedFrame::superimpose_in_range(Segment& segment) const {
    if (!tracking_) return {};
    tracking_->frame.superimpose(segment);
    return check_path_ranges(machine_.setup(), segment);
}

}  // namespace gsim::motion
