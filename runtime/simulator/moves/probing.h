#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "runtime/simulator/commands.h"
#include "runtime/simulator/machine_cell.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/moves/axis_groups.h"
#include "runtime/simulator/moves/move_acceptance.h"
#include "runtime/simulator/moves/move_feeds.h"
#include "runtime/simulator/probe.h"
#include "runtime/simulator/probe_signal.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/range_violations.h"
#include "runtime/simulator/run_clock.h"
#include "runtime/simulator/run_outcome.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Probing moves of a run.
class Probing {
  public:
    /// Sets the run whose moves these are; all arguments must outlive this.
    Probing(MachineMotion& motion, RunClock& clock, ProgramPosition& position, ProgramState& program,
            const MachineCell& cell, RunOutcome& outcome, RangeViolations& ranges, MoveAcceptance& acceptance,
            AxisGroups& groups, MoveFeeds& feeds, Warnings& warnings)
        : motion_(motion),
          clock_(clock),
          position_(position),
          program_(program),
          cell_(cell),
          outcome_(outcome),
          ranges_(ranges),
          acceptance_(acceptance),
          groups_(groups),
          feeds_(feeds),
          warnings_(warnings) {}

    /// Sets what probes touch, before the first move. By default they touch the cell or, without a cell,
    /// their targets.
    void set_surface(const ProbeSurface& surface) { surface_ = surface; }
    /// Makes a probing move: the machine comes to a standstill before it, and stops on the signal as fast as
    /// its limits permit. Returns false if the run has ended.
    bool probe(const ProbeMove& move, ProbeResult& result);

  private:
    using SignalOrError = tl::expected<std::unique_ptr<ProbeSignal>, std::string>;

    Eigen::Vector3d tool_end_position(const AxisVector& axes) const;
    bool ends_at_target(const ProbeMove& move) const;
    bool senses_cell(const ProbeMove& move) const;
    SignalOrError make_signal(const ProbeMove& move);
    SignalOrError make_cell_signal(bool away);
    std::unique_ptr<ProbeSignal> make_plane_signal(const ProbeMove& move);
    std::unique_ptr<ProbeSignal> make_fraction_signal(const ProbeMove& move) const;
    bool make_move(const ProbeMove& move, ProbeSignal* signal, ProbeResult& result);
    bool finish_move(const motion::EnqueueResult& enqueue, LineMove line, bool rotary, bool has_signal);

    MachineMotion& motion_;
    RunClock& clock_;
    ProgramPosition& position_;
    ProgramState& program_;
    const MachineCell& cell_;
    RunOutcome& outcome_;
    RangeViolations& ranges_;
    MoveAcceptance& acceptance_;
    AxisGroups& groups_;
    MoveFeeds& feeds_;
    Warnings& warnings_;
    ProbeSurface surface_;
    std::optional<double> solid_side_;  ///< Side of the probed plane: 1 above it, -1 below; once known.
};

}  // namespace gsim::simulation
