#include "motion/planner/planner.h"

#include <optional>
#include <utility>

namespace gsim::motion {

using rrs::Status;

Planner::Planner(PlannerSetup setup, SegmentSink* sink)
    : machine_(std::move(setup)),
      position_(machine_.setup().joint_count()),
      timeline_(machine_, sink),
      tracked_frame_(machine_, timeline_),
      targets_(machine_, tracked_frame_, position_),
      paths_(machine_, tracked_frame_, targets_, position_),
      buffered_moves_(machine_, tracked_frame_, paths_, timeline_, position_),
      motion_stop_(machine_, tracked_frame_, buffered_moves_, timeline_, position_),
      dwells_(machine_, tracked_frame_, motion_stop_, buffered_moves_, timeline_),
      overrides_(machine_, tracked_frame_, timeline_),
      exact_stop_moves_(machine_, tracked_frame_, targets_, paths_, buffered_moves_, overrides_, timeline_,
                        position_),
      tool_moves_(machine_, targets_, paths_, buffered_moves_, dwells_, timeline_, position_),
      conveyors_(machine_, motion_stop_, tracked_frame_, buffered_moves_, timeline_, position_),
      independent_moves_(machine_, tracked_frame_, motion_stop_, targets_, buffered_moves_, dwells_,
                         timeline_, position_) {}

void Planner::restart() {
    timeline_.restart();
    buffered_moves_.drop();
    machine_.restart();
    position_.restart();
    tool_moves_.restart();
    motion_stop_.restart();
    conveyors_.restart();
    tracked_frame_.restart();
    dwells_.restart();
}

PlanResult Planner::set_position(const Goal& goal) {
    rrs::JointPos position;
    if (PlanResult solved = targets_.solve(goal, position); !solved) return solved;
    flush();
    buffered_moves_.clear();
    timeline_.end_independent_motion();
    position_.start_at(position);
    return {};
}

EnqueueResult Planner::enqueue(const Move& move) {
    if (PlanResult checked = check_enqueue(move); !checked) return tl::unexpected(std::move(checked.error()));
    machine_.use(move.move_parameters);
    EnqueueResult enqueue = enqueue_motion(move);
    if (enqueue && move.dwell_s > 0) dwells_.append(move.target_id, move.dwell_s);
    return enqueue;
}

PlanResult Planner::check_enqueue(const Move& move) {
    if (PlanResult ready = motion_stop_.check_ready_for_move(); !ready) return ready;
    if (PlanResult free_slots = timeline_.reserve(move.dwell_s > 0 ? 2 : 1); !free_slots) return free_slots;
    if (move.move_parameters.motion_time_s != 0) {
        if (PlanResult checked = check_motion_time(move.move_parameters.motion_time_s); !checked)
            return checked;
    }
    return independent_moves_.check(move);
}

EnqueueResult Planner::enqueue_motion(const Move& move) {
    if (tool_moves_.accepts(move)) return tool_moves_.enqueue(move);
    if (move.type == rrs::MotionType::joint) return exact_stop_moves_.enqueue_joint_move(move);
    if (buffered_moves_.accepts_moves()) return buffered_moves_.enqueue(move);
    return exact_stop_moves_.enqueue_path_move(move);
}

// The plan stays in the queue, complete, until its end is known.
EnqueueResult Planner::enqueue_until(const Move& move, const StopSearch& search) {
    if (tracked_frame_.is_active())
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED, "Motion along a conveyor cannot be stopped.");
    flush();
    if (timeline_.has_independent_motion(timeline_.time_s()))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Motion cannot be stopped while axes move independently.");
    timeline_.keep_all_segments(true);
    EnqueueResult result = enqueue(move);
    buffered_moves_.plan_to_standstill();
    timeline_.keep_all_segments(false);
    const SegmentQueue& queue = timeline_.queue();
    std::optional<double> stop_s;
    for (std::size_t i = 0; i < queue.size() && !stop_s; ++i) stop_s = search(queue[i]);
    PlanResult stopped;
    if (stop_s) {
        timeline_.advance_step_clock(*stop_s);
        stopped = motion_stop_.stop();
        if (stopped) motion_stop_.cancel();
    }
    flush();
    if (!stopped) return tl::unexpected(std::move(stopped.error()));
    return result;
}

void Planner::flush() {
    if (motion_stop_.is_stopped()) motion_stop_.resume();
    buffered_moves_.plan_to_standstill();
    timeline_.flush();
}

MotionStep Planner::step(double interpolation_s) {
    if (timeline_.step_time_s() + interpolation_s > timeline_.known_until_s())
        buffered_moves_.plan_to_standstill();
    const auto stopped = motion_stop_.position();
    return timeline_.step(interpolation_s, stopped ? *stopped : end_position());
}

rrs::TargetId Planner::current_target() const {
    if (!timeline_.queue().empty()) return timeline_.queue().front().target_id;
    if (const auto remaining = motion_stop_.remaining_target()) return *remaining;
    return timeline_.pending().first().value_or(kNoTarget);
}

/// Returns the joint values after the last segment.
rrs::JointPos Planner::end_position() const {
    if (tracked_frame_.is_active()) return position_.joints() + tracked_frame_.shift_at_end();
    const rrs::JointPos standstill = buffered_moves_.standstill_position();
    const auto& independent = timeline_.independent_motion();
    return independent ? rrs::JointPos(standstill + independent->remaining(timeline_.time_s())) : standstill;
}

}  // namespace gsim::motion
