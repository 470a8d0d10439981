#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "motion/planner/active_machine.h"
#include "motion/planner/independent_motion.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/pending_targets.h"
#include "motion/segment/event_list.h"
#include "motion/segment/segment.h"
#include "motion/segment/segment_queue.h"

namespace gsim::motion {

/// Target of motion without a target, such as the time in which the controller waits for its program.
inline constexpr rrs::TargetId kNoTarget = -1;

/// End of a step of the clock.
struct MotionStep {
    enum class End { in_motion, target_reached, at_end } end = End::in_motion;
    rrs::JointPos joints;
    double elapsed_s = 0;  ///< Less than requested only if the queue came to its end.
};

/// Planned segments of a planner in the order of time, on a clock that starts at 0. Segments are added at the
/// end of a queue, and leave it at its front, each once, to the sink: all of them with flush(), those that
/// step() passes, and the oldest by itself if the queue is full. The step clock is never before the end of
/// what has left.
class Timeline final : public SegmentOutput {
  public:
    /// Makes an empty timeline. `machine` must outlive it, and so must `sink`, if any, which must not call
    /// the planner while it takes a segment.
    Timeline(const ActiveMachine& machine, SegmentSink* sink);

    Segment& begin(rrs::TargetId id) override;
    void finish() override;
    double time_s() const override { return end_s_; }
    /// Returns the slot as begin() does, but no segment leaves a full queue for it, which grows.
    Segment& begin_reserved(rrs::TargetId id);
    /// Adds a finished segment.
    void append(Segment&& segment);
    /// Makes free slots for so many segments: the oldest segments leave. Error: RRS_QUEUE_FULL without a
    /// sink.
    PlanResult reserve(std::size_t segments);
    /// If on, segments leave the queue only by release_passed(), step() and flush(); it grows.
    void keep_all_segments(bool on) { keeps_all_segments_ = on; }
    /// Passes all segments on; the step clock moves to their end.
    void flush();
    /// Returns to the beginning: the clock at 0, an empty queue, no events, no independent motion.
    void restart();

    /// Returns the queued segments, the oldest first.
    const SegmentQueue& queue() const { return queue_; }
    /// Returns the time up to which all motion has left the queue; infinite if the queue is empty.
    double delivered_until_s() const;
    /// Targets for which a motion model has not yet added the motion that reaches them.
    PendingTargets& pending() { return pending_; }
    const PendingTargets& pending() const { return pending_; }
    /// Notes that the model adds no more motion: its pending targets are reached at the end of the timeline.
    void mark_pending_reached();
    /// Events at an offset from reaching a target. They occur in the steps.
    EventList& events() { return events_; }

    /// Returns the time of step().
    double step_time_s() const { return step_s_; }
    /// Returns the time up to which steps need no more plan, in view of the pending events.
    double known_until_s() const;
    /// Moves the step clock on by a time, at most to the end of the timeline. `end_position`: joint values
    /// after the last segment.
    MotionStep step(double interpolation_s, const rrs::JointPos& end_position);
    /// Returns the target of the segment in which the last step ended.
    rrs::TargetId target_of_last_step() const { return step_target_; }
    /// Moves the step clock on to a time, without a step; it never moves back.
    void advance_step_clock(double time_s);
    /// Removes the queued segments and returns them: the timeline ends at the step clock.
    std::vector<Segment> cut_at_step_clock();
    /// Passes on the segments that end before the step clock.
    void release_passed();

    /// Superimposes the motion of independent joints on all segments that follow.
    void superimpose(IndependentMotion motion) { independent_motion_ = std::move(motion); }
    /// Superimposes nothing on the segments that follow.
    void end_independent_motion() { independent_motion_.reset(); }
    /// True if independent joints move at a time.
    bool has_independent_motion(double time_s) const {
        return independent_motion_ && independent_motion_->end_s() > time_s;
    }
    /// Returns the last motion of independent joints, if any.
    const std::optional<IndependentMotion>& independent_motion() const { return independent_motion_; }

  private:
    void emit_front();

    const ActiveMachine& machine_;
    SegmentSink* sink_;
    SegmentQueue queue_;
    PendingTargets pending_;
    EventList events_;
    std::optional<IndependentMotion> independent_motion_;
    bool keeps_all_segments_ = false;
    double end_s_ = 0;
    double step_s_ = 0;
    rrs::TargetId step_target_ = kNoTarget;  ///< Target of the last step.
};

}  // namespace gsim::motion
