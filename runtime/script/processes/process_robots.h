#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/diagnostic_kind.h"
#include "runtime/script/lua/source_locator.h"
#include "runtime/script/processes/process_table.h"

namespace gsim::script {

/// Robots of a run: which process has which, and their clocks, which follow those of the processes.
class ProcessRobots {
  public:
    /// `table` and `locations` must outlive this; `controllers` has at least one.
    ProcessRobots(ProcessTable& table, SourceLocator& locations, std::vector<RobotController*> controllers)
        : table_(table), source_locator_(locations), controllers_(std::move(controllers)) {}

    const std::vector<RobotController*>& controllers() const { return controllers_; }
    /// Returns the controller of the robot of this name; null if there is none.
    RobotController* find(std::string_view name) const;
    std::vector<std::string_view> names() const;
    /// Returns the controller that has this interpreter.
    RobotController& with_interpreter(const Interpreter& interpreter) const;
    /// Returns the controller of the process's robot, or the first one if it has none.
    RobotController& controller_of(process::ProcessId id) const;
    /// Returns the interpreter of the running process's robot, or of the first one.
    Interpreter& interpreter() const { return controller_of(table_.running_id()).interpreter(); }
    bool has_alarm() const;
    /// Returns true if conveyors run through the cell of a robot.
    bool has_conveyors() const;

    /// Gives the robot to the process; null: it has none from now on.
    static void assign(LuaProcess& lua_process, RobotController* controller);
    /// Permits the words of the running process's robot alone.
    void attach_running() const;
    /// Raises an alarm of the running process if another one has the robot.
    void check_free(lua_State* state, const RobotController& controller) const;
    /// Lets the robot of the running process wait until its clock is that of its process.
    void add_idle_time() const;
    /// Brings the robot of the running process to a standstill: the first time at which the process may act
    /// on others.
    void bring_to_standstill(lua_State* state) const;
    /// Raises an alarm of the running process's robot, or of the first one; does not return.
    [[noreturn]] void alarm(lua_State* state, text::DiagnosticKind kind, const std::string& message) const;

  private:
    ProcessTable& table_;
    SourceLocator& source_locator_;
    std::vector<RobotController*> controllers_;
};

}  // namespace gsim::script
