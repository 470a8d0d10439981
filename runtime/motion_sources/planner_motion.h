#pragma once

#include <utility>

#include "motion/services/planner_shell.h"
#include "runtime/motion_sources/motion_source.h"

namespace gsim::simulation {

/// Our own planner, in process.
class PlannerMotion final : public MotionSource {
  public:
    /// `sink` and `path_sink` must outlive this. Throws std::invalid_argument as motion::Planner does.
    PlannerMotion(motion::PlannerSetup setup, motion::SegmentSink& sink, motion::PathSink& path_sink)
        : planner_(std::move(setup), &sink), shell_(planner_) {
        planner_.buffered_moves().set_path_sink(path_sink);
    }

    rrs::Shell& shell() override { return shell_; }
    const motion::Selections& selections() const override { return shell_.selections(); }
    motion::PlanError last_error() override { return shell_.last_error(); }

    bool set_cell(motion::CellFrames& cell) override {
        shell_.set_cell(cell);
        return true;
    }
    std::optional<motion::WorkFrames> work_frames() const override { return selections().frames; }
    bool set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) override {
        planner_.machine().set_overrides(std::move(overrides));
        return true;
    }
    bool set_move_limits(std::shared_ptr<const motion::MoveLimits> limits) override {
        planner_.machine().set_move_limits(std::move(limits));
        return true;
    }
    void set_enabled_overrides(const motion::EnabledOverrides& enabled_overrides) override {
        shell_.set_enabled_overrides(enabled_overrides);
    }

    motion::PlanResult start_at(const rrs::JointPos& joints) override {
        shell_.Initialize();
        return planner_.set_position({joints, std::nullopt});
    }
    motion::PlanResult check_ramps() const override { return planner_.machine().check_ramps(); }
    motion::PlanResult check_tcp(const std::optional<Eigen::Vector3d>& tcp_mm) override {
        return tcp_mm ? planner_.machine().check_tcp_control() : motion::PlanResult();
    }
    motion::EnqueueResult enqueue(const motion::Move& move) override { return planner_.enqueue(move); }
    motion::EnqueueResult enqueue_until(const motion::Move& move, const motion::StopSearch& search) override {
        return planner_.enqueue_until(move, search);
    }
    motion::PlanResult enqueue_independent(const rrs::JointPos& end) override {
        return planner_.independent_moves().enqueue(end);
    }
    double independent_end_s() const override { return planner_.independent_moves().end_s(); }
    motion::PlanResult enqueue_dwell(const DwellRequest& request) override {
        return planner_.dwells().enqueue(request.target_id, request.dwell_s);
    }
    std::vector<std::string> drain_warnings() override { return {}; }
    void plan_to_standstill(bool waits) override { planner_.dwells().plan_to_standstill(waits); }
    void end_program() override {
        planner_.dwells().plan_to_final_standstill();
        planner_.flush();
    }

    double time_s() const override { return planner_.time_s(); }
    double delivered_until_s() const override { return planner_.timeline().delivered_until_s(); }
    const rrs::JointPos& position() const override { return planner_.position(); }
    bool is_sampled() const override { return false; }
    std::optional<std::string> error() const override { return std::nullopt; }

  private:
    motion::Planner planner_;
    motion::PlannerShell shell_;
};

}  // namespace gsim::simulation
