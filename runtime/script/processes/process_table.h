#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <lua.hpp>

#include "runtime/processes/schedule.h"
#include "runtime/script/engine/robot_controller.h"

namespace gsim::script {

/// Reason why a process has yielded.
enum class YieldReason : std::uint8_t { to_join, in_wait, at_block, to_interrupt };

/// Lua side of a process.
struct LuaProcess {
    struct Thread {
        lua_State* state = nullptr;
        int reference = LUA_NOREF;
    };

    std::vector<Thread> threads;  ///< The process, and on it the interrupt that it runs.
    YieldReason yield_reason = YieldReason::to_join;
    RobotController* controller = nullptr;  ///< Controller of its robot.
    std::string robot;                      ///< Name of the one that it had last.
    double idle_s = 0;
    std::map<std::string, int, std::less<>> handlers;  ///< References, by signal.
    std::deque<int> pending;                           ///< Handlers that are to run.
};

/// Processes of a run with their Lua sides, and which of them is running.
class ProcessTable {
  public:
    /// Adds a process that is not started yet. Returns its Lua side.
    LuaProcess& add(std::string name, bool background, double start_s,
                    const simulation::SourceLocation& location) {
        schedule_.add(std::move(name), background, start_s, location);
        return *lua_processes_.emplace_back(std::make_unique<LuaProcess>());
    }
    std::size_t size() const { return lua_processes_.size(); }

    process::Schedule& schedule() { return schedule_; }
    const process::Schedule& schedule() const { return schedule_; }
    LuaProcess& lua_process(process::ProcessId id) { return *lua_processes_[id]; }
    const LuaProcess& lua_process(process::ProcessId id) const { return *lua_processes_[id]; }

    process::ProcessId running_id() const { return running_; }
    void set_running(process::ProcessId id) { running_ = id; }
    /// Returns the running process.
    process::Process& running() { return schedule_.process(running_); }
    const process::Process& running() const { return schedule_.process(running_); }
    LuaProcess& running_lua() { return *lua_processes_[running_]; }

    /// Makes the running process yield; the result must be returned to Lua at once.
    int yield(lua_State* state, YieldReason reason) {
        running_lua().yield_reason = reason;
        return lua_yield(state, 0);
    }

  private:
    process::Schedule schedule_;
    std::vector<std::unique_ptr<LuaProcess>> lua_processes_;  ///< By process.
    process::ProcessId running_ = 0;
};

}  // namespace gsim::script
