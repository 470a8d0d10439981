#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/machine/machine_data.h"
#include "runtime/script/controller.h"
#include "runtime/script/library.h"
#include "runtime/script/lua_state.h"
#include "runtime/script/place_finder.h"
#include "runtime/simulation/simulator.h"

namespace gsim::script {

/// A stretch of a program's Lua that can be compiled and run by itself.
struct ScriptChunk {
    std::uint64_t begin = 0;  ///< Bytes [begin, end) of the text.
    std::uint64_t end = 0;
    std::uint32_t line = 1;  ///< Line of the Lua on which it begins.
};

/// One function of a long script, to be run chunk by chunk.
struct ScriptFunction {
    std::string head;  ///< The call in Lua that takes it, up to it: `program(12, `.
    std::vector<ScriptChunk> chunks;
};

/// The Lua that is run, as a whole or, where `functions` is not empty, in pieces, so that memory does not
/// grow with it. `read` gives bytes [begin, end) of it.
struct Script {
    std::string dialect = "ab9";  ///< Whose words it calls: "ab9" or "rs274ngc".
    std::string file_name;  ///< For places: of the G-code where lines are known to match, else of the Lua.
    std::int64_t line_difference =
        0;  ///< Line in that file minus line in the Lua: -1 for unedited generated Lua.
    std::uint64_t size = 0;
    std::function<std::string(std::uint64_t begin, std::uint64_t end)> read;
    std::vector<ScriptFunction> functions;

    static Script from_text(std::string text, std::string file_name, std::int64_t line_difference);
};

/// Finds a program that is called, by number ("12") or name, and is not in the script: the Lua of its file,
/// no value if there is no such file, or a sentence that says what is wrong with it.
using FindProgram = std::function<tl::expected<std::optional<Script>, std::string>(const std::string& name)>;

/// Runs one script on one simulator: the Lua state, the library and what joins them.
class Engine {
  public:
    struct Options {
        LuaState::Limits limits;
        Library library;
        machine::MachineData data;
        FindProgram find_program;
        std::optional<Script>
            setup;  ///< Runs before the program: user M codes, answers of inputs and probes.
        std::string dialect = "ab9";  ///< Of all scripts of the run.
        bool block_delete = false;
        bool optional_stop = false;
        std::function<void(std::uint64_t done, std::uint64_t total)> progress;
    };

    /// Loads the library. Throws std::runtime_error with a sentence where that cannot be done.
    Engine(simulation::Simulator& simulator, Options options);

    /// Runs to the end, to an alarm or to a limit; what happened is the simulator's to tell. False where
    /// there was an alarm or a limit.
    bool run(Script script);
    /// The variables that a control keeps from one run to the next, as they are now. The error is a sentence:
    /// a run that ended for its memory may leave too little to read them.
    tl::expected<std::map<int, double>, std::string> permanent_variables();
    /// The machine data as the control holds them now: work coordinate systems, tools and variables may
    /// differ from those of the start. The error is as above.
    tl::expected<machine::MachineData, std::string> machine_data();

  private:
    struct Loaded {
        Script script;
        std::uint32_t file = 0;
        std::map<std::uint64_t, std::string> chunk_names;  ///< By where the chunk begins, once compiled.
        std::map<std::size_t, int> compiled;               ///< By function: what its only chunk became.
    };

    int call_protected(void (*work)(Engine&));
    bool judge(int status);
    void open_environment();
    void set_require(lua_State* state, int environment);
    void set_options(lua_State* state);
    void call_include(const std::string& file_name);
    tl::expected<void, std::string> read_kept(void (*read)(Engine&));
    void read_permanent();
    void read_stored();
    void call_library(const char* function);
    void load_script(Script script);
    void compile(Loaded& loaded, const ScriptChunk& chunk);

    static int do_work(lua_State* state);
    static int handle_error(lua_State* state);
    void register_function(Loaded& loaded, std::size_t index);
    static int function_body(lua_State* state);
    static int include_file(lua_State* state);
    static int load_program(lua_State* state);
    static int require_gsim(lua_State* state);

    simulation::Simulator& simulator_;
    Options options_;
    PlaceFinder places_;
    Controller controller_;
    LuaState lua_;
    void (*work_)(Engine&) = nullptr;
    std::vector<std::unique_ptr<Loaded>> loaded_;
    Script pending_;
    std::map<int, double> permanent_;
    machine::MachineData stored_;
    std::string error_;
    simulation::Place error_place_;
    int environment_ = LUA_NOREF;  ///< What scripts see.
    int library_ = LUA_NOREF;      ///< What the library's files see.
};

}  // namespace gsim::script
