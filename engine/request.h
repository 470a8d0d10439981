#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/api.h"
#include "engine/cancel.h"
#include "engine/host.h"

namespace gsim::script {
class CompiledLibraryCache;
}

namespace gsim::engine {

/// Limits for a run that does not end by its own words. A reached limit ends the run with RunStatus::stopped,
/// and the report names it.
struct Limits {
    double machine_s = 10'000'000;              ///< Time of the machine.
    double cpu_s = 86'400;                      ///< Processor time of the calling thread, from open() on.
    std::uint64_t blocks = 20'000'000;          ///< That are executed.
    std::uint64_t steps = 10'000'000;           ///< For scripts without a motion.
    std::uint64_t memory_bytes = 2048U << 20U;  ///< For scripts, with their texts and what they make.
};

/// Options for reading G-code.
struct LanguageOptions {
    std::string dialect =
        {};  ///< "ab9", "rs274ngc", "klipper" or a control's name; empty: as the machine file says.
    /// Handling of a code that the dialect does not have: kError, or kWarn: omitted with a warning.
    std::string unknown = kError;

    static constexpr const char* kError = "error";
    static constexpr const char* kWarn = "warn";
};

/// Returns the names valid for LanguageOptions::dialect.
GSIM_API std::vector<std::string> controller_names();

/// Returns a message why LanguageOptions::dialect rejects a name; nothing if it is valid.
GSIM_API std::optional<std::string> find_controller_error(const std::string& name);

/// The operator's override settings; if missing: 100 %.
struct OverrideOptions {
    std::optional<double> feed_percent = {};
    std::optional<double> rapid_percent = {};
    std::optional<double> spindle_percent = {};
    std::string file = {};  ///< File of changes during the run; empty: none.

    bool is_default() const { return !feed_percent && !rapid_percent && !spindle_percent && file.empty(); }
};

/// The built-in compiled Lua library, compiled once for all runs that have this in their request. Compiling
/// is most of the time of a small program. Copies share one library, for any number of threads.
class GSIM_API CompiledLuaLibrary {
  public:
    CompiledLuaLibrary();
    /// For internal use.
    const std::shared_ptr<script::CompiledLibraryCache>& impl() const { return compiled_; }

  private:
    std::shared_ptr<script::CompiledLibraryCache> compiled_;
};

/// Handling of a program's blocks and ends.
struct ExecutionOptions {
    std::uint64_t passes = 1;    ///< For a main program that leads back to its start.
    bool stop_at_first = false;  ///< The first violation of a range or a zone ends the run.
    bool block_delete = false;   ///< Blocks that begin with / are left out.
    bool optional_stop = false;  ///< M01 stops.
};

/// The program to run, and its environment. Names are those of files, or as Host::find finds them; an empty
/// one: none.
struct Request {
    std::string program = {};  ///< Part program, or script in Lua (.lua).
    std::optional<Text> text =
        {};  ///< The program if it is not a file; `program` then locates its subprograms. Consumed by open().
    std::string machine =
        {};  ///< Machine file, or settings of a control; empty: the one of the cell, or the one built in.
    std::string machine_data = {};
    std::string cell = {};
    std::string setup = {};      ///< Script that runs before the program.
    std::string robots = {};     ///< Robots and conveyors, each robot with a separate machine.
    std::string variables = {};  ///< Permanent variables; there need be no such file.
    std::string library = {};    ///< Folder of the library in Lua; empty: the one built in.
    std::optional<CompiledLuaLibrary> compiled_lua_library = {};  ///< Used without a folder.
    std::string module = {};                                      ///< Controller module (Host::load_module).
    std::string probe =
        {};  ///< The contact of probes: "none", "z=-3.2" (mm of the machine); empty: the cell.
    LanguageOptions language = {};
    OverrideOptions overrides = {};
    Limits limits = {};
    ExecutionOptions execution = {};
    bool collisions = true;  ///< Bodies of machines and cells are checked.
    bool explain = false;    ///< The report explains the time consumption.
    Host host = {};
    Cancel cancel = {};
};

}  // namespace gsim::engine
