#pragma once

#include <string>
#include <string_view>

#include "runtime/processes/signal_board.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/processes/process_robots.h"
#include "runtime/script/processes/process_table.h"

namespace gsim::script {

/// Signals of the processes, and the interrupts that they cause.
class ProcessSignals {
  public:
    /// All must outlive this.
    ProcessSignals(LuaState& lua, ProcessTable& table, const ProcessRobots& robots)
        : lua_(lua), table_(table), robots_(robots) {}

    const process::SignalBoard& board() const { return board_; }
    /// Sets a signal at the time of the running process.
    void set(const std::string& name, const process::Value& value);
    /// Waits for a signal, and returns true to Lua if it came before its time ran out.
    int wait(lua_State* state, process::Wait wait);
    /// Pops the function on top of the stack; it interrupts the running process when the signal comes on.
    /// nil: no interrupt.
    void set_interrupt(lua_State* state, const std::string& name);
    /// Returns true if each line of the process has to be known, because the process can be interrupted or a
    /// conveyor runs through a cell.
    bool needs_line_hook(const LuaProcess& lua_process) const {
        return !lua_process.handlers.empty() || robots_.has_conveyors();
    }

  private:
    LuaState& lua_;
    ProcessTable& table_;
    const ProcessRobots& robots_;
    process::SignalBoard board_;
};

}  // namespace gsim::script
