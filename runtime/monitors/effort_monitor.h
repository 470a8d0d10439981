#pragma once

#include <array>
#include <memory>
#include <vector>

#include "machine/model/machine.h"
#include "motion/dynamics/segment_efforts.h"
#include "runtime/monitors/compensated_sum.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/effort_report.h"

namespace gsim::simulation {

/// Returns the speed of a joint (mm/s or rad/s) as its axis counts it, in either direction: mm/s or deg/s.
double axis_speed(const machine::Axis& axis, double joint_speed);
/// Returns the max effort of an axis motor at a speed (mm/s or deg/s), in either direction.
double motor_peak(const machine::Drive& drive, double speed);

/// Computes the efforts of a run's motors: for each segment from its closed forms, and the impulses at jumps
/// of speed between segments, or at a segment's own ends. No finite force is enough for such a jump. So it
/// counts as work and as an impulse, not as force or power. The speed of a joint is assumed to change evenly,
/// so that the work of all impulses is the change of kinetic energy.
class EffortMonitor : public RunOutput {
  public:
    /// Both must outlive this.
    EffortMonitor(const machine::Machine& machine, const dynamics::Dynamics& dynamics);

    void begin(const rrs::JointPos& start) override;
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;
    void end(double end_s) override;

    /// Returns the report, after the end of the run. `programs` are the names that MoveInfo::program counts.
    EffortReport report(const std::vector<std::string>& programs) const;

  private:
    struct Sums {
        CompensatedSum squares, drive_j, regenerated_j, friction_j;
    };
    struct Program {
        std::uint16_t program;
        CompensatedSum time_s, drive_j, regenerated_j;
    };

    void inspect_sample(const dynamics::EffortSample& sample, double start_s, const SourceLocation& location);
    void check_motor(std::size_t axis, const dynamics::EffortSample& sample, double start_s);
    double acceleration_share(std::size_t axis, const dynamics::EffortSample& sample, double limit) const;
    void jump(const rrs::JointPos& position, const rrs::JointPos& to, Program& program,
              const SourceLocation& location);
    void end_move();
    Program& program_entry(std::uint16_t program);
    void add_rms_excesses(EffortReport& report) const;

    const machine::Machine& machine_;
    const dynamics::Dynamics& dynamics_;
    dynamics::SegmentEfforts segments_;
    EffortReport report_;
    std::vector<Sums> sums_;  // by axis
    std::vector<Program> programs_;
    rrs::JointPos at_;
    rrs::JointPos velocity_;                    // at the end of the last segment
    MoveInfo move_;                             // with segments that are arriving
    std::vector<EffortExcess> worst_excesses_;  // of that move by axis; a limit of 0 means none
    double end_s_ = 0;
    double time_s_ = 0;  // of all segments
};

}  // namespace gsim::simulation
