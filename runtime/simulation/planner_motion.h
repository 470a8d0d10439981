#pragma once

#include "runtime/motion/planner.h"
#include "runtime/simulation/motion_source.h"

namespace gsim::simulation {

/// Our own planner, in process.
class PlannerMotion final : public MotionSource {
  public:
    /// `sink` and `ways` must outlive this. Throws std::invalid_argument as DefaultPlanner does.
    PlannerMotion(motion::PlannerSetup setup, motion::SegmentSink& sink, motion::WaySink& ways)
        : planner_(std::move(setup), &sink) {
        planner_.tell_ways(ways);
    }

    rrs::Shell& shell() override { return planner_; }
    bool set_cell(motion::CellFrames& cell) override {
        planner_.set_cell(cell);
        return true;
    }
    std::optional<motion::WorkFrames> work_frames() const override { return planner_.work_frames(); }
    bool set_overrides(std::shared_ptr<const motion::OverrideSchedule> overrides) override {
        planner_.set_overrides(std::move(overrides));
        return true;
    }
    void set_obeyed(const motion::ObeyedOverrides& obeyed) override { planner_.set_obeyed(obeyed); }
    void set_follows_spindle(bool follows) override { planner_.set_follows_spindle(follows); }
    void forget_position_speed() override { planner_.forget_position_speed(); }
    void come_to_rest(bool waits) override { planner_.come_to_rest(waits); }
    rrs::Status put_until(const std::function<rrs::Status()>& put,
                          const motion::StopSearch& search) override {
        return planner_.put_until(put, search);
    }
    void end_program() override { planner_.end_program(); }
    double time_s() const override { return planner_.time_s(); }
    const rrs::JointPos& position() const override { return planner_.position(); }
    motion::PlanError last_error() override { return planner_.last_error(); }
    bool sampled() const override { return false; }
    std::optional<std::string> fault() const override { return std::nullopt; }

  private:
    motion::DefaultPlanner planner_;
};

}  // namespace gsim::simulation
