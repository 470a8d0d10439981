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

/// How a process waits for a signal.
enum class WaitKind : std::uint8_t {
    on,          ///< Until it is on.
    off,         ///< Until it is off.
    equals,      ///< Until it has a value.
    rises,       ///< Until it comes on.
    falls,       ///< Until it goes off.
    any_change,  ///< Until any signal changes.
    zone         ///< Until it has a shared zone.
};

struct Wait {
    WaitKind kind = WaitKind::any_change;
    std::string signal = {};               ///< Empty for any_change; of zone the zone's name.
    Value value = false;                   ///< Of equals.
    std::optional<double> until_s = {};    ///< When it gives up.
    std::optional<ProcessId> holder = {};  ///< Of zone: who has it.
};

/// An activity on the simulated clock.
struct Process {
    std::string name;
    bool background = false;  ///< The run does not wait for its end.
    double start_s = 0;
    double time_s = 0;  ///< Where its own clock stands.
    ProcessState state = ProcessState::ready;
    Wait wait = {};
    bool timed_out = false;        ///< The last wait was.
    simulation::Place place = {};  ///< Where it waits, or stood last.
};

/// Which process goes next: conservative simulation of discrete events. A process goes on only when none is
/// behind it; of several at the same time the one added first does. A change of a signal wakes, at its time,
/// those that wait for it.
class Schedule {
  public:
    ProcessId add(std::string name, bool background, double start_s, const simulation::Place& place);

    Process& process(ProcessId id) { return processes_[id]; }
    const Process& process(ProcessId id) const { return processes_[id]; }
    std::size_t size() const { return processes_.size(); }

    /// Whether the process, which is ready, may go on at once.
    bool goes_on(ProcessId id) const { return next() == id; }
    /// The process to go on: nothing when all but background processes are done, or all of them wait for
    /// what never comes. A wait that gives up is over then, and its process's clock stands at that time.
    std::optional<ProcessId> take_next();
    /// Before that time the process does nothing unless another one wakes it; infinite where it is done.
    double next_act_s(ProcessId id) const;
    /// True where a process that the run waits for has not come to its end.
    bool unfinished() const;
    /// The process waits from its time on; where the signal is so already, it need not.
    void wait(ProcessId id, Wait wait);
    /// A signal has changed at `time_s` from `before`: wakes those that wait for it.
    void changed(const std::string& signal, const Value& before, const Value& after, double time_s);
    /// The process, which waits, goes on at that time.
    void wake(ProcessId id, double time_s);
    void finish(ProcessId id);

    /// Processes that wait for each other's zones and will for ever, from this one on: in a ring, or up to a
    /// zone of a process that has ended. None where somebody can let this one go on.
    std::vector<ProcessId> stuck_from(ProcessId id) const;
    /// The first process that waits for a zone of this one.
    std::optional<ProcessId> waits_for_zone_of(ProcessId id) const;
    /// Whether one of those that wait waits for a zone.
    bool waits_for_zone() const;
    /// What each process that is not done waits for, as a list within a sentence; places by `files`.
    std::string waits(const std::vector<std::string>& files) const;
    /// The same of these alone.
    std::string waits(const std::vector<std::string>& files, std::span<const ProcessId> of) const;

  private:
    std::optional<ProcessId> next() const;
    static std::optional<double> due_s(const Process& process);
    std::string text_of_wait(const Wait& wait) const;

    std::deque<Process> processes_;
};

/// Whether a signal with this value ends the wait without any change.
bool is_met(const Wait& wait, const Value& value);

}  // namespace gsim::process
