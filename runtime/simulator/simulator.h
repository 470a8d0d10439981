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
#include "runtime/monitors/cell_monitor.h"
#include "runtime/monitors/centripetal_monitor.h"
#include "runtime/monitors/confidence_interval_monitor.h"
#include "runtime/monitors/early_braking_monitor.h"
#include "runtime/monitors/effort_monitor.h"
#include "runtime/monitors/following_setup.h"
#include "runtime/monitors/path_deviation_monitor.h"
#include "runtime/monitors/path_sinks.h"
#include "runtime/monitors/process_monitor.h"
#include "runtime/monitors/violation_log.h"
#include "runtime/monitors/zone_monitor.h"
#include "runtime/motion_sources/motion_observer.h"
#include "runtime/motion_sources/motion_source.h"
#include "runtime/motion_sources/step_range_monitor.h"
#include "runtime/report/recorder.h"
#include "runtime/report/report.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/event_log.h"
#include "runtime/simulator/make_planner_setup.h"
#include "runtime/simulator/move.h"
#include "runtime/simulator/open_calls.h"
#include "runtime/simulator/probe.h"
#include "runtime/simulator/probe_signal.h"
#include "runtime/simulator/program_observer.h"
#include "runtime/simulator/run_limits.h"
#include "runtime/simulator/tcp_frame.h"
#include "runtime/simulator/tcp_table.h"

namespace gsim::simulation {

class AxesTimeMonitor;
class FollowingMonitor;

/// Run of one machine: accepts moves, dwells and events in the order of the program, plans them through the
/// services of its controller, and records the result. It does not depend on the language of the program.
///
/// The services that can fail return false; then alarm() has the reason, and the run must end.
class Simulator {
  public:
    /// Makes a run with the machine at its home. Its controller is `module`, made for
    /// make_planner_setup(machine), or our own planner. Throws std::invalid_argument if the planner does not
    /// support the machine.
    Simulator(machine::Machine machine, RunLimits limits, std::optional<rrs::RcsModule> module = {});
    ~Simulator();
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    /// Adds an output, which must outlive the simulator. To be called before the first move.
    void add_output(RunOutput& output) { recorder_.add_output(output); }
    /// Sets the cell of the machine, which was read for it and must outlive the simulator. To be called
    /// before the first move.
    void set_cell(CellMonitor& cell);
    /// Sets what probes touch. To be called before the first move. By default they touch the cell or, without
    /// a cell, their targets.
    void set_probe(const ProbeSurface& surface) { probe_surface_ = surface; }
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
    double delivered_until_s() const { return motion_->delivered_until_s(); }
    /// Returns the time at which the run ends, if not before.
    double max_time_s() const { return limits_.max_time_s; }
    std::uint64_t max_blocks() const { return limits_.max_blocks; }

    /// Returns the index for SourceLocation::file of a file name; adds a new name.
    std::uint32_t add_file(const std::string& name);
    const std::vector<std::string>& files() const { return files_; }
    const ZoneMonitor& zones() const { return zones_; }
    /// Returns the cell of the machine; null: no cell.
    CellMonitor* cell() const { return cell_; }
    /// Returns the TCPs of the tools of the moves so far (MoveInfo::tip), in the frame of the kinematics'
    /// tool centre point.
    const std::vector<Eigen::Vector3d>& tcp_offsets_mm() const { return tcps_.list_mm(); }
    /// Counts a block; returns false past the limit (status stopped).
    bool count_block(const SourceLocation& location);
    /// Returns false if the run has used up its processor time (status stopped).
    bool has_cpu_time(const SourceLocation& location);

    bool move(const LineMove& move);
    bool move(const ArcMove& move);
    bool move(const ViaMove& move);
    bool move(const PoseMove& move);
    /// Makes a probing move: the machine comes to a standstill before it, and stops after the signal as fast
    /// as its limits permit.
    bool probe(const ProbeMove& move, ProbeResult& result);
    /// Returns true if a line of the axes between two poses is no line of the tool. PoseMove exists for such
    /// machines.
    bool rotary_joints_move_tcp() const {
        return motion::rotary_joints_move_tcp(setup_, work_frames().tcp_mm());
    }
    /// Sets TCP control (TcpFrame) for the moves that follow, with a tool length offset of the linear axes X,
    /// Y and Z in mm; no value: off. The machine comes to a standstill. While it is on, position() and all
    /// targets are coordinates of the TCP.
    bool set_tcp_control(const std::optional<Eigen::Vector3d>& offset_mm, const SourceLocation& location);
    bool has_tcp_control() const { return tcp_frame_.has_value(); }
    bool dwell(double seconds, const SourceLocation& location);
    /// Dwells for an action that a word of the program has started ([times] of the machine file). It is part
    /// of the program's time but not a programmed dwell, so the observer is not notified. `key`: of the
    /// table.
    bool dwell_for_word(double seconds, std::string key, const SourceLocation& location);
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
    bool track(const Eigen::Vector3d& direction, double position_mm, double speed_mm_s,
               const SourceLocation& location);
    bool untrack(const SourceLocation& location);
    /// Calls SelectTracking for a client that defines its conveyors itself: targets of the program are in the
    /// frame of the conveyor, or no longer.
    rrs::Status select_tracking(int conveyor, bool on);
    /// Time of an event between moves.
    enum class EventTiming : std::uint8_t {
        at_standstill,  ///< The machine stops for it.
        in_passing,     ///< As the next move or dwell begins, else at the end.
        with_motion,    ///< As the next move begins that is no dwell, else never.
    };
    /// Adds an event that happens after everything before it.
    void event(std::string kind, std::string detail, const SourceLocation& location,
               EventTiming timing = EventTiming::at_standstill);
    /// Switches the machine's process (for example its jet) on or off in the moves that follow;
    /// `with_motion`: from the next one on that is no dwell.
    void set_process(bool on, bool with_motion);
    /// Ends the program here, by one of its own words: an active process is switched off.
    void end_program(const SourceLocation& location);
    /// Adds a warning to the report; the same text is added once.
    void warn(const std::string& text);
    /// Activates the zones of machine data from time 0 on. To be called before the first move.
    void set_zone_data(const machine::MachineData& data);
    /// Switches zones of machine data after the moves so far; returns false if no zone has the number.
    bool switch_zones(int switch_number, bool on) { return zones_.switch_zones(switch_number, on, next_id_); }
    /// Sets the zone of the program after the moves so far (ZoneMonitor::set_programmed()).
    void set_programmed_zone(const std::optional<ZoneWalls>& walls) {
        zones_.set_programmed(walls, next_id_);
    }
    /// Sets the distance of the tool's end from the position of X, Y and Z of the machine, for zones and
    /// probes (mm).
    void set_tool_offset(const Eigen::Vector3d& offset_mm);
    /// Records that a program is called, or the last called one has ended: an alarm names the calls that are
    /// open.
    void enter_program(std::string name, const SourceLocation& location);
    void leave_program();
    /// Records that the last called program runs once more, by the same call.
    void repeat_program();
    /// Records that the main program has come to the end of a pass.
    void set_passes(const Passes& passes) { passes_ = passes; }
    /// Ends the run with an alarm of the program; always returns false.
    bool fail(text::DiagnosticKind kind, std::string message, const SourceLocation& location);
    /// Ends the run because of a limit; always returns false.
    bool stop(text::DiagnosticKind kind, std::string message, const SourceLocation& location);

    /// Returns the axis values that bring the tool to a pose in the selected frames (SelectWorkFrames),
    /// nearest to the position of the machine; the error is a message.
    tl::expected<AxisVector, std::string> solve_axes(const rrs::CartPos& pose,
                                                     const std::vector<GroupTarget>& groups = {}) const;
    /// Returns how a group of the machine, by its index, moves during moves to poses.
    machine::GroupMotion group_motion(std::size_t group) const { return group_motions_[group]; }
    void set_group_motion(std::size_t group, machine::GroupMotion motion) { group_motions_[group] = motion; }
    /// Moves axes of a group independently, as fast as they can; the machine comes to a standstill before.
    /// Moves that follow do not wait for them, unless they move these axes themselves. One group moves at a
    /// time: another one waits.
    bool move_group(std::size_t group, const std::vector<GroupTarget>& targets,
                    const SourceLocation& location);
    /// Dwells until no group moves independently.
    bool wait_for_groups(const SourceLocation& location);
    /// Warns if the tool has lost a direction of motion at these axis values, because some joints are
    /// aligned.
    void warn_if_singular(const AxisVector& axes, const SourceLocation& location);

    /// Returns the approximate memory that the observer holds of the run so far.
    std::size_t observed_bytes() const { return observer_ == nullptr ? 0 : observer_->retained_bytes(); }
    const std::optional<Alarm>& alarm() const { return alarm_; }

    /// Returns the controller's services, for clients that call them by themselves. Selections of these
    /// clients are for their own targets. Moves of the program inherit those that no word of a program sets:
    /// accelerations, the overrides of the services, rules for corners, exact stops and orientation.
    rrs::Shell& shell() { return motion_->shell(); }
    /// Returns true if segments are samples of a motion, not the motion itself.
    bool is_sampled() const { return motion_->is_sampled(); }
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
    void set_conveyors_known_until(double time_s) { cell_->set_known_until(time_s); }
    /// Sets the position at time 0 by a service; rejected later, because the machine cannot jump.
    rrs::Status set_start(const std::function<rrs::Status()>& set);
    /// Enqueues a target of such a client: `queue` receives its id and calls the service.
    rrs::Status queue_target(MoveKind kind, const SourceLocation& location,
                             const std::function<rrs::Status(rrs::TargetId)>& queue);

    /// Finishes all motion and returns the report.
    Report finish(std::string program);

  private:
    std::unique_ptr<MotionSource> make_motion(std::optional<rrs::RcsModule> module);
    void start();
    void start_interval_monitor();
    void add_interval(Report& report) const;
    void apply_torque_limits();
    void add_efforts(Report& report) const;
    motion::Move make_move(const MoveInfo& info) const;
    void set_move_time(const Feed& feed, bool rotary, motion::Move& move);
    void warn_about_jerk();
    void start_following_monitor();
    void add_following(Report& report) const;
    bool supports_ramps();
    template <typename Change>
    void change_ramps(const Change& change);
    bool has_no_jerk_limit() const;
    rrs::JointPos to_joints(const AxisVector& axes) const;
    AxisVector to_axes(const rrs::JointPos& joints) const;
    tl::expected<rrs::JointPos, std::string> solve_joints(const AxisVector& target) const;
    AxisVector position_at(const rrs::JointPos& joints) const;
    Eigen::Vector3d space_point(const AxisVector& axes) const;
    bool is_rotary_only(const AxisVector& target) const;
    double feed_per_min(const LineMove& move, bool rotary) const;
    double feed_per_min(const ArcMove& move) const;
    motion::EnqueueResult enqueue_dwell(const DwellRequest& request);
    bool check_feed(const Feed& feed, bool is_rotary_only, const SourceLocation& location);
    MoveInfo make_move_info(MoveKind kind, const SourceLocation& location, double feed_per_min);
    void apply_override_rules(MoveInfo& info, const Feed& feed) const;
    Eigen::Vector3d tool_end(const AxisVector& axes) const;
    bool ends_at_target(const ProbeMove& move) const;
    bool senses_cell(const ProbeMove& move) const;
    tl::expected<std::unique_ptr<ProbeSignal>, std::string> make_probe_signal(const ProbeMove& move);
    tl::expected<std::unique_ptr<ProbeSignal>, std::string> make_cell_signal(bool away);
    bool wait_if_coordinated(const AxisVector& target, const SourceLocation& location);
    bool wait_if_coordinated(const PoseMove& move);
    std::vector<motion::GroupJoint> coordinated_joints(const std::vector<GroupTarget>& groups) const;
    motion::WorkFrames work_frames() const {
        return motion_->work_frames().value_or(machine_frames_.work_frames());
    }
    bool has_cell() const { return cell_ != nullptr && cell_->use().is_from_file; }
    bool uses_controller_frames() const { return controller_has_cell_ || !has_cell(); }
    void update_tcp();
    void machine_frame_changed(std::string_view name, const rrs::CartPos& frame);
    tl::expected<TcpFrame, std::string> make_tcp_frame(const Eigen::Vector3d& offset_mm) const;
    std::unique_ptr<ProbeSignal> make_plane_signal(const ProbeMove& move);
    std::unique_ptr<ProbeSignal> make_fraction_signal(const ProbeMove& move) const;
    bool make_probe_move(const ProbeMove& move, ProbeSignal* signal, ProbeResult& result);
    template <typename NotifyObserver>
    bool finish_move(const motion::EnqueueResult& enqueue, const AxisVector& target,
                     const SourceLocation& location, const NotifyObserver& notify_observer);
    bool finish_move(const motion::EnqueueResult& enqueue, const SourceLocation& location);
    bool report_plan_error(const motion::PlanError& error, const SourceLocation& location);
    bool stop_for_time(const SourceLocation& location);
    void add_cell_findings(Report& report);
    void open_program(const std::string& name);
    const SourceLocation& source_location(const MoveInfo& move) const;
    void fail_during_motion(const MoveInfo& move, text::DiagnosticKind kind, std::string message);
    bool fail_in_zone();
    motion::OvertravelLog* begin_move();
    motion::PlanResult check_target(const rrs::JointPos& joints) const;
    bool returns_to_range(const motion::Overtravel& overtravel) const;
    Violation make_violation(std::size_t axis, double value, double limit) const;
    void add_violations(const SourceLocation& location);
    bool fail_out_of_range(const RangeExcess& step);
    void add_range_excess_steps();
    void add_zone_violation(const ZoneHit& hit);
    Violations release_violations();

    machine::Machine machine_;
    RunLimits limits_;
    Recorder recorder_;
    CentripetalMonitor centripetal_monitor_;
    EarlyBrakingMonitor early_braking_monitor_;
    CellMonitor* cell_ = nullptr;
    bool controller_has_cell_ = false;  ///< Its services know the frames of cell_.
    std::shared_ptr<const dynamics::Dynamics> dynamics_;
    std::optional<EffortMonitor> efforts_;
    std::unique_ptr<AxesTimeMonitor> axes_time_monitor_;         ///< Set if torques limit accelerations.
    std::optional<ConfidenceIntervalMonitor> interval_monitor_;  ///< For a calibrated machine.
    std::unique_ptr<FollowingMonitor> following_;                ///< Set if the machine has servo loops.
    std::vector<std::string> programs_{std::string()};           ///< Names that MoveInfo::program counts.
    std::vector<std::uint16_t> open_programs_;                   ///< The innermost last.
    EventLog events_;
    ZoneMonitor zones_;
    ProgramObserver* observer_ = nullptr;
    std::optional<WorkOffset> selected_offset_;  ///< As the program has selected it last.
    motion::PlannerSetup setup_;
    motion::MachineFrames machine_frames_;  ///< As the program has set them.
    PathDeviationMonitor path_deviation_monitor_;
    PathSinks path_sinks_;
    std::unique_ptr<MotionSource> motion_;
    std::array<int, 3> space_axes_;      ///< Index of X, Y and Z; -1 if the machine has no such axis.
    std::optional<TcpFrame> tcp_frame_;  ///< Under tool-centre-point control, with this offset:
    Eigen::Vector3d tcp_offset_mm_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d tool_offset_mm_ = Eigen::Vector3d::Zero();
    TcpTable tcps_;
    std::uint16_t tcp_ = 0;  ///< In use, of these.
    ProbeSurface probe_surface_;
    std::optional<double> solid_side_;  ///< Side of the probed plane: 1 above it, -1 below; once known.
    AxisVector position_;
    std::vector<machine::GroupMotion>
        group_motions_;                          ///< For the machine's groups, as the program has set them.
    std::vector<std::size_t> independent_axes_;  ///< Axes that may be moving independently.
    std::vector<std::string> files_;
    std::vector<std::string> warnings_;
    std::optional<Alarm> alarm_;
    StepRangeMonitor steps_;  ///< For a controller module.
    ViolationLog violations_;
    std::vector<Violation> zone_violations_;                ///< For the hits of zones_, in their order.
    std::vector<std::string> work_offsets_{std::string()};  ///< Codes; the first means no offset.
    std::uint16_t work_offset_ = 0;                         ///< In force.
    rrs::JointPos move_start_;                              ///< Start of the move being added.
    std::uint32_t axes_out_of_range_ = 0;                   ///< By targets; bit 0: the first axis.
    OpenCalls calls_;
    RunStatus status_ = RunStatus::completed;
    std::optional<Passes> passes_;
    double words_s_ = 0;  // total dwell of dwell_for_word()
    rrs::TargetId next_id_ = 1;
    SourceLocation last_location_;  ///< Source location of the last move.
    std::uint64_t blocks_ = 0;
    double warned_feed_mm_s_ = 0;                              ///< Above the machine's.
    std::shared_ptr<const motion::ProgrammedRamps> ramps_;     ///< As the program has set them; null: not.
    std::shared_ptr<const motion::PlannerSetup> path_limits_;  ///< The same of its limits of the path.
    bool process_on_ = false;
    std::uint32_t process_switches_ = 0;
    std::optional<bool> process_with_motion_;  ///< Value from the next move on.
    ProcessMonitor process_;
    PathModeSettings path_mode_settings_;  ///< As the program has selected it.
    bool exact_stop_once_ = false;
    OverrideLocks locks_;  ///< As the program has set them.
    std::vector<motion::OverrideChange> overrides_;
};

}  // namespace gsim::simulation
