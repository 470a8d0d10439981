#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/module/rcs_host.h"
#include "machine/model/machine.h"
#include "motion/path/axis_space.h"
#include "motion/planner/planner_setup.h"
#include "runtime/monitors/cell_watch.h"
#include "runtime/monitors/centripetal_watch.h"
#include "runtime/monitors/effort_watch.h"
#include "runtime/monitors/following_setup.h"
#include "runtime/monitors/interval_watch.h"
#include "runtime/monitors/process_watch.h"
#include "runtime/monitors/short_brakes_watch.h"
#include "runtime/monitors/violation_log.h"
#include "runtime/monitors/way_deviation.h"
#include "runtime/monitors/way_sinks.h"
#include "runtime/monitors/zone_watch.h"
#include "runtime/motion_sources/motion_observer.h"
#include "runtime/motion_sources/motion_source.h"
#include "runtime/motion_sources/step_ranges.h"
#include "runtime/report/recorder.h"
#include "runtime/report/report.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/event_log.h"
#include "runtime/simulator/move.h"
#include "runtime/simulator/open_calls.h"
#include "runtime/simulator/probe.h"
#include "runtime/simulator/probe_signal.h"
#include "runtime/simulator/program_observer.h"
#include "runtime/simulator/run_limits.h"
#include "runtime/simulator/setup_of_machine.h"
#include "runtime/simulator/tip_frame.h"
#include "runtime/simulator/tool_tips.h"

namespace gsim::simulation {

class AxesTimeWatch;
class FollowingWatch;

/// Run of one machine: accepts moves, dwells and events in the order of the program, plans them through the
/// services of its controller, and records the result. It does not depend on the language of the program.
///
/// The services that can fail return false; then alarm() has the reason, and the run must end.
class Simulator {
  public:
    /// Makes a run with the machine at its home. Its controller is `module`, made for
    /// setup_of_machine(machine), or our own planner. Throws std::invalid_argument if the planner does not
    /// support the machine.
    Simulator(machine::Machine machine, RunLimits limits, std::optional<rrs::RcsModule> module = {});
    ~Simulator();
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    /// Adds an output, which must outlive the simulator. To be called before the first move.
    void add_output(RunOutput& output) { recorder_.add_output(output); }
    /// Sets the cell of the machine, which was read for it and must outlive the simulator. To be called
    /// before the first move.
    void set_cell(CellWatch& cell);
    /// Sets what probes touch. To be called before the first move. By default they touch the cell or, without
    /// a cell, their targets.
    void set_probe(const ProbeFeels& feels) { probe_feels_ = feels; }
    /// Sets the overrides that the operator selects in the course of the run. To be called before the first
    /// move. Returns false if the controller is a module, which has overrides of its own.
    bool set_overrides(const motion::OverrideSchedule& overrides);
    /// Sets the dynamics, so that the report has the loads of the motors. To be called before the first move.
    void set_dynamics(std::shared_ptr<const dynamics::Dynamics> dynamics);
    /// Returns null if no dynamics were set.
    const dynamics::Dynamics* dynamics() const { return dynamics_.get(); }
    /// Sets an observer, which must outlive the simulator and is notified of the run's requests to its
    /// controller. To be called before the first move.
    void observe_motion(MotionObserver& observer);
    /// Sets an observer of the program's requests in the same manner; one at most.
    void set_observer(ProgramObserver& observer);

    /// Returns the setup of following errors, valid during the lifetime of the simulator; no value if the
    /// machine file does not describe servo loops.
    std::optional<FollowingSetup> following_setup() const;
    const machine::Machine& machine() const { return machine_; }
    /// Returns the axis values at the end of the last move; under TCP control X, Y and Z of the TCP.
    const AxisVector& position() const { return position_; }
    /// Returns the clock after all moves so far; the query brings the machine to a standstill.
    double time_s();
    /// Returns the clock after the planned motion: less than time_s() if moves are pending.
    double planned_s() const { return motion_->time_s(); }
    /// Returns the time up to which the monitors have received the motion; infinite if they have received all
    /// planned motion.
    double passed_on_s() const { return motion_->passed_on_s(); }
    /// Returns the time at which the run ends, if not before.
    double max_time_s() const { return limits_.max_time_s; }
    std::uint64_t max_blocks() const { return limits_.max_blocks; }

    /// Returns the index for Place::file of a file name; adds a new name.
    std::uint32_t add_file(const std::string& name);
    const std::vector<std::string>& files() const { return files_; }
    const ZoneWatch& zones() const { return zones_; }
    /// Returns the cell of the machine; null: no cell.
    CellWatch* cell() const { return cell_; }
    /// Returns the TCPs of the tools of the moves so far (MoveInfo::tip), in the frame of the kinematics'
    /// tool centre point.
    const std::vector<Eigen::Vector3d>& tips_mm() const { return tips_.list_mm(); }
    /// Counts a block; returns false past the limit (status stopped).
    bool count_block(const Place& place);
    /// Returns false if the run has used up its processor time (status stopped).
    bool has_cpu_time(const Place& place);

    bool move(const LineMove& move);
    bool move(const ArcMove& move);
    bool move(const ViaMove& move);
    bool move(const PoseMove& move);
    /// Makes a probing move: the machine comes to a standstill before it, and stops after the signal as fast
    /// as its limits permit.
    bool probe(const ProbeMove& move, ProbeResult& result);
    /// Returns true if a line of the axes between two poses is no line of the tool. PoseMove exists for such
    /// machines.
    bool tip_turns() const { return motion::tip_turns(setup_, work_frames().tip_mm()); }
    /// Sets TCP control (TipFrame) for the moves that follow, with a tool length offset of the linear axes X,
    /// Y and Z in mm; no value: off. The machine comes to a standstill. While it is on, position() and all
    /// targets are coordinates of the TCP.
    bool set_tip_control(const std::optional<Eigen::Vector3d>& offset_mm, const Place& place);
    bool has_tip_control() const { return tip_frame_.has_value(); }
    bool dwell(double seconds, const Place& place);
    /// Dwells for an action that a word of the program has started ([times] of the machine file). It is part
    /// of the program's time but not a programmed dwell, so the observer is not notified. `key`: of the
    /// table.
    bool take_time(double seconds, std::string key, const Place& place);
    /// Sets how the moves that follow pass their ends, and the tolerances (mm; 0: controller's default).
    void set_path_mode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm);
    /// Ends the next move in an exact stop, in any mode.
    void exact_stop_once();
    /// Overrides of the operator that the program locks: the moves that follow run as if those were at 100 %.
    struct OverrideLocks {
        bool feed = false;
        bool rapid = false;
        bool spindle = false;
    };
    void lock_overrides(const OverrideLocks& locks) { locks_ = locks; }
    /// Sets the ramps of the moves that follow; warns if the controller uses its own.
    void set_ramps(rrs::RampMode mode);
    /// Sets a limit of an axis's ramps for the moves that follow, mm or deg, s; > 0. The machine's own limit
    /// applies, too.
    void set_ramp_limit(rrs::RampLimit limit, int axis, double value);
    /// Restores the machine's own limits.
    void reset_ramp_limits();
    /// Limits that a program sets for its path; those that are left out stay as they are.
    struct ProgrammedPathLimits {
        std::optional<double> speed_mm_s;
        std::optional<double> acceleration_mm_s2;
        std::optional<double> square_corner_velocity_mm_s;  ///< For the planner `klipper`, as the next one.
        std::optional<double> minimum_cruise_ratio;
    };
    /// Sets limits for the moves that follow; they replace the machine's.
    void set_path_limits(const ProgrammedPathLimits& limits);
    /// Calls CancelMotion for a client that steps by itself: the program continues from its present position.
    rrs::Status cancel_motion();
    /// Lets the controller wait until all moves have been made, before it reads on.
    void wait();
    /// Sets the speed of the spindle, rev/min, for the moves that follow. Only the observer is notified,
    /// because moves already have their feeds.
    void set_spindle_speed(double rev_min);
    /// Selects a work coordinate system; targets remain machine coordinates. The observer is notified, and
    /// violations name it.
    void select_work_offset(const WorkOffset& offset);
    /// Sets the targets that follow to be in the frame of a conveyor, until untrack(). `direction` is in the
    /// machine's world; the machine's frame and the conveyor's coincide if its travel is 0.
    bool track(const Eigen::Vector3d& direction, double position_mm, double speed_mm_s, const Place& place);
    bool untrack(const Place& place);
    /// Calls SelectTracking for a client that defines its conveyors itself: targets of the program are in the
    /// frame of the conveyor, or no longer.
    rrs::Status select_tracking(int conveyor, bool on);
    /// Time of an event between moves.
    enum class When : std::uint8_t {
        at_rest,      ///< The machine stops for it.
        in_passing,   ///< As the next move or dwell begins, else at the end.
        with_motion,  ///< As the next move begins that is no dwell, else never.
    };
    /// Adds an event that happens after everything before it.
    void event(std::string kind, std::string detail, const Place& place, When when = When::at_rest);
    /// Switches the machine's process (for example its jet) on or off in the moves that follow;
    /// `with_motion`: from the next one on that is no dwell.
    void set_process(bool on, bool with_motion);
    /// Ends the program here, by one of its own words: an active process is switched off.
    void end_program(const Place& place);
    /// Adds a warning to the report; the same text is added once.
    void warn(const std::string& text);
    /// Activates the zones of machine data from time 0 on. To be called before the first move.
    void watch_zones(const machine::MachineData& data);
    /// Switches zones of machine data after the moves so far; returns false if no zone has the number.
    bool switch_zones(int switch_number, bool on) { return zones_.switch_zones(switch_number, on, next_id_); }
    /// Sets the zone of the program after the moves so far (ZoneWatch::set_programmed()).
    void set_programmed_zone(const std::optional<ZoneWalls>& walls) {
        zones_.set_programmed(walls, next_id_);
    }
    /// Sets the distance of the tool's end from the position of X, Y and Z of the machine, for zones and
    /// probes (mm).
    void set_tool_offset(const Eigen::Vector3d& offset_mm);
    /// Records that a program is called, or the last called one has ended: an alarm names the calls that are
    /// open.
    void enter_program(std::string name, const Place& place);
    void leave_program();
    /// Records that the last called program runs once more, by the same call.
    void repeat_program();
    /// Records that the main program has come to the end of a pass.
    void note_passes(const Passes& passes) { passes_ = passes; }
    /// Ends the run with an alarm of the program; always returns false.
    bool fail(text::DiagnosticKind kind, std::string message, const Place& place);
    /// Ends the run because of a limit; always returns false.
    bool stop(text::DiagnosticKind kind, std::string message, const Place& place);

    /// Returns the axis values that bring the tool to a pose in the selected frames (SelectWorkFrames),
    /// nearest to the position of the machine; the error is a message.
    tl::expected<AxisVector, std::string> axes_of(const rrs::CartPos& pose,
                                                  const std::vector<GroupTarget>& groups = {}) const;
    /// Returns how a group of the machine, by its index, moves during moves to poses.
    machine::GroupMotion group_motion(std::size_t group) const { return group_motions_[group]; }
    void set_group_motion(std::size_t group, machine::GroupMotion motion) { group_motions_[group] = motion; }
    /// Moves axes of a group independently, as fast as they can; the machine comes to a standstill before.
    /// Moves that follow do not wait for them, unless they move these axes themselves. One group moves at a
    /// time: another one waits.
    bool move_group(std::size_t group, const std::vector<GroupTarget>& targets, const Place& place);
    /// Dwells until no group moves independently.
    bool wait_for_groups(const Place& place);
    /// Warns if the tool has lost a direction of motion at these axis values, because some joints are
    /// aligned.
    void warn_if_singular(const AxisVector& axes, const Place& place);

    /// Returns the approximate memory that the observer holds of the run so far.
    std::size_t observed_bytes() const { return observer_ == nullptr ? 0 : observer_->held_bytes(); }
    const std::optional<Alarm>& alarm() const { return alarm_; }

    /// Returns the controller's services, for clients that call them by themselves. Selections of these
    /// clients are for their own targets. Moves of the program inherit those that no word of a program sets:
    /// accelerations, the overrides of the services, rules for corners, exact stops and orientation.
    rrs::Shell& shell() { return motion_->shell(); }
    /// Returns true if segments are samples of a motion, not the motion itself.
    bool sampled() const { return motion_->sampled(); }
    /// Returns the joint values (mm or rad) at the last target.
    const rrs::JointPos& joints() const { return motion_->position(); }
    /// Returns the value of a frame of the cell; without a cell the controller's result.
    rrs::Status get_cell_frame(std::string_view name, rrs::CartPos& frame);
    /// Moves a frame of the cell, or one of motion::MachineFrames, at the present point of the program. The
    /// machine comes to a standstill first. The controller moves the machine's own frames; without a cell it
    /// moves all.
    rrs::Status modify_cell_frame(std::string_view name, const rrs::CartPos& frame);
    /// Returns true if the cell has conveyors, so their motion must be set.
    bool has_conveyors() const { return cell_ != nullptr && cell_->has_conveyors(); }
    /// Sets the motion of a conveyor of the cell, by its frame's name, from a time on; in the machine's
    /// world.
    void set_conveyor(std::string_view name, const Eigen::Vector3d& at_mm,
                      const Eigen::Vector3d& velocity_mm_s, double time_s);
    /// Sets the time up to which the conveyor motion set so far is valid: later motion is checked later.
    void know_conveyors_until(double time_s) { cell_->know_until(time_s); }
    /// Sets the position at time 0 by a service; rejected later, because the machine cannot jump.
    rrs::Status set_start(const std::function<rrs::Status()>& set);
    /// Enqueues a target of such a client: `queue` receives its id and calls the service.
    rrs::Status queue_target(MoveKind kind, const Place& place,
                             const std::function<rrs::Status(rrs::TargetId)>& queue);

    /// Finishes all motion and returns the report.
    Report finish(std::string program);

  private:
    std::unique_ptr<MotionSource> make_motion(std::optional<rrs::RcsModule> module);
    void start();
    void watch_interval();
    void add_interval(Report& report) const;
    void limit_by_torque();
    void add_efforts(Report& report) const;
    motion::Move new_move(const MoveInfo& info) const;
    void set_time_of(const Feed& feed, bool rotary, motion::Move& move);
    void warn_of_jerk();
    void follow_servos();
    void add_following(Report& report) const;
    bool takes_ramps();
    template <typename Change>
    void change_ramps(const Change& change);
    bool limits_no_jerk() const;
    rrs::JointPos to_joints(const AxisVector& axes) const;
    AxisVector to_axes(const rrs::JointPos& joints) const;
    tl::expected<rrs::JointPos, std::string> joints_of(const AxisVector& target) const;
    AxisVector position_at(const rrs::JointPos& joints) const;
    Eigen::Vector3d space_point(const AxisVector& axes) const;
    bool rotary_alone(const AxisVector& target) const;
    double feed_per_min(const LineMove& move, bool rotary) const;
    double feed_per_min(const ArcMove& move) const;
    motion::Put put_rest(const AskedRest& rest);
    bool check_feed(const Feed& feed, bool rotary_alone, const Place& place);
    MoveInfo next_move(MoveKind kind, const Place& place, double feed_per_min);
    void obey_overrides(MoveInfo& info, const Feed& feed) const;
    Eigen::Vector3d tool_end(const AxisVector& axes) const;
    bool touches_target(const ProbeMove& move) const;
    bool feels_cell(const ProbeMove& move) const;
    tl::expected<std::unique_ptr<ProbeSignal>, std::string> probe_signal(const ProbeMove& move);
    tl::expected<std::unique_ptr<ProbeSignal>, std::string> cell_signal(bool away);
    bool wait_if_led(const AxisVector& target, const Place& place);
    bool wait_if_led(const PoseMove& move);
    std::vector<motion::LedJoint> led_joints(const std::vector<GroupTarget>& groups) const;
    motion::WorkFrames work_frames() const {
        return motion_->work_frames().value_or(machine_frames_.work_frames());
    }
    bool has_cell() const { return cell_ != nullptr && cell_->use().of_file; }
    bool asks_controller() const { return controller_has_cell_ || !has_cell(); }
    void tip_changed();
    void machine_frame_changed(std::string_view name, const rrs::CartPos& frame);
    tl::expected<TipFrame, std::string> tip_frame_of(const Eigen::Vector3d& offset_mm) const;
    std::unique_ptr<ProbeSignal> plane_signal(const ProbeMove& move);
    std::unique_ptr<ProbeSignal> part_signal(const ProbeMove& move) const;
    bool make_probe_move(const ProbeMove& move, ProbeSignal* signal, ProbeResult& result);
    template <typename Tell>
    bool finish_move(const motion::Put& put, const AxisVector& target, const Place& place, const Tell& tell);
    bool finish_move(const motion::Put& put, const Place& place);
    bool refused(const motion::PlanError& error, const Place& place);
    bool stop_for_time(const Place& place);
    void add_cell_findings(Report& report);
    void open_program(const std::string& name);
    const Place& place_of(const MoveInfo& move) const;
    void fail_under_way(const MoveInfo& move, text::DiagnosticKind kind, std::string message);
    bool fail_in_zone();
    motion::RangeNotes* begin_move();
    motion::Planned check_target(const rrs::JointPos& joints) const;
    bool comes_back(const motion::Excursion& excursion) const;
    Violation violation_of(std::size_t axis, double value, double limit) const;
    void add_violations(const Place& place);
    bool fail_past_range(const StepPastRange& step);
    void add_steps_past_ranges();
    void add_zone_violation(const ZoneHit& hit);
    Violations release_violations();

    machine::Machine machine_;
    RunLimits limits_;
    Recorder recorder_;
    CentripetalWatch centripetal_;
    ShortBrakesWatch short_brakes_;
    CellWatch* cell_ = nullptr;
    bool controller_has_cell_ = false;  ///< Its services know the frames of cell_.
    std::shared_ptr<const dynamics::Dynamics> dynamics_;
    std::optional<EffortWatch> efforts_;
    std::unique_ptr<AxesTimeWatch> axes_time_;          ///< Set if torques limit accelerations.
    std::optional<IntervalWatch> interval_;             ///< For a calibrated machine.
    std::unique_ptr<FollowingWatch> following_;         ///< Set if the machine has servo loops.
    std::vector<std::string> programs_{std::string()};  ///< Names that MoveInfo::program counts.
    std::vector<std::uint16_t> open_programs_;          ///< The innermost last.
    EventLog events_;
    ZoneWatch zones_;
    ProgramObserver* observer_ = nullptr;
    std::optional<WorkOffset> selected_offset_;  ///< As the program has selected it last.
    motion::PlannerSetup setup_;
    motion::MachineFrames machine_frames_;  ///< As the program has set them.
    WayDeviation way_deviation_;
    WaySinks ways_;
    std::unique_ptr<MotionSource> motion_;
    std::array<int, 3> space_axes_;      ///< Index of X, Y and Z; -1 if the machine has no such axis.
    std::optional<TipFrame> tip_frame_;  ///< Under tool-centre-point control, with this offset:
    Eigen::Vector3d tip_offset_mm_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d tool_offset_mm_ = Eigen::Vector3d::Zero();
    ToolTips tips_;
    std::uint16_t tip_ = 0;  ///< In use, of these.
    ProbeFeels probe_feels_;
    std::optional<double> solid_side_;  ///< Side of the probed plane: 1 above it, -1 below; once known.
    AxisVector position_;
    std::vector<machine::GroupMotion>
        group_motions_;                  ///< For the machine's groups, as the program has set them.
    std::vector<std::size_t> own_axes_;  ///< Axes that may be moving independently.
    std::vector<std::string> files_;
    std::vector<std::string> warnings_;
    std::optional<Alarm> alarm_;
    StepRanges steps_;  ///< For a controller module.
    ViolationLog violations_;
    std::vector<Violation> zone_violations_;                ///< For the hits of zones_, in their order.
    std::vector<std::string> work_offsets_{std::string()};  ///< Codes; the first means no offset.
    std::uint16_t work_offset_ = 0;                         ///< In force.
    rrs::JointPos move_start_;                              ///< Start of the move being added.
    std::uint32_t axes_past_ranges_ = 0;                    ///< By targets; bit 0: the first axis.
    OpenCalls calls_;
    RunStatus status_ = RunStatus::completed;
    std::optional<Passes> passes_;
    double words_s_ = 0;  // total dwell of take_time()
    rrs::TargetId next_id_ = 1;
    Place last_place_;  ///< Source location of the last move.
    std::uint64_t blocks_ = 0;
    double warned_feed_mm_s_ = 0;                              ///< Above the machine's.
    std::shared_ptr<const motion::ProgrammedRamps> ramps_;     ///< As the program has set them; null: not.
    std::shared_ptr<const motion::PlannerSetup> path_limits_;  ///< The same of its limits of the path.
    bool process_on_ = false;
    std::uint32_t process_switches_ = 0;
    std::optional<bool> process_with_motion_;  ///< Value from the next move on.
    ProcessWatch process_;
    PathPassing passing_;  ///< As the program has selected it.
    bool exact_stop_once_ = false;
    OverrideLocks locks_;  ///< As the program has set them.
    std::vector<motion::OverrideChange> overrides_;
};

}  // namespace gsim::simulation
