// Stops of a motion in Planner.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "motion/planner/planner.h"

namespace gsim::motion {

using rrs::Status;

namespace {

/// Returns the acceleration that each joint has both for speeding up and for slowing down.
rrs::JointPos accelerations(const PlannerSetup& setup) {
    rrs::JointPos accelerations(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        accelerations[joint] = setup.joints[static_cast<std::size_t>(joint)].min_acceleration();
    return accelerations;
}

}  // namespace

PlanResult Planner::stop() {
    if (steps_along_conveyor())
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED, "Motion along a conveyor cannot be stopped.");
    if (!has_position_)
        return make_plan_error(Status::RRS_NO_INITIAL_POSITION, "There is no motion to stop yet.");
    if (has_independent_motion(step_s_))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Motion beside axes that go by themselves cannot be stopped.");
    if (stopped_) return {};
    independent_motion_.reset();  // it has ended, and is in what is planned
    keeps_all_segments_ = true;
    plan_to_standstill();
    keeps_all_segments_ = false;
    stopped_ = Stopped{{}, position_};
    if (queue_.empty()) return {};
    std::vector<Segment> planned;
    for (; !queue_.empty(); queue_.pop()) planned.push_back(queue_.front());
    StoppedMotion motion = stop_motion(std::move(planned), step_s_, accelerations(machine_));
    stopped_ = Stopped{std::move(motion.remainder), motion.position};
    end_s_ = step_s_;
    for (std::vector<Segment>* part : {&motion.done, &motion.braking}) {
        for (Segment& segment : *part) {
            queue_.next() = std::move(segment);
            append(queue_.next());
        }
    }
    while (!queue_.empty() && queue_.front().end_s() <= step_s_) emit_front();
    return {};
}

// The plan stays in the queue, complete, until its end is known.
EnqueueResult Planner::enqueue_until(const Move& move, const StopSearch& search) {
    if (tracking_)
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED, "Motion along a conveyor cannot be stopped.");
    flush();
    if (has_independent_motion(end_s_))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Motion beside axes that go by themselves cannot be stopped.");
    keeps_all_segments_ = true;
    EnqueueResult result = enqueue(move);
    end_model();
    keeps_all_segments_ = false;
    std::optional<double> stop_s;
    for (std::size_t i = 0; i < queue_.size() && !stop_s; ++i) stop_s = search(queue_[i]);
    PlanResult stopped;
    if (stop_s) {
        step_s_ = std::max(step_s_, *stop_s);
        stopped = stop();
        if (stopped) cancel();
    }
    flush();
    if (!stopped) return tl::unexpected(std::move(stopped.error()));
    return result;
}

void Planner::resume() {
    std::vector<Segment> remainder = std::move(stopped_->remainder);
    stopped_.reset();
    for (Segment& segment : restart_motion(std::move(remainder), accelerations(machine_))) {
        segment.start_s = end_s_;
        queue_.next() = std::move(segment);
        append(queue_.next());
    }
}

void Planner::cancel() {
    position_ = stopped_->position;
    stopped_.reset();
    if (model_) model_->clear();
    if (path_sink_ != nullptr) path_sink_->forget();
}

}  // namespace gsim::motion
