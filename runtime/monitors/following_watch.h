#pragma once

#include <vector>

#include "runtime/monitors/exact_sum.h"
#include "runtime/monitors/following_motion.h"
#include "runtime/monitors/peak_finder.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/following_report.h"

namespace gsim::simulation {

/// Computes the real positions of axes and TCP in a run.
class FollowingWatch : public RunOutput {
  public:
    explicit FollowingWatch(const FollowingSetup& setup, double step_s = dynamics::ServoMotion::kStep_s);

    /// Returns the receiver of the programmed paths.
    motion::WaySink& ways() { return program_; }

    using RunOutput::take;
    void begin(const rrs::JointPos& start) override;
    void take(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// Returns the report, after the end of the run.
    const FollowingReport& report() const { return report_; }

  private:
    void look(double from_s, double to_s);
    void look_at_axis(std::size_t axis, double t_s, double error);
    void look_at_tip(const FollowingInstant& instant);
    void look_at_program(const FollowingInstant& instant);
    const Place& place_at(double t_s) const;
    bool is_rapid() const { return move_.kind == MoveKind::rapid; }
    double error_of(std::size_t axis, double joint_error) const;
    double settled_s(double end_s);

    ProgramWay program_;
    FollowingMotion motion_;
    FollowingReport report_;
    std::vector<PeakFinder> axes_;
    PeakFinder feed_, rapid_, of_program_;
    std::vector<ExactSum> squares_;  // by axis, over time
    MoveInfo move_;                  // in progress,
    double move_s_ = 0;              // since when,
    Place before_;                   // and the location of the one before
};

}  // namespace gsim::simulation
