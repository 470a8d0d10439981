#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"
#include "runtime/motion_sources/module_move_settings.h"
#include "runtime/motion_sources/module_shell.h"
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
class ModuleMotion final : public MotionSource {
  public:
    /// `sink` must outlive this. Steps last the controller's servo period, or 1 ms if it has none. Past
    /// `max_time_s` no more steps are made.
    ModuleMotion(rrs::RcsModule module, const motion::PlannerSetup& setup, double max_time_s,
                 motion::SegmentSink& sink);

    rrs::Shell& shell() override { return shell_; }
    const motion::Selections& selections() const override { return empty_selections_; }
    motion::PlanError last_error() override;
    bool set_cell(motion::CellFrames& /*cell*/) override { return false; }
    std::optional<motion::WorkFrames> work_frames() const override { return std::nullopt; }
    bool set_overrides(std::shared_ptr<const motion::OverrideSchedule>) override { return false; }
    bool set_move_limits(std::shared_ptr<const motion::MoveLimits>) override { return false; }
    void set_enabled_overrides(const motion::EnabledOverrides&) override {}
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
    std::vector<std::string> drain_warnings() override { return settings_.drain_warnings(); }
    void plan_to_standstill(bool waits) override;
    void end_program() override;
    double time_s() const override { return shell_.segments().time_s(); }
    /// Returns infinity, because a step is passed on as it is made.
    double delivered_until_s() const override { return std::numeric_limits<double>::infinity(); }
    const rrs::JointPos& position() const override { return shell_.target(); }
    bool is_sampled() const override { return true; }
    double external_cpu_s() const override { return shell_.cpu_s(); }
    std::optional<std::string> error() const override { return shell_.error(); }

  private:
    motion::PlanError plan_error(rrs::Status status);
    motion::EnqueueResult enqueue_result(rrs::Status status);
    rrs::Status enqueue_move(const motion::Move& move);
    rrs::Status enqueue_move_until(const motion::Move& move, const motion::StopSearch& search);
    void come_to_rest(rrs::RestReason reason);

    motion::PlannerSetup setup_;
    ModuleShell shell_;
    ModuleMoveSettings settings_;
    motion::Selections empty_selections_;
};

}  // namespace gsim::simulation
