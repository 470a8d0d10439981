#pragma once

#include <Eigen/Core>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/motion/axis_space.h"
#include "runtime/motion/conveyor_frame.h"
#include "runtime/motion/event_list.h"
#include "runtime/motion/held_targets.h"
#include "runtime/motion/machine_frames.h"
#include "runtime/motion/motion_model.h"
#include "runtime/motion/object_motion.h"
#include "runtime/motion/plan_error.h"
#include "runtime/motion/planner_setup.h"
#include "runtime/motion/programmed.h"
#include "runtime/motion/segment.h"
#include "runtime/motion/segment_queue.h"
#include "runtime/motion/stop.h"
#include "runtime/motion/tool_path.h"
#include "runtime/motion/way_sink.h"
#include "runtime/rrs/shell.h"

namespace gsim::motion {

/// The target of what no target asked for, such as the time in which the controller waits for its program.
inline constexpr rrs::TargetId kNoTarget = -1;

/// Looks at a segment, and answers with the instant on the planner's clock at which its motion is to be
/// stopped, if it is.
using StopSearch = std::function<std::optional<double>(const Segment&)>;

/// The planner for machines whose maker gives none (thesis 5.3.2): joint, linear and circular motion that
/// comes to rest at each target, or, where the setup names a controller that does not, linear and circular
/// motion by that controller's MotionModel.
///
/// Each target (and each rest) becomes segments at the end of a queue: one, or with a model as many as it
/// makes of it. Segments leave the queue in order, each exactly once, to the sink: all of them with flush(),
/// those that GetNextStep passes, and the oldest by itself when the queue is full. Without a sink a full
/// queue answers RRS_QUEUE_FULL. The step clock of GetNextStep never stands before the end of what has left.
/// Without a model a target where the robot stands already becomes a segment of no duration, so that target
/// ids arrive complete and in order; the dwell of SetRestParameter is a segment of its own with its target's
/// id. A via point has no segment. A model may hold targets back until it knows those that follow: joint
/// motion, dwells, flush(), StopMotion and GetNextStep past the end of what is planned make it come to rest.
///
/// Services of time: StopMotion brakes from the instant at which GetNextStep stands, each joint within its
/// limits (stop.h), over as many segments as it takes; GetNextStep then goes on to the stop. Until
/// ContinueMotion or CancelMotion targets are refused (RRS_QUEUE_FULL). flush() continues a stopped motion.
/// Events come true in the steps of GetNextStep.
///
/// Mixed moves at rest to rest: the path of the position joints leads by the programmed speed; each other
/// joint follows by its own fastest ramps; the slowest of all sets the time, and the others run slower to
/// take as long. `configuration` and `param_value` of targets are not looked at. A via point's rotary joints
/// are not, either.
class DefaultPlanner final : public rrs::Shell {
  public:
    /// `sink`, where there is one, must outlive the planner, and must not call its services while it takes a
    /// segment. Throws std::invalid_argument with the sentence of setup.validate() where that finds fault.
    explicit DefaultPlanner(PlannerSetup setup, SegmentSink* sink = nullptr);

    /// The robot stands in this cell, which must outlive the planner, on whose clock the run's time is.
    void set_cell(CellFrames& cell) { cell_ = &cell; }
    /// What the operator turns the overrides to, on this planner's clock. Before the first target.
    void set_overrides(std::shared_ptr<const OverrideSchedule> overrides) {
        machine_.overrides = setup_.overrides = std::move(overrides);
    }
    /// What the targets that follow obey of them.
    void set_obeyed(const ObeyedOverrides& obeyed) { programmed_.obeyed = obeyed; }
    /// Whether the speeds that they are given go by turns of the spindle.
    void set_follows_spindle(bool follows) { programmed_.follows_spindle = follows; }
    /// From now on `ways`, which must outlive the planner, is told what the model's moves are to be.
    void tell_ways(WaySink& ways) { ways_ = &ways; }
    /// No Cartesian position speed is programmed any more.
    void forget_position_speed() { programmed_.position_speed_mm_s = 0; }
    /// The frames of Cartesian targets: until SelectWorkFrames the tool centre point and the work frame.
    const WorkFrames& work_frames() const { return work_frames_; }

    /// Makes all queued segments final and passes them on; the step clock goes to their end.
    void flush();
    /// Plans what a model holds back to end at rest. `waits`: the controller then waits for its program,
    /// which takes its rest_s if anything has moved since it did so last.
    void come_to_rest(bool waits = false);
    /// flush() at the end of a program, whose last positions go through the controller's position loop.
    void end_program();
    /// A motion that something may end: flush(), then `put` queues a target, whose motion is planned to its
    /// end at rest and shown to `search`, segment by segment. At the instant that it answers the motion is
    /// stopped as by StopMotion, and the rest of it is dropped; then flush(). Returns what `put` answered, or
    /// why the motion cannot be stopped.
    rrs::Status put_until(const std::function<rrs::Status()>& put, const StopSearch& search);
    /// End of the last planned segment on the planner's clock, which starts at 0 with Initialize and Reset;
    /// what a model holds back is not counted.
    double time_s() const { return end_s_; }
    /// Where GetNextStep stands on the planner's clock.
    double step_time_s() const { return step_s_; }
    /// Joint values at the last target; while a conveyor is tracked, in its frame.
    const rrs::JointPos& position() const { return position_; }
    /// The last answer other than plain success, with its numbers; GetMessage gives its sentence.
    const PlanError& last_error() const { return error_; }
    /// The machine, with the ramps that are in force.
    const PlannerSetup& setup() const { return setup_; }

    rrs::Status Initialize() override;
    rrs::Status Reset() override;
    rrs::Status Terminate() override;
    rrs::Status GetMessage(std::string& message) override;

    rrs::Status GetInverseKinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                     rrs::JointPos& joints) override;
    rrs::Status GetForwardKinematics(const rrs::JointPos& joints, rrs::CartPos& pose) override;

    rrs::Status GetCellFrame(std::string_view frame_name, rrs::CartPos& frame) override;
    rrs::Status ModifyCellFrame(std::string_view frame_name, const rrs::CartPos& frame) override;
    rrs::Status SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) override;

    rrs::Status SelectTargetType(rrs::TargetType type) override;
    rrs::Status SetInitialPosition(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                   std::string_view configuration) override;
    rrs::Status SetNextTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                              const rrs::JointPos& joints, std::string_view configuration,
                              double param_value) override;
    rrs::Status SetNextNamedTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                                   const rrs::JointPos& joints, std::string_view configuration,
                                   double param_value, std::string_view target_name) override;
    rrs::Status SetNextArcTarget(rrs::TargetId id, const Eigen::Vector3d& center_mm,
                                 const Eigen::Vector3d& axis, double sweep_rad, const rrs::CartPos& cartesian,
                                 const rrs::JointPos& joints) override;
    rrs::Status SetNextRest(rrs::TargetId id, double rest_s) override;
    rrs::Status ComeToRest(rrs::RestReason reason) override;

    rrs::Status GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) override;
    rrs::Status GetTargetOfLastStep(rrs::TargetId& id) override;
    rrs::Status SetInterpolationTime(double interpolation_s) override;
    rrs::Status StopMotion() override;
    rrs::Status ContinueMotion() override;
    rrs::Status CancelMotion() override;

    rrs::Status SelectMotionType(rrs::MotionType type) override;
    rrs::Status SelectOrientationInterpolationMode(int mode) override;
    rrs::Status SelectDominantInterpolation(rrs::Dominance dominance) override;
    rrs::Status SelectFlybyMode(bool on) override;
    rrs::Status SetPathMode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) override;
    rrs::Status SetRapid(bool on) override;
    rrs::Status SetTipControl(bool on, const Eigen::Vector3d& tip_mm) override;
    rrs::Status SelectFlybyCriteria(int criterion) override;
    rrs::Status SetFlybyCriteriaParameter(int criterion, int joint, double value) override;
    rrs::Status CancelFlybyCriteria(int criterion) override;
    rrs::Status SelectPointAccuracy(int accuracy_type) override;
    rrs::Status SetPointAccuracyParameter(int accuracy_type, double value) override;

    rrs::Status SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) override;
    rrs::Status SetJointAccelerations(std::span<const int> joints,
                                      std::span<const double> accelerations) override;
    rrs::Status SetJointJerks(std::span<const int> joints, std::span<const double> jerks) override;
    rrs::Status SetRampMode(rrs::RampMode mode) override;
    rrs::Status SetJointRampLimits(rrs::RampLimit limit, std::span<const int> joints,
                                   std::span<const double> values) override;
    rrs::Status SetCartesianPositionSpeed(double speed_mm_s) override;
    rrs::Status SetCartesianOrientationSpeed(double speed_rad_s) override;
    rrs::Status SetCartesianPositionAcceleration(double acceleration_mm_s2) override;
    rrs::Status SetCartesianOrientationAcceleration(double acceleration_rad_s2) override;
    rrs::Status SetOverrideSpeed(double percent) override;
    rrs::Status SetOverrideAcceleration(double percent) override;
    rrs::Status SetMotionTime(double motion_s) override;
    rrs::Status SetRestParameter(double rest_s) override;

    rrs::Status DefineEvent(int event_id, rrs::TargetId target, double offset_s) override;
    rrs::Status DefinePathEvent(int event_id, rrs::TargetId target, double offset_mm) override;
    rrs::Status CancelEvent(int event_id) override;
    rrs::Status GetEvent(int number, int& event_id, double& time_s) override;

    rrs::Status DefineConveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) override;
    rrs::Status SelectTracking(int conveyor, bool on) override;
    rrs::Status SetConveyorPosition(int conveyor, double position_mm) override;
    rrs::Status SelectObject(std::string_view frame_name) override;
    rrs::Status SetObjectInitialPosition(const rrs::CartPos& pose) override;
    rrs::Status SetObjectSpeed(double speed_mm_s) override;
    rrs::Status SetObjectNextTarget(rrs::TargetId id, const rrs::CartPos& pose) override;
    rrs::Status GetNextObjectStep(rrs::CartPos& pose, double& elapsed_s) override;

  protected:
    rrs::Status not_supported(std::string_view service) override;

  private:
    // Where the model puts its segments: the end of the queue.
    class Output final : public SegmentOutput {
      public:
        explicit Output(DefaultPlanner& planner) : planner_(planner) {}
        Segment& begin(rrs::TargetId id) override;
        void finish() override;
        double time_s() const override { return planner_.end_s_; }

      private:
        DefaultPlanner& planner_;
    };

    rrs::Status tell(PlanError error);
    rrs::Status refuse(rrs::Status status, std::string message);
    rrs::Status not_initialized();
    rrs::Status set_positive(double& value, double wanted, std::string_view what);
    rrs::Status own_ramps();
    rrs::Status check_criterion(int criterion);
    rrs::Status check_accuracy(int accuracy_type);
    rrs::Status define_event(int event_id, rrs::TargetId target, EventOffset offset);
    void go_on();
    rrs::Status set_percent(double& factor, double percent, std::string_view what);
    rrs::Status set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                 std::span<const double> wanted, std::string_view what);

    void start_over();
    Planned ready_for_target();
    Planned make_room(std::size_t segments);
    Planned solve_target(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                         rrs::JointPos& target) const;
    Planned solve_joints(const rrs::JointPos& joints, rrs::JointPos& target) const;
    Planned solve_pose(const rrs::CartPos& pose, rrs::JointPos& target) const;
    rrs::Status keep_via(const rrs::CartPos& cartesian, const rrs::JointPos& joints);

    rrs::Status no_such_conveyor(int conveyor);
    rrs::Status stop_tracking();
    const PlannerSetup& setup_for_motion();
    Planned carry(Segment& segment) const;
    rrs::JointPos position_at_end() const;
    bool holds_back() const { return model_ && !tracked_; }

    Segment& begin_target(rrs::TargetId id, bool along_path);
    Segment& begin_segment(Segment& slot, rrs::TargetId id);
    rrs::Status finish_target(Segment& segment, Planned planned);
    Move move_of(const Segment& segment) const;
    Planned add_to_model(const Segment& segment);
    void end_model();
    void append(const Segment& segment);
    // What the operator turns, where there is no model (planner_overrides.cpp).
    Overrides overrides_now() const;
    bool goes_rapid() const;
    MoveRules rules_now() const;
    double share_now() const;
    void wait_out_hold(rrs::TargetId id, const rrs::JointPos& at);
    void append_overridden(Segment& segment);
    struct OnWay;
    void put_part(OnWay& on_way, const TimeLaw& law, double t_s);
    void plan_rest_of(OnWay& on_way, double start_speed);
    bool put_next_part(OnWay& on_way);
    void append_rest(rrs::TargetId id, double rest_s);
    double dwell_s(double programmed_s) const;
    rrs::JointPos standing() const;
    void emit_front();

    /// The circle of a target: by its via point, or by its centre.
    struct Circle {
        Eigen::Vector3d center_mm;
        Eigen::Vector3d axis;
        double sweep_rad = 0;
    };
    bool moves_tool(bool along_path) const;
    Eigen::Vector3d tip_mm() const;
    void keep_frames();
    Planned select_frames();
    const WorkFrames& frames_of_step(double from_s);
    void lead_object(const rrs::CartPos& pose, double duration_s);
    tl::expected<TipWay, PlanError> tip_way(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                            const std::optional<Circle>& circle) const;
    tl::expected<std::unique_ptr<ToolPath>, PlanError> tool_path(const rrs::CartPos& cartesian,
                                                                 const rrs::JointPos& joints,
                                                                 const std::optional<Circle>& circle) const;
    rrs::Status put_tool_move(rrs::TargetId id, const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                              const std::optional<Circle>& circle);
    Planned add_pieces(const Move& whole, const ToolPath& path, const std::vector<PathPiece>& pieces);

    Planned plan_selected(Segment& segment);
    Planned plan_orientation(Segment& segment) const;
    Planned plan_via_arc(Segment& segment);
    Planned plan_center_arc(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& axis, double sweep_rad,
                            Segment& segment);
    Planned plan_along_arc(Segment& segment);
    Planned circular_allowed() const;

    PlannerSetup machine_;
    PlannerSetup setup_;  ///< The machine as the program has set it.
    SegmentSink* sink_;
    WaySink* ways_ = nullptr;
    std::optional<AxisSpace> axis_space_;
    SegmentQueue queue_;
    Programmed programmed_;
    rrs::JointPos position_;
    std::optional<rrs::JointPos> via_;
    CellFrames* cell_ = nullptr;
    WorkFrames work_frames_;
    /// The names of work_frames_, where the program has selected them.
    struct SelectedFrames {
        std::string tool;
        std::string object;
    };
    std::optional<SelectedFrames> selected_;
    /// Frames in which the poses of what was queued are told, until frames were moved.
    struct FramesUntil {
        double until_s;
        WorkFrames frames;
    };
    std::deque<FramesUntil> frames_before_;
    double machine_moved_s_ = 0;          ///< When one of MachineFrames was changed last.
    bool tip_turns_ = false;              ///< The tip is not where the position joints alone say.
    std::optional<Eigen::Vector3d> tip_;  ///< Under tool-centre-point control, in the tool's frame.
    PlanError error_;
    Output output_{*this};
    std::unique_ptr<MotionModel> model_;       ///< None where each move ends at rest.
    Segment draft_;                            ///< Of the target that goes to the model.
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
    double conveyor_until_s_ = 0;  ///< When the last one was left.
    ObjectMotion object_;
    std::optional<std::string> object_frame_;  ///< Of the cell; that the object is.
    double object_free_s_ = 0;                 ///< When it is at its last target.
    bool keeps_all_ = false;                   ///< Nothing leaves the queue by itself; it grows instead.
    double end_s_ = 0;
    double step_s_ = 0;
    rrs::TargetId step_target_ = kNoTarget;  ///< Of the last step.
    double waited_s_ = 0;                    ///< When the controller waited for its program last.
    bool initialized_ = false;
    bool has_position_ = false;
};

}  // namespace gsim::motion
