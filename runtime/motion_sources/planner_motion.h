#pragma once

#include <utility>

#include "motion/services/planner_shell.h"
#include "runtime/motion_sources/motion_source.h"

namespace gsim::simulation {

/// Our own planner, in process.
class PlannerMotion final : public MotionSource {
  public:
    /// `sink` and `ways` must outlive this. Throws std::invalid_argument as motion::Planner does.
    PlannerMotion(motion::PlannerSetup setup, motion::SegmentSink& sink, motion::WaySink& ways)
        : planner_(std::move(setup), &sink), shell_(planner_) {
        planner_.tell_ways(ways);
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
        planner_.set_overrides(std::move(overrides));
        return true;
    }
    bool set_move_limits(std::shared_ptr<const motion::MoveLimits> limits) override {
        planner_.set_move_limits(std::move(limits));
        return true;
    }
    void set_obeyed(const motion::ObeyedOverrides& obeyed) override { shell_.set_obeyed(obeyed); }

    motion::Planned start_at(const rrs::JointPos& joints) override {
        shell_.Initialize();
        return planner_.stand_at({joints, std::nullopt});
    }
    motion::Planned check_ramps() const override { return planner_.check_ramps(); }
    motion::Planned check_tip(const std::optional<Eigen::Vector3d>& tip_mm) override {
        return tip_mm ? planner_.check_tip_control() : motion::Planned();
    }
    motion::Put put(const motion::Move& move) override { return planner_.put(move); }
    motion::Put put_until(const motion::Move& move, const motion::StopSearch& search) override {
        return planner_.put_until(move, search);
    }
    motion::Planned put_own(const rrs::JointPos& end) override { return planner_.put_own(end); }
    double own_end_s() const override { return planner_.own_end_s(); }
    motion::Planned put_rest(const AskedRest& rest) override {
        return planner_.put_rest(rest.target_id, rest.rest_s);
    }
    std::vector<std::string> take_remarks() override { return {}; }
    void come_to_rest(bool waits) override { planner_.come_to_rest(waits); }
    void end_program() override {
        planner_.come_to_last_rest();
        planner_.flush();
    }

    double time_s() const override { return planner_.time_s(); }
    double passed_on_s() const override { return planner_.passed_on_s(); }
    const rrs::JointPos& position() const override { return planner_.position(); }
    bool sampled() const override { return false; }
    std::optional<std::string> fault() const override { return std::nullopt; }

  private:
    motion::Planner planner_;
    motion::PlannerShell shell_;
};

}  // namespace gsim::simulation
