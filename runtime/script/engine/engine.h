#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "machine/data/machine_data.h"
#include "runtime/script/engine/robot_controller.h"
#include "runtime/script/lua/library.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/lua/script.h"
#include "runtime/script/lua/source_locator.h"
#include "runtime/script/processes/processes.h"
#include "runtime/simulator/simulator.h"

namespace gsim::script {

/// Execution of one script on one or several simulators: the Lua state, a controller for each, the processes,
/// and their connections.
class Engine {
  public:
    struct Options {
        LuaState::Limits limits;
        os::CpuLimit* cpu = nullptr;  ///< For the full run; null: none. It outlives the engine.
        Library library;
        machine::MachineData data;  ///< For the only robot, as
        FindProgram find_program;   ///< this is
        FindProgram find_module;
        std::optional<Script>
            setup;  ///< Runs before the program: user M codes, results of inputs and probes.
        std::string dialect = "ab9";  ///< and this,
        std::vector<CodeRow> codes;   ///< with what its table says,
        double unit_mm = 1;           ///< and the unit of programs when the run begins: 1 or 25.4.
        bool block_delete = false;
        bool optional_stop = false;
        std::uint64_t passes = 1;  ///< For a main program that leads back to its start (M99); at least 1.
        std::function<void(std::uint64_t done, std::uint64_t total)> progress;
        simulation::MultiRobotMonitor* multi_robot_monitor =
            nullptr;                             ///< For several robots; it outlives the engine.
        std::vector<process::SharedZone> zones;  ///< That processes share.
    };

    /// Loads the library. Throws std::runtime_error with a message if that is impossible.
    Engine(simulation::Simulator& simulator, const Options& options);
    /// Serves several robots, at least one: the script has the words of the first one.
    Engine(std::vector<Robot> robots, std::vector<process::Conveyor> conveyors, Options options);

    /// Runs to the end, to an alarm or to a limit; the simulators report what happened. Returns false on an
    /// alarm or a limit.
    bool run(Script script);
    /// Returns the variables that a controller keeps from one run to the next, as they are now. The error is
    /// a message: a run that ended for its memory may leave too little to read them.
    Result<std::map<int, double>> permanent_variables();
    /// Returns the machine data as the controller has them now: work coordinate systems, tools and variables
    /// may differ from those of the start. The error is as above.
    Result<machine::MachineData> machine_data();
    /// Adds results of processes, if more than the main one ran, or of several robots.
    void report(simulation::Report& report) const;
    /// Returns the time in which a robot, by its number from 0, waited for others.
    double idle_s(std::size_t robot) const { return controllers_[robot]->idle_s(); }

  private:
    static constexpr const char* kScriptText = "the text of the script";

    struct BodyExecution;
    struct LoadedScript {
        Script script;
        RobotController* controller = nullptr;  ///< Controller of its words.
        std::uint32_t file = 0;
        std::map<std::uint64_t, std::uint32_t> texts;  ///< Numbers for locations, by the start of the text.
        std::map<std::size_t, int> compiled;           ///< By function: what its only chunk became.
    };

    int call_protected(void (*work)(Engine&));
    void open_controllers();
    void add_core_functions(lua_State* state, RobotController& controller);
    void run_processes();
    bool process_result(int status, lua_State* state, RobotController& controller);
    bool process_outcome(int status);
    Result<void> read_retained(void (*read)(Engine&));
    void read_permanent();
    void read_stored();
    LoadedScript& add_script(lua_State* state, Script script, RobotController& controller);
    void push_script(lua_State* state, LoadedScript& loaded_script);
    void compile(lua_State* state, LoadedScript& loaded_script, const ScriptChunk& chunk);
    std::uint32_t text_number(LoadedScript& loaded_script, std::uint64_t begin, std::uint32_t line);
    void record_error(lua_State* state, int index, int level);
    int run_compiled(lua_State* state, LoadedScript& loaded_script, const ScriptChunk& chunk, int& compiled);
    int run_body(lua_State* state, BodyExecution& execution);
    void run_plain_lines(lua_State* state, LoadedScript& loaded_script, BodyExecution& execution,
                         const ScriptChunk& chunk);

    static int call_work_function(lua_State* state);
    static int handle_error(lua_State* state);
    static int next_script(lua_State* state);
    static int register_functions(lua_State* state);
    static int function_body(lua_State* state);
    static int continue_body(lua_State* state, int status, lua_KContext);
    static int load_program(lua_State* state);
    static int load_module(lua_State* state);
    static int run_to_end(lua_State* state);
    static int finish_run(lua_State* state, int status, lua_KContext context);

    Options options_;
    SourceLocator source_locator_;
    std::vector<std::unique_ptr<RobotController>> controllers_;
    LuaState lua_;
    Processes processes_;
    void (*work_)(Engine&) = nullptr;
    std::vector<std::unique_ptr<LoadedScript>> loaded_scripts_;
    std::map<std::pair<const RobotController*, std::string>, LoadedScript*>
        programs_;                 ///< Files that were called.
    std::vector<Script> pending_;  ///< The last one is loaded first.
    std::optional<Processes::Outcome> outcome_;
    std::map<int, double> permanent_variables_;
    machine::MachineData stored_data_;
    std::string error_;
    simulation::SourceLocation error_location_;
    simulation::SourceLocation last_step_location_;  ///< Location at which a step limit was reached.
};

}  // namespace gsim::script
