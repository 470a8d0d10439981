#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/report/recorder.h"
#include "runtime/report/report.h"
#include "runtime/simulator/open_calls.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/target_ids.h"

namespace gsim::simulation {

/// Calls of programs in a run: those that are open, and the names that moves refer to.
class ProgramCalls {
  public:
    /// Begins in the main program. All arguments must outlive this.
    ProgramCalls(const Recorder& recorder, const TargetIds& ids, const ProgramNotifier& notifier)
        : recorder_(recorder), ids_(ids), notifier_(notifier) {}

    /// Records that a program is called; an alarm names the calls that are open.
    void enter(std::string name, const SourceLocation& location);
    /// Records that the last called program has ended.
    void leave();
    /// Records that the last called program runs once more, by the same call.
    void repeat();
    /// Records that the main program has come to the end of a pass.
    void set_passes(const Passes& passes) { passes_ = passes; }

    /// Returns the calls that are open now, and those at the time of a target.
    const OpenCalls& open() const { return open_; }
    const std::optional<Passes>& passes() const { return passes_; }
    /// Returns the number of the program that runs, for MoveInfo::program.
    std::uint16_t current() const { return numbers_.empty() ? std::uint16_t{0} : numbers_.back(); }
    /// Returns the names of programs by their number; the first one is empty, for the main program.
    const std::vector<std::string>& names() const { return names_; }

  private:
    std::uint16_t number(const std::string& name);

    const Recorder& recorder_;
    const TargetIds& ids_;
    const ProgramNotifier& notifier_;
    OpenCalls open_;
    std::vector<std::string> names_{std::string()};
    std::vector<std::uint16_t> numbers_;  ///< Of the open calls, the innermost last.
    std::optional<Passes> passes_;
};

}  // namespace gsim::simulation
