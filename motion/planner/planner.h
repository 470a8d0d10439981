#pragma once

#include <Eigen/Core>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "motion/path/axis_space.h"
#include "motion/path/conveyor_frame.h"
#include "motion/path/path_sink.h"
#include "motion/path/tool_path.h"
#include "motion/planner/independent_motion.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/move.h"
#include "motion/planner/pending_targets.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/planner/stop.h"
#include "motion/segment/event_list.h"
#include "motion/segment/segment.h"
#include "motion/segment/segment_queue.h"

namespace gsim::motion {

/// Target of motion without a target, such as the time in which the controller waits for its program.
inline constexpr rrs::TargetId kNoTarget = -1;

/// Function that checks a segment and returns the instant on the planner's clock at which its motion is to be
/// stopped, if any.
using StopSearch = std::function<std::optional<double>(const Segment&)>;

/// Note that an enqueued move takes longer than requested: the machine can do it no faster.
struct TimeRaised {
    double actual_s = 0;
    double requested_s = 0;
    bool at_least = false;  ///< True if the time is only known after the following moves.
};

/// Returns the same as a result: RRS_MOTION_TIME_RAISED and a message.
PlanError time_raised(const TimeRaised& raised_time);

/// Checks that a programmed value is above 0; `what` is its name. Error: RRS_INVALID_PARAMETER.
PlanResult check_positive(double value, std::string_view what);
/// Checks that a move may be requested to take a time. Error: RRS_INVALID_PARAMETER.
PlanResult check_motion_time(double motion_s);

/// Result of an enqueued move; an error leaves everything unchanged.
using EnqueueResult = tl::expected<std::optional<TimeRaised>, PlanError>;

/// Planner for machines without a planner of their manufacturer (thesis 5.3.2): moves, each a complete value,
/// become segments. Joint, linear and circular motion stops at each target. Linear and circular motion is
/// made by a controller's MotionModel if the setup names a controller that does not stop there. A clock
/// starts at 0.
///
/// Each move (and each dwell) becomes segments at the end of a queue: one, or with a model as many as it
/// makes of it. Segments leave the queue in order, each exactly once, to the sink: all of them with flush(),
/// those that step() passes, and the oldest by itself if the queue is full. A full queue is RRS_QUEUE_FULL
/// without a sink. The step clock is never before the end of what has left. A move to the current position
/// becomes a segment of no duration without a model, so that target ids arrive complete and in order. A model
/// may keep moves pending until it knows those that follow: joint motion, dwells, flush(), stop() and step()
/// past the end of the plan make it stop.
///
/// Mixed moves from standstill to standstill: the path of the position joints is the master, by the
/// programmed speed. Each other joint follows by its own fastest ramps. The slowest of all sets the time, and
/// the others run slower to take as long. The rotary joints of a via point are not checked. Each joint of a
/// rapid moves uncoordinated (uncoordinated_move.h) if rapids are not interpolated, even with TCP control or
/// a pose: these are for feeds.
class Planner {
  public:
    /// Makes a planner. `sink`, if any, must outlive the planner, and must not call it while it takes a
    /// segment. Throws std::invalid_argument with the message of setup.validate() if that finds an error.
    explicit Planner(PlannerSetup setup, SegmentSink* sink = nullptr);
    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;

    /// Sets the operator's overrides, on this planner's clock. Call before the first move.
    void set_overrides(std::shared_ptr<const OverrideSchedule> overrides) {
        machine_.overrides = setup_.overrides = std::move(overrides);
    }
    /// Sets the source of the joint accelerations for each move. Call before the first move.
    void set_move_limits(std::shared_ptr<const MoveLimits> limits) {
        machine_.move_limits = setup_.move_limits = std::move(limits);
    }
    /// Reports the paths of the model's moves to `ways` from now on, which must outlive the planner.
    void set_path_sink(PathSink& ways) { path_sink_ = &ways; }
    /// Returns to the beginning: the clock at 0, an empty queue, no position, the machine unchanged.
    void restart();
    /// Activates what these terms change of the machine, as a move with them does.
    void use(const MoveParameters& move_parameters);

    /// Returns the machine as the planner was given it, or (setup()) with the changes of the last terms.
    const PlannerSetup& machine() const { return machine_; }
    const PlannerSetup& setup() const { return setup_; }
    /// True if its moves may end without a stop.
    bool can_pass_targets() const { return model_ != nullptr; }

    /// Returns RRS_MODE_NOT_SUPPORTED if the machine does not have three slides that compensate for the TCP
    /// motion of its rotary joints.
    PlanResult check_tcp_control() const;
    /// Returns RRS_MODE_NOT_SUPPORTED if the controller has its own ramps.
    PlanResult check_ramps() const;
    /// Computes the joint values of a position; for a pose those nearest to the last target. Errors:
    /// RRS_INVALID_PARAMETER, RRS_NO_SOLUTION, RRS_JOINT_LIMIT.
    PlanResult solve(const Goal& goal, rrs::JointPos& joints) const;
    /// Checks that they are values for the joints of this machine, independent of their ranges. Error:
    /// RRS_INVALID_PARAMETER.
    PlanResult check_joints(const rrs::JointPos& joints) const;
    /// Sets the position of the robot, at standstill, before the next move; queued motion is finished first.
    PlanResult set_position(const Goal& goal);
    /// Checks that a move may be enqueued now. Errors: RRS_NO_INITIAL_POSITION; RRS_QUEUE_FULL while a motion
    /// is stopped.
    PlanResult check_ready_for_move() const;
    /// Enqueues a move. Errors: RRS_NO_INITIAL_POSITION, RRS_QUEUE_FULL, and those of solve() and the
    /// planning.
    EnqueueResult enqueue(const Move& move);
    /// Enqueues a move that an event may end. Calls flush(), plans the move to its end at standstill and
    /// passes it to `search`, segment by segment. The motion is stopped as by stop() at the instant that
    /// `search` returns, and its remainder is dropped; then flush() follows.
    EnqueueResult enqueue_until(const Move& move, const StopSearch& search);
    /// Enqueues a dwell from 0 to kMaxDuration_s.
    PlanResult enqueue_dwell(rrs::TargetId id, double dwell_s);

    /// Moves joints independently to their values in `end` (IndependentMotion), from the end of the plan on,
    /// which is at standstill. Moves that follow do not wait for them. Errors: RRS_MODE_NOT_SUPPORTED while
    /// other joints move so, along a conveyor and if corners are rounded; RRS_INVALID_PARAMETER,
    /// RRS_JOINT_LIMIT.
    PlanResult enqueue_independent(const rrs::JointPos& end);
    /// Returns the time at which the independent joints stop; 0 if none has moved.
    double independent_end_s() const { return independent_motion_ ? independent_motion_->end_s() : 0; }

    /// Makes all queued segments final and passes them on; the step clock moves to their end. Continues a
    /// stopped motion.
    void flush();
    /// Plans a model's pending moves to end at standstill. The controller then waits for its program if
    /// `waits`, which takes its dwell_s if anything has moved since it did so last.
    void plan_to_standstill(bool waits = false);
    /// Calls plan_to_standstill() at the end of a program. Its last positions pass through the controller's
    /// position loop.
    void plan_to_final_standstill();

    /// Returns the time up to which all motion has left the queue; infinite if the queue is empty.
    double delivered_until_s() const;
    /// Returns the end of the last planned segment; a model's pending moves do not count.
    double time_s() const { return end_s_; }
    /// Returns the time of step().
    double step_time_s() const { return step_s_; }
    bool has_position() const { return has_position_; }
    /// Returns the joint values at the last target; while a conveyor is tracked, in its frame.
    const rrs::JointPos& position() const { return position_; }

    /// End of a step.
    struct Step {
        enum class StepEnd { in_motion, target_reached, at_end } end = StepEnd::in_motion;
        rrs::JointPos joints;
        double elapsed_s = 0;  ///< Less than requested only if the queue came to its end.
    };
    /// Moves on by a time; a position must be set.
    Step step(double interpolation_s);
    /// Returns the target of the motion or dwell in which the last step ended.
    rrs::TargetId target_of_last_step() const { return step_target_; }
    /// Returns the target to which the motion from there on leads; kNoTarget if none exists.
    rrs::TargetId current_target() const;

    /// Brakes from the instant of step(), each joint within its limits (stop.h), over as many segments as it
    /// takes; step() then continues to the stop. Moves are rejected until resume() or cancel()
    /// (RRS_QUEUE_FULL). Errors: RRS_MODE_NOT_SUPPORTED along a conveyor, RRS_NO_INITIAL_POSITION.
    PlanResult stop();
    bool is_stopped() const { return stopped_.has_value(); }
    /// Continues a stopped motion.
    void resume();
    /// Drops the remainder of a stopped motion, and what is queued after it.
    void cancel();

    /// Defines an event at an offset from reaching a target. Events occur in the steps.
    void define_event(int event_id, rrs::TargetId target, EventOffset offset) {
        events_.define(event_id, target, offset);
    }
    bool cancel_event(int event_id) { return events_.cancel(event_id); }
    const std::vector<EventList::TriggeredEvent>& events_of_last_step() const {
        return events_.triggered_events();
    }

    /// Does the same as the service of this name; `direction` is in the machine's own frame. Errors:
    /// RRS_INVALID_PARAMETER, RRS_MODE_NOT_SUPPORTED, RRS_JOINT_LIMIT.
    PlanResult define_conveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s);
    PlanResult set_conveyor_position(int conveyor, double position_mm);
    /// Selects tracking. `base` is the turn of the machine in the world relative to its kinematics.
    PlanResult select_tracking(int conveyor, bool on, const Eigen::Matrix3d& base);
    bool is_tracking() const { return tracking_.has_value(); }
    /// True if the step clock is at a time at which a conveyor is tracked, or was.
    bool steps_along_conveyor() const { return tracking_ || step_s_ < tracking_end_s_; }

  private:
    // Output of the model's segments: the end of the queue.
    class Output final : public SegmentOutput {
      public:
        explicit Output(Planner& planner) : planner_(planner) {}
        Segment& begin(rrs::TargetId id) override;
        void finish() override;
        double time_s() const override { return planner_.end_s_; }

      private:
        Planner& planner_;
    };

    PlanResult reserve_segments(std::size_t segments);
    PlanResult solve_pose(const PoseGoal& goal, rrs::JointPos& joints) const;

    EnqueueResult enqueue_joint_move(const Move& move);
    EnqueueResult enqueue_path_move(const Move& move);
    EnqueueResult enqueue_pending_move(const Move& move);
    bool is_interpolated(const Move& move) const;
    void leave_model();
    void set_parameters(const Move& move, PathMove& path) const;
    PlanResult build_path(const Move& move);
    PlanResult build_circle(const Move& move, PathMove& path) const;
    PlanResult check_circular(bool rapid) const;
    static tl::unexpected<PlanError> no_via_point_error();
    Segment& begin_segment(Segment& slot, rrs::TargetId id);
    void append(const Segment& segment);
    void append_dwell(rrs::TargetId id, double dwell_s);
    double counted_dwell_s(double programmed_s) const;
    void end_model();
    rrs::JointPos standstill_position() const;
    void emit_front();

    // Tool moves (planner_tool_moves.cpp).
    bool moves_tool(const Move& move) const;
    bool has_fixed_joints() const { return !setup_.kinematics->fixed_joints().empty(); }
    tl::expected<Eigen::Vector3d, PlanError> via_point(const Move& move) const;
    tl::expected<TcpPath, PlanError> make_tcp_path(const Move& move, const Eigen::Vector3d& from,
                                                   const Eigen::Vector3d& to) const;
    tl::expected<std::unique_ptr<ToolPath>, PlanError> make_tool_path(const Move& move) const;
    EnqueueResult enqueue_tool_move(const Move& move);
    PlanResult add_sub_segments(const PathMove& full_move, const ToolPath& path,
                                const std::vector<PathSubSegment>& sub_segments);

    // Operator overrides without a model (planner_overrides.cpp).
    Overrides current_overrides() const;
    double current_override_share(const EnabledOverrides& enabled_overrides, bool rapid) const;
    void wait_out_hold(rrs::TargetId id, const rrs::JointPos& at, const EnabledOverrides& enabled_overrides,
                       bool rapid);
    void append_overridden(const PathMove& path, Segment& segment);
    struct ActiveMove;
    void emit_part(ActiveMove& active_move, const TimeLaw& law, double t_s);
    void plan_remainder(ActiveMove& active_move, double start_speed);
    bool emit_next_part(ActiveMove& active_move);

    // Independent joints (planner_independent.cpp).
    bool has_independent_motion(double time_s) const;
    PlanResult check_independent(const Move& move) const;

    // Conveyors (planner_conveyor.cpp).
    PlanResult stop_tracking();
    const PlannerSetup& setup_for_motion();
    tl::expected<const PlannerSetup*, PlanError> setup_for_move(const PathMove& path);
    PlanResult superimpose(Segment& segment) const;
    rrs::JointPos position_at_end() const;
    bool buffers_moves() const { return model_ && !tracking_; }

    PlannerSetup machine_;
    PlannerSetup setup_;          ///< The machine as the terms in force have it.
    PlannerSetup limited_setup_;  ///< The same with the accelerations of one move (MoveLimits).
    std::shared_ptr<const PlannerSetup> active_machine_;
    std::shared_ptr<const ProgrammedRamps> active_ramps_;
    SegmentSink* sink_;
    PathSink* path_sink_ = nullptr;
    std::optional<AxisSpace> axis_space_;
    SegmentQueue queue_;
    rrs::JointPos position_;
    PathMove path_;  ///< Path of the enqueued move.
    Output output_{*this};
    std::unique_ptr<MotionModel> model_;       ///< Null if each move ends at standstill.
    std::unique_ptr<MotionModel> tool_model_;  ///< Model for sub-segments of tool moves, if model_ cannot.
    PendingTargets pending_;                   ///< By the model.
    EventList events_;
    /// Remainder of a stopped motion, and its position.
    struct Stopped {
        std::vector<Segment> remainder;
        rrs::JointPos position;
    };
    std::optional<Stopped> stopped_;
    std::map<int, ConveyorMotion> conveyors_;
    /// Conveyor that gives the frame of the targets, and of position_.
    struct Tracking {
        int conveyor;
        ConveyorFrame frame;
        PlannerSetup setup;  ///< Machine with the speed that the conveyor leaves.
    };
    std::optional<Tracking> tracking_;
    std::optional<IndependentMotion> independent_motion_;
    double tracking_end_s_ = 0;        ///< When the last one was left.
    bool keeps_all_segments_ = false;  ///< True: segments leave the queue only explicitly; it grows.
    double end_s_ = 0;
    double step_s_ = 0;
    rrs::TargetId step_target_ = kNoTarget;  ///< Target of the last step.
    double last_wait_s_ = 0;                 ///< When the controller waited for its program last.
    bool has_position_ = false;
};

}  // namespace gsim::motion
