#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "machine/model/machine.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// Monitor for actions that a program should not do with the machine's process (docs/report.md), in bounded
/// memory. Consecutive moves with the same error are one finding.
class ProcessMonitor final : public RunOutput {
  public:
    /// Starts the monitor; it finds no errors if the machine file defines no process. `machine` must outlive
    /// this.
    explicit ProcessMonitor(const machine::Machine& machine);

    /// Reports that a program ends with the process on, before the move with this target id.
    void end_program(rrs::TargetId next, const SourceLocation& location);

    void begin(const rrs::JointPos& start) override { last_end_ = start; }
    void on_move(const RecordedMove& move) override;
    void end(double end_s) override;

    /// Returns all findings by time. Call it once, after the end of the run.
    ProcessFindings release();

  private:
    enum class ProcessError : std::uint8_t { none, rapid, feed };
    /// Feed moves at one height without the process. They lead to the next cut if the process is switched on
    /// at their end. Otherwise they are an error if the program cuts at that height, which is known at the
    /// end.
    struct IdleFeed {
        std::int64_t level_um = 0;
        std::uint32_t switches = 0;
        ProcessFinding finding;
    };
    struct ProgramEnd {
        rrs::TargetId next = 0;
        ProcessFinding finding;
    };

    const machine::ProcessChecks& checks() const { return machine_.process->checks; }
    void add(ProcessFinding finding);
    void begin_violation(ProcessError process_error, const RecordedMove& move, text::DiagnosticKind kind,
                         std::string message);
    void check_rapid(const RecordedMove& move);
    void check_dwell(const RecordedMove& move);
    void check_spindle(const RecordedMove& move);
    void check_level(const RecordedMove& move);
    void end_idle_feed();
    bool moves_in_xy(const RecordedMove& move) const;
    std::optional<std::int64_t> level_um(const RecordedMove& move) const;

    const machine::Machine& machine_;
    std::optional<std::size_t> x_axis_, y_axis_, z_axis_;
    std::string process_;  ///< "jet"
    rrs::JointPos last_end_;
    ProcessError process_error_ = ProcessError::none;  ///< Error of the previous move.
    std::optional<IdleFeed> idle_feed_;                ///< Not ended yet.
    std::set<std::int64_t> cut_levels_um_;             ///< Heights of cutting planes.
    std::vector<IdleFeed> idle_feeds_;
    std::deque<ProgramEnd> ends_;
    ProcessFindings findings_;
};

}  // namespace gsim::simulation
