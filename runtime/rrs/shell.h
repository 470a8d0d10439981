#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "runtime/rrs/status.h"
#include "runtime/rrs/types.h"

namespace gsim::rrs {

/// The interface of a robot controller's motion: Realistic Robot Simulation (RRS) services, one method each.
/// The default planner and loaded controller modules derive from it and override what they offer.
///
/// Every method answers a Status and, unless overridden, answers RRS_SERVICE_NOT_SUPPORTED and does nothing.
/// After a negative status nothing has changed. Lengths are mm, angles rad, times s; joint values are mm
/// (prismatic) or rad (revolute). Every service that is offered, other than Initialize and GetMessage,
/// answers RRS_NOT_INITIALIZED before Initialize, and RRS_INVALID_PARAMETER for a number that is not finite
/// or out of the range stated here. Selections and programmed values are modal: they hold for all following
/// targets until set again.
class Shell {
  public:
    virtual ~Shell() = default;

    // --- Session ---

    /// Makes the controller ready: nothing queued, no position, all selections and values at their defaults.
    virtual Status Initialize();
    /// Back to the state just after Initialize; what is queued is dropped.
    virtual Status Reset();
    /// Ends the session; what is queued is dropped.
    virtual Status Terminate();
    /// The sentence that explains the last answer other than plain success; empty if there was none.
    virtual Status GetMessage(std::string& message);

    // --- Kinematics and frames ---

    /// Joint values that bring the tool to `pose`, of all solutions the one nearest to `near`; joint ranges
    /// are not looked at. RRS_NO_SOLUTION where there is none.
    virtual Status GetInverseKinematics(const CartPos& pose, const JointPos& near, JointPos& joints);
    /// Pose of the tool, as targets have it, for joint values, whether in range or not.
    virtual Status GetForwardKinematics(const JointPos& joints, CartPos& pose);
    /// The frame called `frame_name` in the cell. RRS_UNKNOWN_FRAME.
    virtual Status GetCellFrame(std::string_view frame_name, CartPos& frame);
    /// Gives the frame called `frame_name` a new value for what follows: "tool" is the robot's tool centre
    /// point in the frame of the last joint in front of it, "base" where the robot stands in the world.
    /// RRS_UNKNOWN_FRAME.
    virtual Status ModifyCellFrame(std::string_view frame_name, const CartPos& frame);
    /// Selects the tool frame that moves and the object frame in which targets are given, and poses told.
    /// Default: the tool centre point and the work frame. RRS_UNKNOWN_FRAME; RRS_INVALID_PARAMETER where the
    /// frames do not move with those of the default.
    virtual Status SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame);

    // --- Targets ---

    /// Whether targets (and the initial position) are taken from their Cartesian or from their joint value.
    /// Default: joint.
    virtual Status SelectTargetType(TargetType type);
    /// How the controller treats the trajectory between targets; the numbers are the controller's own.
    virtual Status SelectTrajectoryMode(int mode);
    /// Where the robot stands, at rest, before the next target. Of `cartesian` and `joints` the one counts
    /// that SelectTargetType chose. What is queued before is finished first. RRS_JOINT_LIMIT,
    /// RRS_NO_SOLUTION.
    virtual Status SetInitialPosition(const CartPos& cartesian, const JointPos& joints,
                                      std::string_view configuration);
    /// Queues a motion to a target, or with TargetParam::via keeps the via point of the circular motion whose
    /// end follows. Of `cartesian` and `joints` the one counts that SelectTargetType chose. `configuration`
    /// and `param_value` are the controller's own; empty and 0 where it has none. RRS_NO_INITIAL_POSITION,
    /// RRS_NO_SOLUTION, RRS_JOINT_LIMIT, RRS_ZERO_SPEED, RRS_CIRCLE_IMPOSSIBLE,
    /// RRS_MOTION_TYPE_NOT_SUPPORTED, RRS_QUEUE_FULL; RRS_MOTION_TIME_RAISED (queued all the same).
    virtual Status SetNextTarget(TargetId id, TargetParam param, const CartPos& cartesian,
                                 const JointPos& joints, std::string_view configuration, double param_value);
    /// SetNextTarget for a target that has a name, which messages then quote.
    virtual Status SetNextNamedTarget(TargetId id, TargetParam param, const CartPos& cartesian,
                                      const JointPos& joints, std::string_view configuration,
                                      double param_value, std::string_view target_name);

    // --- Motion over time ---

    /// Moves on by one interpolation time and tells where the robot is then. `elapsed_s`: the time that this
    /// step took; less than the interpolation time only where the queue came to its end. RRS_SUCCESS under
    /// way, RRS_TARGET_REACHED where a target was reached in this step, RRS_NEED_MORE_DATA where nothing is
    /// queued.
    virtual Status GetNextStep(JointPos& joints, CartPos& pose, double& elapsed_s);
    /// The step of GetNextStep, in s, at least 1e-6. Default: 0.01.
    virtual Status SetInterpolationTime(double interpolation_s);
    /// Brings the motion under way to a stop on its path. GetNextStep goes on until it stands, and answers
    /// RRS_NEED_MORE_DATA then.
    virtual Status StopMotion();
    /// Goes on with a stopped motion, once it stands. RRS_INVALID_PARAMETER where none is stopped.
    virtual Status ContinueMotion();
    /// Drops the rest of a stopped motion and what is queued behind it. RRS_INVALID_PARAMETER where none is
    /// stopped.
    virtual Status CancelMotion();

    // --- Kind of motion ---

    /// Joint, linear or circular, for the targets that follow. Default: joint.
    /// RRS_MOTION_TYPE_NOT_SUPPORTED where this machine cannot.
    virtual Status SelectMotionType(MotionType type);
    /// How orientation is interpolated along a path; the numbers are the controller's own. The default
    /// planner: 0, by the joint angles; 1, the tool's direction goes along the great circle, evenly with the
    /// length of the way, in linear and circular motion that is not rapid. 1 is for machines whose tool is
    /// turned by one joint and tilted by another one through its tip, and not for controllers that plan in
    /// joint space alone: RRS_MODE_NOT_SUPPORTED. With it, targets answer RRS_NO_SOLUTION where no great
    /// circle leads to their joint values: from or to a tool along the axis of the turning joint, if that
    /// joint would turn; to the opposite direction; to another half or whole turn of the joints.
    virtual Status SelectOrientationInterpolationMode(int mode);
    /// Which rule sets the time of a move that changes position and orientation. Default: automatic.
    virtual Status SelectDominantInterpolation(Dominance dominance);

    // --- Speeds and accelerations ---

    /// Programmed speeds of joints in joint motion, absolute: mm/s or rad/s, each > 0, infinity for the
    /// joint's own limit (the default). `joints` holds indices from 0, empty for all joints in order; one
    /// speed each.
    virtual Status SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds);
    /// Programmed accelerations of joints in joint motion: mm/s2 or rad/s2; otherwise as SetJointSpeeds.
    virtual Status SetJointAccelerations(std::span<const int> joints, std::span<const double> accelerations);
    /// Programmed jerks of joints in joint motion: mm/s3 or rad/s3; otherwise as SetJointSpeeds. A finite one
    /// holds with the ramps of any controller, but not with linear or infinite ones of SetRampMode.
    virtual Status SetJointJerks(std::span<const int> joints, std::span<const double> jerks);
    /// Programmed speed of the tool along linear and circular paths, > 0, infinity for the limits of the
    /// machine. No default: without it such a motion answers RRS_ZERO_SPEED.
    virtual Status SetCartesianPositionSpeed(double speed_mm_s);
    /// Programmed speed of orientation in linear and circular motion, > 0. Default: infinity, no limit but
    /// those of the joints.
    virtual Status SetCartesianOrientationSpeed(double speed_rad_s);
    /// Programmed acceleration of the tool along linear and circular paths, > 0. Default: infinity, no limit
    /// but those of the machine.
    virtual Status SetCartesianPositionAcceleration(double acceleration_mm_s2);
    /// Programmed acceleration of orientation, > 0. Default: infinity, no limit but those of the joints.
    virtual Status SetCartesianOrientationAcceleration(double acceleration_rad_s2);
    /// Scales all programmed speeds: 0 < percent <= 200, default 100. Limits of the machine still hold.
    virtual Status SetOverrideSpeed(double percent);
    /// Scales all programmed accelerations: 0 < percent <= 200, default 100. Limits of the machine still
    /// hold.
    virtual Status SetOverrideAcceleration(double percent);
    /// The next target alone takes `motion_s` > 0 instead of a time from programmed speeds, or, if that is
    /// less than the limits of the machine allow, the least time that they do (RRS_MOTION_TIME_RAISED).
    virtual Status SetMotionTime(double motion_s);
    /// Dwell of `rest_s` >= 0 behind the next target alone; it carries that target's id.
    virtual Status SetRestParameter(double rest_s);

    // --- Passing by targets, and accuracy ---

    /// Whether motion flies by targets without stopping. Default: off. RRS_MODE_NOT_SUPPORTED.
    virtual Status SelectFlybyMode(bool on);
    /// Puts a fly-by criterion in force for the targets that follow; the numbers of criteria are the
    /// controller's own. The default planner: 1, no joint's speed jumps by more than its value (mm/s or
    /// rad/s); 2, the speed on an arc that would miss the corner by the value (mm, of all joints); both with
    /// look-ahead. 3, corners are cut by no more than the value (mm, of all joints), with the planner of
    /// LinuxCNC. RRS_MODE_NOT_SUPPORTED.
    virtual Status SelectFlybyCriteria(int criterion);
    /// Gives a fly-by criterion its value for a joint (from 0; -1: for all).
    virtual Status SetFlybyCriteriaParameter(int criterion, int joint, double value);
    /// Takes a fly-by criterion out of force: the machine's own holds. RRS_INVALID_PARAMETER where it is not
    /// in force.
    virtual Status CancelFlybyCriteria(int criterion);
    /// Selects how exactly targets are reached; the numbers are the controller's own. The default planner: 0,
    /// exact stops do not wait; 1, they wait for its value (s; the machine's, unless it is set), with
    /// look-ahead. RRS_MODE_NOT_SUPPORTED.
    virtual Status SelectPointAccuracy(int accuracy_type);
    /// Gives a kind of point accuracy its value.
    virtual Status SetPointAccuracyParameter(int accuracy_type, double value);

    // --- Events and tracking ---

    /// Defines an event that comes true `offset_s` (negative: before) from reaching a target, once. The same
    /// id defines it anew. An event whose target has been put comes true in the step of its instant: a step
    /// towards it plans the target, if need be to end at rest, as a step past the end of the plan does. One
    /// whose target was put or whose motion was passed on too late for that comes true in the next step, with
    /// its own time. A target that was reached before its event was defined is not reached again.
    virtual Status DefineEvent(int event_id, TargetId target, double offset_s);
    /// Takes back an event that has not come true. RRS_INVALID_PARAMETER where there is none.
    virtual Status CancelEvent(int event_id);
    /// The number-th (from 0) event that came true in the last step, and when, in s since the step's start;
    /// negative for one that was known too late for its step. In the order of time. RRS_INVALID_PARAMETER
    /// where there were no more.
    virtual Status GetEvent(int number, int& event_id, double& time_s);
    /// Whether the targets that follow are in the frame of a conveyor and move with it. Where it stands at 0
    /// its frame is that of other targets. The default planner comes to rest, and then speeds up to the
    /// conveyor or slows down from it as the joints can; targets are reached at rest on the conveyor.
    /// RRS_INVALID_PARAMETER for a conveyor that is not defined, or while another is tracked;
    /// RRS_MODE_NOT_SUPPORTED where no joints carry the tool along it, RRS_JOINT_LIMIT where it is too fast
    /// for them.
    virtual Status SelectTracking(int conveyor, bool on);
    /// Where a conveyor stands at the end of what is queued: mm of travel. RRS_INVALID_PARAMETER where it is
    /// tracked and would jump.
    virtual Status SetConveyorPosition(int conveyor, double position_mm);

    // --- Motion of an object of the cell ---

    /// Extension. The object that is moved is this frame of the cell, and what is attached to it: from where
    /// it is, on the clock of the motion. Its targets are relative to what it is attached to, and begin where
    /// the program stands, which comes to rest. RRS_UNKNOWN_FRAME.
    virtual Status SelectObject(std::string_view frame_name);
    /// Speed of the object for the targets that follow: mm/s, > 0. No default: RRS_ZERO_SPEED without it.
    virtual Status SetObjectSpeed(double speed_mm_s);
    /// Queues a motion of the object to a pose: in a straight line at the speed in force, from the first
    /// instant to the last; it turns in proportion to the way. RRS_ZERO_SPEED where it would turn only,
    /// RRS_QUEUE_FULL.
    virtual Status SetObjectNextTarget(TargetId id, const CartPos& pose);
    /// Moves the object on by one interpolation time and tells where it is; answers as GetNextStep does.
    virtual Status GetNextObjectStep(CartPos& pose, double& elapsed_s);

    // --- Extensions: not services of RRS, but of this program ---

    /// Extension. Rapid positioning for the linear targets that follow: the machine's rapid speed and the
    /// limits of its joints hold, programmed speeds and accelerations do not. Default: off.
    virtual Status SetRapid(bool on);
    /// Extension. Queues a circular motion given by its centre and sense, whatever the selected motion type:
    /// full circles, several turns and helices as well. `center_mm` is any point of the circle's axis and
    /// `axis` a unit vector, both in the space of the target type: the work frame for Cartesian targets, the
    /// position joints x, y, z for joint targets. Travel is counter-clockwise about `axis`, by `sweep_rad` >
    /// 0 in all, and along `axis` as far as the target asks. Answers as SetNextTarget, and
    /// RRS_CIRCLE_IMPOSSIBLE also where the target does not lie on the circle at the end of the sweep.
    virtual Status SetNextArcTarget(TargetId id, const Eigen::Vector3d& center_mm,
                                    const Eigen::Vector3d& axis, double sweep_rad, const CartPos& cartesian,
                                    const JointPos& joints);
    /// Extension. How the targets that follow are passed, and in continuous mode how far corners may be cut
    /// (tolerance_mm >= 0; 0: as far as the controller does) and within what lines may be merged. Default:
    /// exact stop. SelectFlybyMode selects continuous mode or exact stop by this.
    virtual Status SetPathMode(PathMode mode, double tolerance_mm, double merge_tolerance_mm);
    /// Extension. How the targets that follow speed up and slow down. Default: machine.
    /// RRS_MODE_NOT_SUPPORTED.
    virtual Status SetRampMode(RampMode mode);
    /// Extension. Lowers a limit of joints for the targets that follow, whatever the motion type: mm/s2 or
    /// rad/s2, for a jerk mm/s3 or rad/s3; each > 0, infinity for the joint's own limit (the default), which
    /// holds in any case. `joints` as in SetJointSpeeds. RRS_MODE_NOT_SUPPORTED.
    virtual Status SetJointRampLimits(RampLimit limit, std::span<const int> joints,
                                      std::span<const double> values);
    /// Extension. DefineEvent with a way instead of a time: the event comes true `offset_mm` (negative:
    /// before) of the tool's way from reaching a target. Known too late it has the time of the step's start,
    /// where the way to it has been passed on by then.
    virtual Status DefinePathEvent(int event_id, TargetId target, double offset_mm);
    /// Extension. Defines a conveyor, or gives it another direction (a vector of the world, of any length)
    /// and speed (negative: backwards); new ones stand at 0. RRS_INVALID_PARAMETER while it is tracked.
    virtual Status DefineConveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s);
    /// Extension. Where the object is, at rest, before its next target. What is queued for it is dropped.
    /// Default: the frame of the world.
    virtual Status SetObjectInitialPosition(const CartPos& pose);
    /// Extension. Queues a dwell of `rest_s` >= 0.
    virtual Status SetNextRest(TargetId id, double rest_s);
    /// Extension. The target whose motion or rest the last step of GetNextStep ended in; -1 for none.
    virtual Status GetTargetOfLastStep(TargetId& id);
    /// Extension. Tool-centre-point control: linear and circular targets that follow lead the tool's tip
    /// along lines and arcs in the work frame while the rotary joints go in proportion, and the slides make
    /// up for what these move it; the centre and the axis of an arc are in the work frame, too, and joint
    /// targets are joint values as ever. `tip_mm`: the tip in the frame of the tool centre point. Default:
    /// off. RRS_MODE_NOT_SUPPORTED where the machine has no three slides.
    virtual Status SetTipControl(bool on, const Eigen::Vector3d& tip_mm);
    /// Extension. What is queued is planned to end at rest, without regard to targets that may come.
    virtual Status ComeToRest(RestReason reason);

  protected:
    /// What the default of each service answers; a controller may note the name for GetMessage.
    virtual Status not_supported(std::string_view service);
};

}  // namespace gsim::rrs
