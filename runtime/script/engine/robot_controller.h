#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <lua.hpp>
#include <tl/expected.hpp>

#include "machine/data/machine_data.h"
#include "runtime/script/lua/interpreter.h"
#include "runtime/script/lua/library.h"
#include "runtime/script/lua/script.h"

namespace gsim::script {

/// Robot of a run: the simulator of its machine, and the input of its controller.
struct Robot {
    std::string name;  ///< Empty for the only one of a run without a file of robots.
    simulation::Simulator& simulator;
    std::string dialect = "ab9";
    std::vector<CodeRow> codes;  ///< Codes of the dialect.
    double unit_mm = 1;          ///< Program unit when the run begins: 1, or 25.4 for inches.
    machine::MachineData data;
    FindProgram find_program;                      ///< For programs that are called and not in the script.
    FindProgram find_module;                       ///< For what scripts require outside the library.
    rrs::CartPos base = rrs::CartPos::Identity();  ///< Pose of the machine's world in that of the conveyors.
};

/// Controller of one robot: the library in Lua, loaded for it alone, with its C++ base. Scripts see its
/// environment.
class RobotController {
  public:
    struct ProgramOptions {
        bool block_delete = false;
        bool optional_stop = false;
        std::uint64_t passes = 1;  ///< For a main program that leads back to its start.
    };
    /// Function that adds functions to the table `core` of the library, which is on top of the stack.
    using AddCore = std::function<void(lua_State*, RobotController&)>;

    RobotController(Robot robot, SourceLocator& locations)
        : robot_(std::move(robot)), interpreter_(robot_.simulator, locations) {}
    RobotController(const RobotController&) = delete;
    RobotController& operator=(const RobotController&) = delete;

    /// Loads the library. Errors are those of Lua, or std::runtime_error.
    void open(lua_State* state, const Library& library, const ProgramOptions& switches,
              const AddCore& add_core);

    const std::string& name() const { return robot_.name; }
    const std::string& dialect() const { return robot_.dialect; }
    const FindProgram& find_program() const { return robot_.find_program; }
    const FindProgram& find_module() const { return robot_.find_module; }
    Interpreter& interpreter() { return interpreter_; }
    simulation::Simulator& simulator() { return robot_.simulator; }
    const rrs::CartPos& base() const { return robot_.base; }
    /// Returns the time in which the robot has waited for others.
    double idle_s() const { return idle_s_; }
    void add_idle_seconds(double seconds) { idle_s_ += seconds; }

    /// Pushes what its scripts see.
    void push_environment(lua_State* state) const;
    /// Pushes the function of the library for running programs that has this name: lua_lib/init.lua returns
    /// it.
    void push_library(lua_State* state, const char* name) const;
    /// Passes everything that filters of the path buffer to the machine.
    void flush(lua_State* state) const;

  private:
    std::string prefix() const;
    void set_options(lua_State* state, const ProgramOptions& switches) const;
    void make_read_only(lua_State* state);
    void push_module(lua_State* state, const std::string& name);
    void load_module(lua_State* state, const std::string& name);
    static int use_module(lua_State* state);
    static int push_loading_module(lua_State* state);

    Robot robot_;
    Interpreter interpreter_;
    const Library* files_ = nullptr;
    double idle_s_ = 0;
    int environment_ = LUA_NOREF;       ///< Environment of scripts.
    int library_ = LUA_NOREF;           ///< Environment of the library's files.
    int modules_ = LUA_NOREF;           ///< Result of each file of the library, by its name.
    std::vector<std::string> loading_;  ///< Files that have begun to load, each needed by the one before.
};

/// Compiles a text and gives it the environment on top of the stack, which the function replaces; or raises
/// an error.
void load_text(lua_State* state, const std::string& text, const char* name);

}  // namespace gsim::script
