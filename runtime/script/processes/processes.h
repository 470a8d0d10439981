#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/script/lua/lua_state.h"
#include "runtime/script/lua/source_locator.h"
#include "runtime/script/processes/known_motion.h"
#include "runtime/script/processes/process_conveyors.h"
#include "runtime/script/processes/process_robots.h"
#include "runtime/script/processes/process_signals.h"
#include "runtime/script/processes/process_table.h"
#include "runtime/script/processes/process_zones.h"

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
        error,     ///< Error of Lua: on top of the stack of the thread in `error_thread`.
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
    /// Runs the function on top of the stack as the process "main", and all processes that it starts, to the
    /// end.
    Outcome run(lua_State* state);

    /// Returns the summaries for the report, after run().
    std::vector<simulation::ProcessSummary> summaries() const;
    /// Returns true if a process ran in addition to the main one.
    bool several() const { return table_.size() > 1; }

    // The components and the following functions are for the running process, by bindings. A function that
    // waits for others yields, so its result must be returned to Lua at once.

    const ProcessRobots& robots() const { return robots_; }
    ProcessSignals& signals() { return signals_; }
    const ProcessSignals& signals() const { return signals_; }
    ProcessConveyors& conveyors() { return conveyors_; }
    ProcessZones& zones() { return zones_; }
    const ProcessZones& zones() const { return zones_; }

    /// Continues when no process is at an earlier time than the running one.
    int join(lua_State* state);
    /// Lets time pass, for its robot as a dwell; then acts as join().
    int wait(lua_State* state, double seconds);
    /// Starts a process with the function on top of the stack, which it pops.
    void start(lua_State* state, std::string name, bool background);
    /// Returns the clock of the running process.
    double time_s() const { return table_.running().time_s; }

  private:
    LuaProcess::Thread new_thread(lua_State* from);
    void drop_thread(LuaProcess& lua_process);
    std::optional<Outcome> resume(process::ProcessId id);
    int push_resume_arguments(LuaProcess& lua_process);
    void start_interrupt(LuaProcess& lua_process);
    void finish(process::ProcessId id);
    std::optional<Outcome> find_deadlock(process::ProcessId id);
    Outcome deadlock();
    void on_line_hook(lua_State* state, lua_Debug* line);
    void attach(lua_State* state, const Interpreter& requested);
    void count_join(lua_State* state);

    LuaState& lua_;
    SourceLocator& source_locator_;
    ProcessTable table_;
    ProcessRobots robots_;
    KnownMotion known_motion_;
    ProcessSignals signals_;
    ProcessConveyors conveyors_;
    ProcessZones zones_;
    std::uint64_t joins_ = 0;
};

/// Adds the functions of processes to the table on top of the stack; `processes` must outlive the state.
void add_processes(lua_State* state, Processes& processes, RobotController& controller);

}  // namespace gsim::script
