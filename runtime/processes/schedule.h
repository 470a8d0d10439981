#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/processes/signal_board.h"
#include "runtime/simulator/move.h"

namespace gsim::process {

using ProcessId = std::size_t;

enum class ProcessState : std::uint8_t { ready, waiting, done };

/// Kind of wait of a process for a signal.
enum class WaitKind : std::uint8_t {
    on,          ///< Until it is on.
    off,         ///< Until it is off.
    equals,      ///< Until it has a value.
    rises,       ///< Until it comes on.
    falls,       ///< Until it switches off.
    any_change,  ///< Until any signal changes.
    zone         ///< Until it has a shared zone.
};

struct Wait {
    WaitKind kind = WaitKind::any_change;
    std::string signal = {};               ///< Empty for any_change; of zone the zone's name.
    Value value = false;                   ///< For equals.
    std::optional<double> until_s = {};    ///< When it gives up.
    std::optional<ProcessId> holder = {};  ///< For zone: process that has it.
};

/// Activity on the simulated clock.
struct Process {
    std::string name;
    bool background = false;  ///< The run does not wait for its end.
    double start_s = 0;
    double time_s = 0;  ///< Time of its own clock.
    ProcessState state = ProcessState::ready;
    Wait wait = {};
    bool timed_out = false;                    ///< The last wait was.
    simulation::SourceLocation location = {};  ///< Location of its wait, or its last one.
};

/// Order of the processes: conservative simulation of discrete events. A process continues only if no other
/// one is at an earlier time; of several at the same time the one added first does. A change of a signal
/// wakes, at its time, those that wait for it.
class Schedule {
  public:
    ProcessId add(std::string name, bool background, double start_s,
                  const simulation::SourceLocation& location);

    Process& process(ProcessId id) { return processes_[id]; }
    const Process& process(ProcessId id) const { return processes_[id]; }
    std::size_t size() const { return processes_.size(); }

    /// Returns true if the process, which is ready, may continue at once.
    bool continues(ProcessId id) const { return next() == id; }
    /// Returns the process to continue: nullopt if all but background processes are done, or all of them wait
    /// for something that never comes. A wait that gives up is over then, and its process's clock is at that
    /// time.
    std::optional<ProcessId> activate_next();
    /// Returns the time before which the process does nothing unless another one wakes it; infinity if it is
    /// done.
    double next_action_s(ProcessId id) const;
    /// Returns true if a process that the run waits for has not come to its end.
    bool has_unfinished() const;
    /// Makes the process wait from its time on; it need not if the signal is already so.
    void wait(ProcessId id, Wait wait);
    /// Reports that a signal has changed at `time_s` from `before`: wakes those that wait for it.
    void changed(const std::string& signal, const Value& before, const Value& after, double time_s);
    /// Continues the waiting process at that time.
    void wake(ProcessId id, double time_s);
    void finish(ProcessId id);

    /// Returns processes that wait for each other's zones without end, from this one on: in a ring, or up to
    /// a zone of a process that has ended. Empty if another process can release this one.
    std::vector<ProcessId> deadlocked_from(ProcessId id) const;
    /// Returns the first process that waits for a zone of this one.
    std::optional<ProcessId> find_zone_waiter(ProcessId id) const;
    /// Returns true if one of the waiting processes waits for a zone.
    bool any_waits_for_zone() const;
    /// Returns what each process that is not done waits for, as a list within a message; locations by
    /// `files`.
    std::string waits(const std::vector<std::string>& files) const;
    /// Returns the same for these only.
    std::string waits(const std::vector<std::string>& files, std::span<const ProcessId> of) const;

  private:
    std::optional<ProcessId> next() const;
    static std::optional<double> due_time_s(const Process& process);
    std::string wait_text(const Wait& wait) const;

    std::deque<Process> processes_;
};

/// Returns true if a signal with this value ends the wait without any change.
bool is_met(const Wait& wait, const Value& value);

}  // namespace gsim::process
