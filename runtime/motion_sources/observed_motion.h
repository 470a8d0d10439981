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
    void set_obeyed(const motion::ObeyedOverrides& obeyed) override { motion_->set_obeyed(obeyed); }

    motion::Planned start_at(const rrs::JointPos& joints) override;
    motion::Planned check_ramps() const override { return motion_->check_ramps(); }
    motion::Planned check_tip(const std::optional<Eigen::Vector3d>& tip_mm) override {
        return motion_->check_tip(tip_mm);
    }
    motion::Put put(const motion::Move& move) override;
    motion::Put put_until(const motion::Move& move, const motion::StopSearch& search) override;
    motion::Planned put_own(const rrs::JointPos& end) override;
    double own_end_s() const override { return motion_->own_end_s(); }
    motion::Planned put_rest(const AskedRest& rest) override;
    std::vector<std::string> take_remarks() override { return motion_->take_remarks(); }
    void come_to_rest(bool waits) override;
    void end_program() override;

    double time_s() const override { return motion_->time_s(); }
    double passed_on_s() const override { return motion_->passed_on_s(); }
    const rrs::JointPos& position() const override { return motion_->position(); }
    bool sampled() const override { return motion_->sampled(); }
    double cpu_beside_s() const override { return motion_->cpu_beside_s(); }
    std::optional<std::string> fault() const override { return motion_->fault(); }

  private:
    std::unique_ptr<MotionSource> motion_;
    MotionObserver& observer_;
};

}  // namespace gsim::simulation
