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
#include "motion/path/tool_path.h"
#include "motion/path/way_sink.h"
#include "motion/planner/held_targets.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/move.h"
#include "motion/planner/own_motion.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/planner/stop.h"
#include "motion/segment/event_list.h"
#include "motion/segment/segment.h"
#include "motion/segment/segment_queue.h"

namespace gsim::motion {

/// The target of what no target asked for, such as the time in which the controller waits for its program.
inline constexpr rrs::TargetId kNoTarget = -1;

/// Looks at a segment, and answers with the instant on the planner's clock at which its motion is to be
/// stopped, if it is.
using StopSearch = std::function<std::optional<double>(const Segment&)>;

/// A move that was put takes longer than it asks for: the machine can do it no faster.
struct TimeRaised {
    double takes_s = 0;
    double asked_s = 0;
    bool at_least = false;  ///< How much longer is not known before the moves behind it.
};

/// The same as an answer: RRS_MOTION_TIME_RAISED and a sentence.
PlanError time_raised(const TimeRaised& raised);

/// Whether a value that is programmed is above 0; `what` it is. RRS_INVALID_PARAMETER.
Planned check_positive(double value, std::string_view what);
/// Whether a move may be asked to take a time. RRS_INVALID_PARAMETER.
Planned check_motion_time(double motion_s);

/// What becomes of a move that is put; an error leaves all as it was.
using Put = tl::expected<std::optional<TimeRaised>, PlanError>;

/// The planner for machines whose maker gives none (thesis 5.3.2): moves, each a whole value, become
/// segments. Joint, linear and circular motion comes to rest at each target, or, where the setup names a
/// controller that does not, linear and circular motion goes by that controller's MotionModel. A clock starts
/// at 0.
///
/// Each move (and each rest) becomes segments at the end of a queue: one, or with a model as many as it
/// makes of it. Segments leave the queue in order, each exactly once, to the sink: all of them with flush(),
/// those that step() passes, and the oldest by itself when the queue is full. Without a sink a full queue is
/// RRS_QUEUE_FULL. The step clock never stands before the end of what has left. Without a model a move to
/// where the robot stands already becomes a segment of no duration, so that target ids arrive complete and in
/// order. A model may hold moves back until it knows those that follow: joint motion, rests, flush(), stop()
/// and step() past the end of what is planned make it come to rest.
///
/// Mixed moves at rest to rest: the path of the position joints leads by the programmed speed; each other
/// joint follows by its own fastest ramps; the slowest of all sets the time, and the others run slower to
/// take as long. The rotary joints of a via point are not looked at. Where rapids are not interpolated each
/// joint of one goes by itself (apart_move.h), also where a tip or a pose is led: that is for feeds.
class Planner {
  public:
    /// `sink`, where there is one, must outlive the planner, and must not call it while it takes a segment.
    /// Throws std::invalid_argument with the sentence of setup.validate() where that finds fault.
    explicit Planner(PlannerSetup setup, SegmentSink* sink = nullptr);
    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;

    /// What the operator turns the overrides to, on this planner's clock. Before the first move.
    void set_overrides(std::shared_ptr<const OverrideSchedule> overrides) {
        machine_.overrides = setup_.overrides = std::move(overrides);
    }
    /// What sets the accelerations of the joints for each move. Before the first move.
    void set_move_limits(std::shared_ptr<const MoveLimits> limits) {
        machine_.move_limits = setup_.move_limits = std::move(limits);
    }
    /// From now on `ways`, which must outlive the planner, is told what the model's moves are to be.
    void tell_ways(WaySink& ways) { ways_ = &ways; }
    /// Back to the beginning: the clock at 0, nothing queued, no position, the machine as it is.
    void start_over();
    /// Puts in force what these terms change of the machine, as a move with them does.
    void use(const MoveTerms& terms);

    /// The machine as the planner was given it; and with what the last terms have changed of it.
    const PlannerSetup& machine() const { return machine_; }
    const PlannerSetup& setup() const { return setup_; }
    /// Whether its moves may end without a stop.
    bool passes_targets() const { return model_ != nullptr; }

    /// RRS_MODE_NOT_SUPPORTED where the machine has no three slides that make up for what its rotary joints
    /// move the tip.
    Planned check_tip_control() const;
    /// RRS_MODE_NOT_SUPPORTED where the controller has ramps of its own.
    Planned check_ramps() const;
    /// The joint values of a place: of a pose those nearest to the last target. RRS_INVALID_PARAMETER,
    /// RRS_NO_SOLUTION, RRS_JOINT_LIMIT.
    Planned solve(const Goal& goal, rrs::JointPos& joints) const;
    /// Whether they are values for the joints of this machine, whatever their ranges. RRS_INVALID_PARAMETER.
    Planned check_joints(const rrs::JointPos& joints) const;
    /// Where the robot stands, at rest, before the next move; what is queued before is finished first.
    Planned stand_at(const Goal& goal);
    /// Whether a move may be put now. RRS_NO_INITIAL_POSITION; RRS_QUEUE_FULL while a motion is stopped.
    Planned ready_for_move() const;
    /// Queues a move. RRS_NO_INITIAL_POSITION, RRS_QUEUE_FULL, and what solve() and the planning answer.
    Put put(const Move& move);
    /// A move that something may end: flush(), then the move is planned to its end at rest and shown to
    /// `search`, segment by segment. At the instant that it answers the motion is stopped as by stop(), and
    /// the rest of it is dropped; then flush().
    Put put_until(const Move& move, const StopSearch& search);
    /// Queues a dwell from 0 to kLongest_s.
    Planned put_rest(rrs::TargetId id, double rest_s);

    /// Joints go to their values in `end` by themselves (OwnMotion), from the end of what is planned on,
    /// which is at rest; moves that follow do not wait for them. RRS_MODE_NOT_SUPPORTED while others do,
    /// along a conveyor and where corners are rounded; RRS_INVALID_PARAMETER, RRS_JOINT_LIMIT.
    Planned put_own(const rrs::JointPos& end);
    /// When the joints that go by themselves stand; 0 where none has.
    double own_end_s() const { return own_ ? own_->end_s() : 0; }

    /// Makes all queued segments final and passes them on; the step clock goes to their end. Continues a
    /// stopped motion.
    void flush();
    /// Plans what a model holds back to end at rest. `waits`: the controller then waits for its program,
    /// which takes its rest_s if anything has moved since it did so last.
    void come_to_rest(bool waits = false);
    /// come_to_rest() at the end of a program, whose last positions go through the controller's position
    /// loop.
    void come_to_last_rest();

    /// Up to here all motion has left the queue; infinite where nothing is in it.
    double passed_on_s() const;
    /// End of the last planned segment; what a model holds back is not counted.
    double time_s() const { return end_s_; }
    /// Where step() stands.
    double step_time_s() const { return step_s_; }
    bool has_position() const { return has_position_; }
    /// Joint values at the last target; while a conveyor is tracked, in its frame.
    const rrs::JointPos& position() const { return position_; }

    /// Where a step ends.
    struct Step {
        enum class End { under_way, target_reached, at_end } end = End::under_way;
        rrs::JointPos joints;
        double elapsed_s = 0;  ///< Less than was asked for only where the queue came to its end.
    };
    /// Moves on by a time; there has to be a position.
    Step step(double interpolation_s);
    /// The target whose motion or rest the last step ended in.
    rrs::TargetId target_of_last_step() const { return step_target_; }
    /// The target that the motion from there on leads to; kNoTarget where there is none.
    rrs::TargetId current_target() const;

    /// Brakes from the instant at which step() stands, each joint within its limits (stop.h), over as many
    /// segments as it takes; step() then goes on to the stop. Until go_on() or cancel() moves are refused
    /// (RRS_QUEUE_FULL). RRS_MODE_NOT_SUPPORTED along a conveyor, RRS_NO_INITIAL_POSITION.
    Planned stop();
    bool is_stopped() const { return stopped_.has_value(); }
    /// Goes on with a motion that is stopped.
    void go_on();
    /// Drops the rest of a motion that is stopped, and what is queued behind it.
    void cancel();

    /// Events come true in the steps: an offset from reaching a target.
    void define_event(int event_id, rrs::TargetId target, EventOffset offset) {
        events_.define(event_id, target, offset);
    }
    bool cancel_event(int event_id) { return events_.cancel(event_id); }
    const std::vector<EventList::CameTrue>& events_of_last_step() const { return events_.came_true(); }

    /// As the services of the same names; `direction` in the machine's own frame. RRS_INVALID_PARAMETER,
    /// RRS_MODE_NOT_SUPPORTED, RRS_JOINT_LIMIT.
    Planned define_conveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s);
    Planned set_conveyor_position(int conveyor, double position_mm);
    /// `base`: how the machine has been turned in the world from where its kinematics have it.
    Planned select_tracking(int conveyor, bool on, const Eigen::Matrix3d& base);
    bool is_tracking() const { return tracked_.has_value(); }
    /// Whether the step clock stands where a conveyor is tracked, or was.
    bool steps_along_conveyor() const { return tracked_ || step_s_ < conveyor_until_s_; }

  private:
    // Where the model puts its segments: the end of the queue.
    class Output final : public SegmentOutput {
      public:
        explicit Output(Planner& planner) : planner_(planner) {}
        Segment& begin(rrs::TargetId id) override;
        void finish() override;
        double time_s() const override { return planner_.end_s_; }

      private:
        Planner& planner_;
    };

    Planned make_room(std::size_t segments);
    Planned solve_pose(const PoseGoal& goal, rrs::JointPos& joints) const;

    Put put_joint_move(const Move& move);
    Put put_path_move(const Move& move);
    Put put_held_move(const Move& move);
    bool interpolates(const Move& move) const;
    void leave_model();
    void set_terms(const Move& move, PathMove& path) const;
    Planned shape_path(const Move& move);
    Planned shape_circle(const Move& move, PathMove& path) const;
    Planned circular_allowed(bool rapid) const;
    static tl::unexpected<PlanError> no_via_point();
    Segment& begin_segment(Segment& slot, rrs::TargetId id);
    void append(const Segment& segment);
    void append_rest(rrs::TargetId id, double rest_s);
    double dwell_s(double programmed_s) const;
    void end_model();
    rrs::JointPos standing() const;
    void emit_front();

    // Tool moves (planner_tool_moves.cpp).
    bool moves_tool(const Move& move) const;
    bool holds_joints() const { return !setup_.kinematics->held_joints().empty(); }
    tl::expected<Eigen::Vector3d, PlanError> via_point(const Move& move) const;
    tl::expected<TipWay, PlanError> tip_way(const Move& move, const Eigen::Vector3d& from,
                                            const Eigen::Vector3d& to) const;
    tl::expected<std::unique_ptr<ToolPath>, PlanError> tool_path(const Move& move) const;
    Put put_tool_move(const Move& move);
    Planned add_pieces(const PathMove& whole, const ToolPath& path, const std::vector<PathPiece>& pieces);

    // What the operator turns, where there is no model (planner_overrides.cpp).
    Overrides overrides_now() const;
    double share_now(const ObeyedOverrides& obeyed, bool rapid) const;
    void wait_out_hold(rrs::TargetId id, const rrs::JointPos& at, const ObeyedOverrides& obeyed, bool rapid);
    void append_overridden(const PathMove& path, Segment& segment);
    struct OnWay;
    void put_part(OnWay& on_way, const TimeLaw& law, double t_s);
    void plan_rest_of(OnWay& on_way, double start_speed);
    bool put_next_part(OnWay& on_way);

    // Joints that go by themselves (planner_own.cpp).
    bool has_own_motion(double time_s) const;
    Planned check_own(const Move& move) const;

    // Conveyors (planner_conveyor.cpp).
    Planned stop_tracking();
    const PlannerSetup& setup_for_motion();
    tl::expected<const PlannerSetup*, PlanError> setup_on(const PathMove& path);
    Planned carry(Segment& segment) const;
    rrs::JointPos position_at_end() const;
    bool holds_back() const { return model_ && !tracked_; }

    PlannerSetup machine_;
    PlannerSetup setup_;    ///< The machine as the terms in force have it.
    PlannerSetup limited_;  ///< The same with the accelerations of one move (MoveLimits).
    std::shared_ptr<const PlannerSetup> machine_in_force_;
    std::shared_ptr<const ProgrammedRamps> ramps_in_force_;
    SegmentSink* sink_;
    WaySink* ways_ = nullptr;
    std::optional<AxisSpace> axis_space_;
    SegmentQueue queue_;
    rrs::JointPos position_;
    PathMove path_;  ///< Of the move that is put.
    Output output_{*this};
    std::unique_ptr<MotionModel> model_;       ///< None where each move ends at rest.
    std::unique_ptr<MotionModel> tool_model_;  ///< For the pieces of tool moves, where model_ cannot.
    HeldTargets held_;                         ///< By the model.
    EventList events_;
    /// What is left of a stopped motion, and where it stands.
    struct Stopped {
        std::vector<Segment> rest;
        rrs::JointPos position;
    };
    std::optional<Stopped> stopped_;
    std::map<int, ConveyorMotion> conveyors_;
    /// The conveyor in whose frame targets are, position_ as well.
    struct Tracked {
        int conveyor;
        ConveyorFrame frame;
        PlannerSetup setup;  ///< What the machine has left beside the conveyor's speed.
    };
    std::optional<Tracked> tracked_;
    std::optional<OwnMotion> own_;
    double conveyor_until_s_ = 0;  ///< When the last one was left.
    bool keeps_all_ = false;       ///< Nothing leaves the queue by itself; it grows instead.
    double end_s_ = 0;
    double step_s_ = 0;
    rrs::TargetId step_target_ = kNoTarget;  ///< Of the last step.
    double waited_s_ = 0;                    ///< When the controller waited for its program last.
    bool has_position_ = false;
};

}  // namespace gsim::motion
