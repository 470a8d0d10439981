#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/monitors/multi_robot_monitor.h"
#include "runtime/processes/conveyor.h"
#include "runtime/processes/schedule.h"
#include "runtime/processes/shared_zones.h"
#include "runtime/processes/signal_board.h"
#include "runtime/script/engine/robot_controller.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/lua/source_locator.h"

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
    enum class RunEnd : std::uint8_t {
        completed,
        error,     ///< Error of Lua: on top of the stack of the thread in `fault`.
        deadlock,  ///< `message` lists the waiting processes.
    };
    struct Outcome {
        RunEnd end = RunEnd::completed;
        lua_State* error_thread = nullptr;
        int status = LUA_OK;
        std::string message = {};
        RobotController* controller =
            nullptr;  ///< Controller of the robot of the process that caused it, or the first one.
        simulation::SourceLocation location = {};
    };

    Processes(LuaState& lua, SourceLocator& locations, std::vector<RobotController*> controllers,
              std::vector<process::Conveyor> conveyors);
    Processes(const Processes&) = delete;
    Processes& operator=(const Processes&) = delete;

    /// Sets the monitor that is notified of the time up to which the motion of all robots is known. To be
    /// called before run(); it must outlive this object.
    void set_multi_robot_monitor(simulation::MultiRobotMonitor& monitor);
    /// Sets the zones that processes share. To be called before run().
    void set_zones(const std::vector<process::SharedZone>& zones) { zones_ = process::SharedZones(zones); }
    /// Runs the function on top of the stack as the process "main", and all processes that it starts, to the
    /// end.
    Outcome run(lua_State* state);

    /// Returns the summaries for the report, after run().
    std::vector<simulation::ProcessSummary> summaries() const;
    const process::SignalBoard& signals() const { return signal_board_; }
    const process::SharedZones& zones() const { return zones_; }
    /// Returns true if a process ran in addition to the main one.
    bool several() const { return schedule_.size() > 1; }

    // The following functions are for the running process, by bindings. A function that waits for others
    // yields, so its result must be returned to Lua at once.

    /// Brings the robot of the process to a standstill: the first time at which the process may act on
    /// others.
    void bring_to_standstill(lua_State* state);
    /// Continues when no process is at an earlier time than the running one.
    int join(lua_State* state);
    /// Lets time pass, for its robot as a dwell; then acts as join().
    int wait(lua_State* state, double seconds);
    /// Starts a process with the function on top of the stack, which it pops.
    void start(lua_State* state, std::string name, bool background);
    process::Value value(std::string_view name) const { return signal_board_.get(name); }
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

    RobotController* find_controller(std::string_view name) const;
    std::vector<std::string_view> controller_names() const;
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
    void track(lua_State* state, RobotController& controller, process::Conveyor* conveyor);

  private:
    enum class YieldReason : std::uint8_t { to_join, in_wait, at_block, to_interrupt };
    struct Thread {
        lua_State* state = nullptr;
        int reference = LUA_NOREF;
    };
    /// Lua side of a process.
    struct LuaProcess {
        std::vector<Thread> threads;  ///< The process, and on it the interrupt that it runs.
        YieldReason yield_reason = YieldReason::to_join;
        RobotController* controller = nullptr;  ///< Controller of its robot.
        std::string robot;                      ///< Name of the one that it had last.
        double idle_s = 0;
        std::map<std::string, int, std::less<>> handlers;  ///< References, by signal.
        std::deque<int> pending;                           ///< Handlers that are to run.
    };

    process::Process& now() { return schedule_.process(running_); }
    LuaProcess& lua_process() { return *lua_processes_[running_]; }
    Interpreter& interpreter();
    Thread new_thread(lua_State* from);
    void drop_thread(LuaProcess& lua_process);
    std::optional<Outcome> resume(process::ProcessId id);
    int push_resume_arguments(LuaProcess& lua_process);
    void start_interrupt(LuaProcess& lua_process);
    void finish(process::ProcessId id);
    std::optional<Outcome> find_deadlock(process::ProcessId id);
    void add_idle_time(LuaProcess& lua_process);
    int yield(lua_State* state, YieldReason reason);
    void on_line_hook(lua_State* state, lua_Debug* line);
    void attach(lua_State* state, Interpreter& requested);
    void assign_robot(LuaProcess& lua_process, RobotController* controller);
    void count_join(lua_State* state);
    void notify_zone_holder(std::size_t zone, double time_s);
    void notify_robot_owner(const RobotController* controller);
    Outcome deadlock();
    bool needs_line_hook(const LuaProcess& lua_process) const {
        return !lua_process.handlers.empty() || tracks_conveyors();
    }
    bool tracks_conveyors() const;
    void notify_conveyor(const process::Conveyor& conveyor, double time_s);
    void notify_known_time();
    void notify_known_conveyor_time();

    LuaState& lua_;
    SourceLocator& source_locator_;
    std::vector<RobotController*> controllers_;
    std::vector<process::Conveyor> conveyors_;
    std::map<const RobotController*, const process::Conveyor*> tracked_conveyors_;
    simulation::MultiRobotMonitor* multi_robot_monitor_ = nullptr;
    process::Schedule schedule_;
    process::SignalBoard signal_board_;
    process::SharedZones zones_;
    std::vector<std::unique_ptr<LuaProcess>> lua_processes_;  ///< By process.
    process::ProcessId running_ = 0;
    std::uint64_t joins_ = 0;
};

/// Adds the functions of processes to the table on top of the stack; `processes` must outlive the state.
void add_processes(lua_State* state, Processes& processes, RobotController& controller);

}  // namespace gsim::script
