#pragma once

#include <memory>

#include "runtime/motion_sources/motion_observer.h"
#include "runtime/motion_sources/motion_source.h"

namespace gsim::simulation {

/// Controller with an observer of the requests to it.
class ObservedMotion final : public MotionSource {
  public:
    /// Expects that no motion has been made yet; `observer` must outlive this.
    ObservedMotion(std::unique_ptr<MotionSource> motion, MotionObserver& observer);

    rrs::Shell& shell() override;
    const motion::Selections& selections() const override { return motion_->selections(); }
    motion::PlanError last_error() override { return motion_->last_error(); }
    bool set_cell(motion::CellFrames& cell) override { return motion_->set_cell(cell); }
    std::optional<motion::WorkFrames> work_frames() const override { return motion_->work_frames(); }
    bool set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) override;
    bool set_move_limits(std::shared_ptr<const motion::MoveLimits> limits) override {
        return motion_->set_move_limits(std::move(limits));
    }
    void set_enabled_overrides(const motion::EnabledOverrides& enabled_overrides) override {
        motion_->set_enabled_overrides(enabled_overrides);
    }

    motion::PlanResult start_at(const rrs::JointPos& joints) override;
    motion::PlanResult check_ramps() const override { return motion_->check_ramps(); }
    motion::PlanResult check_tcp(const std::optional<Eigen::Vector3d>& tcp_mm) override {
        return motion_->check_tcp(tcp_mm);
    }
    motion::EnqueueResult enqueue(const motion::Move& move) override;
    motion::EnqueueResult enqueue_until(const motion::Move& move, const motion::StopSearch& search) override;
    motion::PlanResult enqueue_independent(const rrs::JointPos& end) override;
    double independent_end_s() const override { return motion_->independent_end_s(); }
    motion::PlanResult enqueue_dwell(const DwellRequest& request) override;
    std::vector<std::string> drain_warnings() override { return motion_->drain_warnings(); }
    void plan_to_standstill(bool waits) override;
    void end_program() override;

    double time_s() const override { return motion_->time_s(); }
    double delivered_until_s() const override { return motion_->delivered_until_s(); }
    const rrs::JointPos& position() const override { return motion_->position(); }
    bool is_sampled() const override { return motion_->is_sampled(); }
    double external_cpu_s() const override { return motion_->external_cpu_s(); }
    std::optional<std::string> error() const override { return motion_->error(); }

  private:
    std::unique_ptr<MotionSource> motion_;
    MotionObserver& observer_;
};

}  // namespace gsim::simulation
