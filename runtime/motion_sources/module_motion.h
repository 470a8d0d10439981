#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "controller/module/rcs_shell.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"
#include "runtime/motion_sources/motion_source.h"

namespace gsim::simulation {

/// Controller module. Targets are enqueued until it returns RRS_QUEUE_FULL or its motion has to be known.
/// Then it is stepped, and each step of GetNextStep becomes a straight segment at constant speed. So the
/// times at which moves begin and end are right to within a step, and a move shorter than a step may not
/// show. A step belongs to the target that GetTargetOfLastStep returns. For a module without that service it
/// belongs to the oldest target for which RRS_TARGET_REACHED has not come. A step in which no joint moves is
/// a standstill.
///
/// In addition to the errors that RcsShell finds, these are errors: a jump in no time, time that does not
/// advance, ten minutes without motion though no dwell was requested, an empty queue that is reported as
/// full.
class ModuleMotion final : public rrs::RcsShell, public MotionSource {
  public:
    /// `sink` must outlive this. Steps last the controller's servo period, or 1 ms if it has none. Past
    /// `max_time_s` no more steps are made.
    ModuleMotion(rrs::RcsModule module, const motion::PlannerSetup& setup, double max_time_s,
                 motion::SegmentSink& sink);

    rrs::Shell& shell() override { return *this; }
    const motion::Selections& selections() const override { return no_selections_; }
    motion::PlanError last_error() override;
    bool set_cell(motion::CellFrames& /*cell*/) override { return false; }
    std::optional<motion::WorkFrames> work_frames() const override { return std::nullopt; }
    bool set_overrides(std::shared_ptr<const motion::OverrideSchedule>) override { return false; }
    bool set_move_limits(std::shared_ptr<const motion::MoveLimits>) override { return false; }
    void set_obeyed_overrides(const motion::EnabledOverrides&) override {}
    motion::PlanResult start_at(const rrs::JointPos& joints) override;
    motion::PlanResult check_ramps() const override { return {}; }
    motion::PlanResult check_tcp(const std::optional<Eigen::Vector3d>& tcp_mm) override;
    motion::EnqueueResult enqueue(const motion::Move& move) override;
    /// Steps the module until `search` has a result, and then to its stop: it must offer StopMotion and
    /// CancelMotion. The stop is at the end of the step, wherever in it the search wants it.
    motion::EnqueueResult enqueue_until(const motion::Move& move, const motion::StopSearch& search) override;
    motion::PlanResult enqueue_independent(const rrs::JointPos& end) override;
    double independent_end_s() const override { return 0; }
    motion::PlanResult enqueue_dwell(const DwellRequest& request) override;
    std::vector<std::string> drain_remarks() override { return std::exchange(remarks_, {}); }
    void plan_to_standstill(bool waits) override;
    void end_program() override;
    double time_s() const override { return time_s_; }
    /// Returns infinity, because a step is passed on as it is made.
    double delivered_until_s() const override { return std::numeric_limits<double>::infinity(); }
    const rrs::JointPos& position() const override { return target_; }
    bool is_sampled() const override { return true; }
    double external_cpu_s() const override { return cpu_s(); }
    std::optional<std::string> error() const override { return RcsShell::error(); }

    rrs::Status Initialize() override;
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
    rrs::Status SetNextRest(rrs::TargetId id, double dwell_s) override;
    rrs::Status SetRestParameter(double dwell_s) override;
    rrs::Status GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) override;
    rrs::Status SelectMotionType(rrs::MotionType type) override;
    rrs::Status SetRapid(bool on) override;
    rrs::Status SetCartesianPositionSpeed(double speed_mm_s) override;
    rrs::Status SetCartesianOrientationSpeed(double speed_rad_s) override;
    rrs::Status SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) override;

  protected:
    void before_call() override;

  private:
    /// Modes of the one module that both moves of a program and clients of the services select; nullopt:
    /// unknown.
    struct SelectedModes {
        std::optional<rrs::TargetType> target_type;
        std::optional<rrs::MotionType> motion_type;
        std::optional<bool> rapid;
        std::optional<double> position_speed_mm_s;
        std::optional<double> orientation_speed_rad_s;
        bool joint_motion_only = false;  ///< It accepts no lines of joint values: no joints carry the tool.
        std::optional<rrs::JointPos> joint_speeds;
    };

    /// Runs call() for moves of the program.
    template <typename Call>
    auto run_as_program(const Call& call) {
        struct ProgramScope {
            explicit ProgramScope(bool& flag) : flag_(flag), previous_(std::exchange(flag, true)) {}
            ProgramScope(const ProgramScope&) = delete;
            ProgramScope& operator=(const ProgramScope&) = delete;
            ~ProgramScope() { flag_ = previous_; }

          private:
            bool& flag_;
            bool previous_;
        };
        const ProgramScope side(called_by_program_);
        return call();
    }
    motion::PlanError plan_error(rrs::Status status);
    motion::EnqueueResult to_put_result(rrs::Status status);
    rrs::Status send_terms(const motion::Move& move);
    rrs::Status set_move_kind(const motion::Move& move);
    rrs::Status set_move_feed(const motion::MoveParameters& move_parameters);
    rrs::Status set_move_joint_speeds(const motion::Move& move);
    rrs::JointPos move_joint_speeds(const motion::Move& move) const;
    void set_move_blending(const motion::MoveParameters& move_parameters);
    void set_move_ramps(const motion::MoveParameters& move_parameters);
    rrs::Status enqueue_move(const motion::Move& move);
    rrs::Status enqueue_move_until(const motion::Move& move, const motion::StopSearch& search);
    template <typename Call>
    rrs::Status call_with_prefetch(rrs::RcsPrefetch what, const Call& call);
    template <typename Call>
    rrs::Status retry_until_room(const Call& call);
    rrs::Status on_queued(rrs::Status status, rrs::TargetId id, rrs::TargetParam param,
                          const rrs::CartPos& cartesian, const rrs::JointPos& joints);
    rrs::Status step();
    rrs::Status step_to_target();
    rrs::Status stop_here();
    void step_to_end();
    rrs::Status record(rrs::Status status, const rrs::JointPos& joints, double elapsed_s);
    rrs::Status check_progress(bool moved, double elapsed_s);
    rrs::TargetId step_target();
    void fill_segment(const rrs::JointPos& joints, double elapsed_s);
    rrs::JointPos solve_joints(const rrs::CartPos& cartesian, const rrs::JointPos& joints);

    motion::PlannerSetup setup_;
    double step_s_;
    double max_time_s_;
    motion::SegmentSink& sink_;
    motion::Segment segment_;  ///< Segment of the current step.
    rrs::JointPos reached_;    ///< End of the last step.
    rrs::JointPos target_;     ///< The last target.
    rrs::TargetType target_type_ = rrs::TargetType::joint;
    SelectedModes sent_modes_;              ///< By moves, since a client has called.
    motion::Selections client_selections_;  ///< Selections of clients, as far as moves select them, too.
    rrs::JointPos client_joint_speeds_;
    motion::Selections no_selections_;
    bool called_by_program_ = false;     ///< True if a program calls it.
    motion::MoveParameters sent_terms_;  ///< Sent terms: how moves are passed, and their ramps.
    std::vector<std::string> remarks_;
    std::deque<rrs::TargetId>
        pending_targets_;  ///< Targets not reached yet, if the module does not report them.
    bool reports_target_ = true;
    bool has_position_ = false;
    double time_s_ = 0;
    double idle_s_ = 0;                  ///< Since something moved last.
    double requested_dwell_s_ = 0;       ///< Asked for so far.
    std::uint64_t zero_time_steps_ = 0;  ///< Consecutive steps without time.
};

}  // namespace gsim::simulation
