#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "controller/module/rcs_shell.h"
#include "motion/planner/planner_setup.h"
#include "motion/services/selections.h"
#include "runtime/motion_sources/step_progress.h"
#include "runtime/motion_sources/step_segments.h"
#include "runtime/motion_sources/step_targets.h"

namespace gsim::simulation {

/// Modes of the one module that both moves of a program and clients of the services select; nullopt: unknown.
struct ModuleModes {
    std::optional<rrs::TargetType> target_type;
    std::optional<rrs::MotionType> motion_type;
    std::optional<bool> rapid;
    std::optional<double> position_speed_mm_s;
    std::optional<double> orientation_speed_rad_s;
    bool joint_motion_only = false;  ///< It accepts no lines of joint values: no joints carry the tool.
    std::optional<rrs::JointPos> joint_speeds;
};

/// Services of a controller module that is stepped. Targets are enqueued until it returns RRS_QUEUE_FULL or
/// its motion has to be known. Then each step of GetNextStep becomes a segment.
///
/// Calls are those of a client, except in run_as_program(). Each side has its own modes: before a client
/// calls, selections that moves have made since are undone.
class ModuleShell final : public rrs::RcsShell {
  public:
    /// `sink` must outlive this. Steps last the controller's servo period, or 1 ms if it has none. Past
    /// `max_time_s` no more steps are made.
    ModuleShell(rrs::RcsModule module, const motion::PlannerSetup& setup, double max_time_s,
                motion::SegmentSink& sink);

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
        const ProgramScope scope(called_by_program_);
        return call();
    }
    /// Returns the modes that moves of the program have selected since the last call of a client.
    ModuleModes& move_modes() { return move_modes_; }

    /// Returns the module's message on the last status other than success; it begins with the module's name.
    std::string last_message();

    /// Makes one step. Returns its status, or RRS_MODULE_FAULT.
    rrs::Status step();
    /// Steps until the queue is empty or an error is found.
    void step_to_end();
    /// Stops the motion, steps to the stop, and cancels the targets; the module must offer StopMotion and
    /// CancelMotion. The stop is at the end of the step, wherever in it the search wants it.
    rrs::Status stop_and_cancel();

    /// Returns joint values at the last target.
    const rrs::JointPos& target() const { return target_; }
    const StepSegments& segments() const { return segments_; }

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
    template <typename Call>
    rrs::Status call_with_prefetch(rrs::RcsPrefetch what, const Call& call);
    template <typename Call>
    rrs::Status retry_until_accepted(const Call& call);
    rrs::Status on_queued(rrs::Status status, rrs::TargetId id, rrs::TargetParam param,
                          const rrs::CartPos& cartesian, const rrs::JointPos& joints);
    rrs::Status step_to_target();
    rrs::Status record(rrs::Status status, const rrs::JointPos& joints, double elapsed_s);
    rrs::JointPos solve_joints(const rrs::CartPos& cartesian, const rrs::JointPos& joints);

    double step_s_;
    double max_time_s_;
    StepSegments segments_;
    StepProgress progress_;
    StepTargets targets_;
    rrs::JointPos target_;
    rrs::TargetType target_type_ = rrs::TargetType::joint;
    bool has_position_ = false;
    bool called_by_program_ = false;
    ModuleModes move_modes_;
    motion::Selections client_selections_;  ///< Selections of clients, as far as moves select them, too.
    rrs::JointPos client_joint_speeds_;
};

}  // namespace gsim::simulation
