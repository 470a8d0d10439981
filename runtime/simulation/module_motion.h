#pragma once

#include <cstdint>
#include <deque>

#include "runtime/motion/planner_setup.h"
#include "runtime/motion/segment.h"
#include "runtime/rrs/rcs_shell.h"
#include "runtime/simulation/motion_source.h"

namespace gsim::simulation {

/// A controller module. Targets are put until it answers RRS_QUEUE_FULL or its motion has to be known; then
/// it is stepped, and each step of GetNextStep becomes a straight segment at constant speed. So the times at
/// which moves begin and end are right to within a step, and a move shorter than a step may not show. A step
/// belongs to the target that GetTargetOfLastStep tells; of a module without that service to the oldest
/// target for which RRS_TARGET_REACHED has not come. A step in which no joint moves is a rest.
///
/// Beside the faults that RcsShell finds, these are faults: a jump in no time, time that stands still, ten
/// minutes in which nothing moves though no rest was asked for, a full queue with nothing in it.
class ModuleMotion final : public rrs::RcsShell, public MotionSource {
  public:
    /// `sink` must outlive this. Steps take the controller's servo period, or 1 ms where it has none. Past
    /// `max_time_s` no more steps are taken.
    ModuleMotion(rrs::RcsModule module, const motion::PlannerSetup& setup, double max_time_s,
                 motion::SegmentSink& sink);

    rrs::Shell& shell() override { return *this; }
    bool set_cell(motion::CellFrames& /*cell*/) override { return false; }
    std::optional<motion::WorkFrames> work_frames() const override { return std::nullopt; }
    bool set_overrides(std::shared_ptr<const motion::OverrideSchedule>) override { return false; }
    void set_obeyed(const motion::ObeyedOverrides&) override {}
    void set_follows_spindle(bool) override {}
    void forget_position_speed() override {}
    void come_to_rest(bool waits) override;
    /// The module is stepped until `search` answers, and then to its stop: it has to offer StopMotion and
    /// CancelMotion. The stop is at the end of the step, wherever in it the search wants it.
    rrs::Status put_until(const std::function<rrs::Status()>& put, const motion::StopSearch& search) override;
    void end_program() override;
    double time_s() const override { return time_s_; }
    const rrs::JointPos& position() const override { return target_; }
    motion::PlanError last_error() override;
    bool sampled() const override { return true; }
    std::optional<std::string> fault() const override { return RcsShell::fault(); }

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
    rrs::Status SetNextRest(rrs::TargetId id, double rest_s) override;
    rrs::Status SetRestParameter(double rest_s) override;
    rrs::Status GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) override;

  private:
    template <typename Put>
    rrs::Status put(const Put& call);
    rrs::Status queued(rrs::Status status, rrs::TargetId id, rrs::TargetParam param,
                       const rrs::CartPos& cartesian, const rrs::JointPos& joints);
    rrs::Status step();
    rrs::Status step_to_target();
    rrs::Status stop_here();
    void step_to_end();
    rrs::Status record(rrs::Status status, const rrs::JointPos& joints, double elapsed_s);
    rrs::Status watch(bool moved, double elapsed_s);
    rrs::TargetId target_of_step();
    void fill_segment(const rrs::JointPos& joints, double elapsed_s);
    rrs::JointPos solved(const rrs::CartPos& cartesian, const rrs::JointPos& joints);

    double step_s_;
    double max_time_s_;
    std::array<int, 3> position_joints_;
    motion::SegmentSink& sink_;
    motion::Segment segment_;  ///< Of the step under way.
    rrs::JointPos reached_;    ///< Where the last step ended.
    rrs::JointPos target_;     ///< The last target.
    rrs::TargetType target_type_ = rrs::TargetType::joint;
    std::deque<rrs::TargetId> waiting_;  ///< Targets not reached yet, where the module does not tell.
    bool tells_target_ = true;
    bool has_position_ = false;
    double time_s_ = 0;
    double idle_s_ = 0;           ///< Since something moved last.
    double rests_s_ = 0;          ///< Asked for so far.
    std::uint64_t standing_ = 0;  ///< Steps without time, one behind the other.
};

}  // namespace gsim::simulation
