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
class CompiledLibrary;
}

namespace gsim::engine {

/// Bounds of a run that ends itself by none of its own words. One that is reached ends the run with
/// RunStatus::stopped, and the report says which.
struct Limits {
    double machine_s = 10'000'000;              ///< Time of the machine.
    double cpu_s = 86'400;                      ///< Processor time of the calling thread, from open() on.
    std::uint64_t blocks = 20'000'000;          ///< That are executed.
    std::uint64_t steps = 10'000'000;           ///< Of scripts without a motion.
    std::uint64_t memory_bytes = 2048U << 20U;  ///< For scripts, with their texts and what they make.
};

/// How G-code is read.
struct LanguageChoice {
    std::string dialect =
        {};  ///< "ab9", "rs274ngc", "klipper" or a control's name; empty: as the machine file says.
    /// What a code is that the dialect does not have: kError, or kWarn: left out with a warning.
    std::string unknown = kError;

    static constexpr const char* kError = "error";
    static constexpr const char* kWarn = "warn";
};

/// Names that LanguageChoice::dialect takes.
GSIM_API std::vector<std::string> control_names();

/// Why LanguageChoice::dialect does not take a name, in a sentence; nothing where it does.
GSIM_API std::optional<std::string> why_no_control(const std::string& name);

/// What the operator turns the overrides to; nothing: 100 %.
struct OverrideChoice {
    std::optional<double> feed_percent = {};
    std::optional<double> rapid_percent = {};
    std::optional<double> spindle_percent = {};
    std::string file = {};  ///< Of changes in the course of the run; empty: none.

    bool turns_nothing() const { return !feed_percent && !rapid_percent && !spindle_percent && file.empty(); }
};

/// The library in Lua that is built in, compiled once for all runs that have this in their request: most of
/// the time of a small program. Copies are one; for any number of threads.
class GSIM_API SharedLibrary {
  public:
    SharedLibrary();
    /// For the library itself.
    const std::shared_ptr<script::CompiledLibrary>& inner() const { return compiled_; }

  private:
    std::shared_ptr<script::CompiledLibrary> compiled_;
};

/// What is run, and on what. Names are those of files, or what Host::find finds; an empty one: none.
struct Request {
    std::string program = {};       ///< Part program, or script in Lua (.lua).
    std::optional<Text> text = {};  ///< The program where it is no file; `program` is where its subprograms
                                    ///< lie beside. Taken by open().
    std::string machine =
        {};  ///< Machine file, or settings of a control; empty: the one of the cell, or the one built in.
    std::string machine_data = {};
    std::string cell = {};
    std::string setup = {};      ///< Script that runs before the program.
    std::string robots = {};     ///< Robots and conveyors, each robot with a machine of its own.
    std::string variables = {};  ///< Permanent variables; there need be no such file.
    std::string library = {};    ///< Folder of the library in Lua; empty: the one built in.
    std::optional<SharedLibrary> shared_library = {};  ///< Where there is no folder.
    std::string module = {};                           ///< Controller module (Host::load_module).
    std::string probe = {};  ///< What probes touch: "none", "z=-3.2" (mm of the machine); empty: the cell.
    LanguageChoice language = {};
    OverrideChoice overrides = {};
    Limits limits = {};
    std::uint64_t passes = 1;    ///< Of a main program that leads back to its start.
    bool stop_at_first = false;  ///< The first violation of a range or a zone ends the run.
    bool collisions = true;      ///< Bodies of machines and cells are looked at.
    bool block_delete = false;   ///< Blocks that begin with / are left out.
    bool optional_stop = false;  ///< M01 stops.
    bool explain = false;        ///< The report tells where the time goes.
    Host host = {};
    Cancel cancel = {};
};

}  // namespace gsim::engine
