#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/monitors/robots_watch.h"
#include "runtime/processes/conveyor.h"
#include "runtime/processes/schedule.h"
#include "runtime/processes/shared_zones.h"
#include "runtime/processes/signal_board.h"
#include "runtime/script/engine/control.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/lua/place_finder.h"

namespace gsim::script {

/// Processes of a run, each a coroutine of Lua. The class starts them, continues them in the order of the
/// schedule, and moves the clocks of the robots along with theirs. docs/processes.md has the rules.
///
/// A robot belongs to the process that calls its words, until that process ends or calls the words of another
/// robot. This class sets the hook of the interpreters for words of robots that the running process does not
/// have.
class Processes {
  public:
    /// Result of run().
    enum class End : std::uint8_t {
        completed,
        error,     ///< Error of Lua: on top of the stack of the thread in `fault`.
        deadlock,  ///< `message` lists the waiting processes.
    };
    struct Outcome {
        End end = End::completed;
        lua_State* fault = nullptr;
        int status = LUA_OK;
        std::string message = {};
        Control* control =
            nullptr;  ///< Controller of the robot of the process that caused it, or the first one.
        simulation::Place place = {};
    };

    Processes(LuaState& lua, PlaceFinder& places, std::vector<Control*> controls,
              std::vector<process::Conveyor> conveyors);
    Processes(const Processes&) = delete;
    Processes& operator=(const Processes&) = delete;

    /// Sets the monitor that is notified of the time up to which the motion of all robots is known. To be
    /// called before run(); it must outlive this object.
    void watch_robots(simulation::RobotsWatch& watch);
    /// Sets the zones that processes share. To be called before run().
    void share_zones(const std::vector<process::SharedZone>& zones) { zones_ = process::SharedZones(zones); }
    /// Runs the function on top of the stack as the process "main", and all processes that it starts, to the
    /// end.
    Outcome run(lua_State* state);

    /// Returns the summaries for the report, after run().
    std::vector<simulation::ProcessSummary> summaries() const;
    const process::SignalBoard& signals() const { return board_; }
    const process::SharedZones& zones() const { return zones_; }
    /// Returns true if a process ran in addition to the main one.
    bool several() const { return schedule_.size() > 1; }

    // The following functions are for the running process, by bindings. A function that waits for others
    // yields, so its result must be returned to Lua at once.

    /// Brings the robot of the process to a standstill: the first time at which the process may act on
    /// others.
    void rest(lua_State* state);
    /// Continues when no process is at an earlier time than the running one.
    int join(lua_State* state);
    /// Lets time pass, for its robot as a dwell; then acts as join().
    int wait(lua_State* state, double seconds);
    /// Starts a process with the function on top of the stack, which it pops.
    void start(lua_State* state, std::string name, bool background);
    process::Value value(std::string_view name) const { return board_.get(name); }
    void set_signal(const std::string& name, const process::Value& value);
    /// Waits for a signal, and returns true to Lua if it came before its time ran out.
    int wait_signal(lua_State* state, process::Wait wait);
    /// Pops the function on top of the stack; it interrupts the process when the signal comes on. nil: no
    /// interrupt.
    void on_signal(lua_State* state, const std::string& name);
    /// Returns the clock of the running process.
    double time_s() const { return schedule_.process(running_).time_s; }
    /// Raises an alarm of the running process's robot, or of the first one; does not return.
    [[noreturn]] void alarm(lua_State* state, text::DiagnosticKind kind, const std::string& message);

    Control* find_control(std::string_view name) const;
    std::vector<std::string_view> control_names() const;
    process::Conveyor* find_conveyor(std::string_view name);
    std::vector<process::Conveyor>& conveyors() { return conveyors_; }
    /// Sets the speed of a belt, from the process's time on.
    void set_conveyor_speed(lua_State* state, process::Conveyor& conveyor, double speed_mm_s);
    /// Waits until the running process has the zone, which it does not have yet.
    int enter_zone(lua_State* state, std::size_t zone);
    /// Releases the zone, which it has.
    void leave_zone(std::size_t zone);
    bool has_zone(std::size_t zone) const { return zones_.holder(zone) == running_; }
    /// Sets the targets of this robot that follow to be in the frame of a conveyor; null: no conveyor.
    void track(lua_State* state, Control& control, process::Conveyor* conveyor);

  private:
    enum class Yielded : std::uint8_t { to_join, in_wait, at_block, to_interrupt };
    struct Thread {
        lua_State* state = nullptr;
        int reference = LUA_NOREF;
    };
    /// Lua side of a process.
    struct Strand {
        std::vector<Thread> threads;  ///< The process, and on it the interrupt that it runs.
        Yielded yielded = Yielded::to_join;
        Control* control = nullptr;  ///< Controller of its robot.
        std::string robot;           ///< Name of the one that it had last.
        double idle_s = 0;
        std::map<std::string, int, std::less<>> handlers;  ///< References, by signal.
        std::deque<int> pending;                           ///< Handlers that are to run.
    };

    process::Process& now() { return schedule_.process(running_); }
    Strand& strand() { return *strands_[running_]; }
    Interpreter& interpreter();
    Thread new_thread(lua_State* from);
    void drop_thread(Strand& strand);
    std::optional<Outcome> go_on(process::ProcessId id);
    int arguments_for(Strand& strand);
    void start_interrupt(Strand& strand);
    void finish(process::ProcessId id);
    std::optional<Outcome> stuck_behind(process::ProcessId id);
    void stand_idle(Strand& strand);
    int yield(lua_State* state, Yielded how);
    void at_line(lua_State* state, lua_Debug* line);
    void attach(lua_State* state, Interpreter& wanted);
    void take(Strand& strand, Control* control);
    void count_join(lua_State* state);
    void tell_holder(std::size_t zone, double time_s);
    void tell_owner(const Control* control);
    Outcome deadlock();
    bool watches_lines(const Strand& strand) const { return !strand.handlers.empty() || follows_conveyors(); }
    bool follows_conveyors() const;
    void tell_conveyor(const process::Conveyor& conveyor, double time_s);
    void tell_known_time();
    void tell_known_time_of_conveyors();

    LuaState& lua_;
    PlaceFinder& places_;
    std::vector<Control*> controls_;
    std::vector<process::Conveyor> conveyors_;
    std::map<const Control*, const process::Conveyor*> tracked_;
    simulation::RobotsWatch* robots_watch_ = nullptr;
    process::Schedule schedule_;
    process::SignalBoard board_;
    process::SharedZones zones_;
    std::vector<std::unique_ptr<Strand>> strands_;  ///< By process.
    process::ProcessId running_ = 0;
    std::uint64_t joins_ = 0;
};

/// Adds the functions of processes to the table on top of the stack; `processes` must outlive the state.
void add_processes(lua_State* state, Processes& processes, Control& control);

}  // namespace gsim::script
