#pragma once

#include <vector>

#include "runtime/monitors/compensated_sum.h"
#include "runtime/monitors/following_motion.h"
#include "runtime/monitors/peak_finder.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/following_report.h"

namespace gsim::simulation {

/// Computes the real positions of axes and TCP in a run.
class FollowingErrorMonitor : public RunOutput {
  public:
    explicit FollowingErrorMonitor(const FollowingSetup& setup,
                                   double step_s = dynamics::ServoMotion::kStep_s);

    /// Returns the receiver of the programmed paths.
    motion::PathSink& path_sink() { return program_; }

    void begin(const rrs::JointPos& start) override;
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// Returns the report, after the end of the run.
    const FollowingReport& report() const { return report_; }

  private:
    void inspect_step(double from_s, double to_s);
    void inspect_axis(std::size_t axis, double t_s, double error);
    void inspect_tcp(const FollowingInstant& instant);
    void inspect_program(const FollowingInstant& instant);
    const SourceLocation& location_at(double t_s) const;
    bool is_rapid() const { return move_.kind == MoveKind::rapid; }
    double axis_error(std::size_t axis, double joint_error) const;
    double settling_time_s(double end_s);

    ProgrammedPath program_;
    FollowingMotion motion_;
    FollowingReport report_;
    std::vector<PeakFinder> axes_;
    PeakFinder feed_, rapid_, program_peak_;
    std::vector<CompensatedSum> squared_errors_;  // by axis, over time
    MoveInfo move_;                               // in progress,
    double move_start_s_ = 0;                     // since when,
    SourceLocation previous_location_;            // and the location of the one before
};

}  // namespace gsim::simulation
