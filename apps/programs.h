#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "cli/program.h"

namespace gsim::apps {

std::unique_ptr<Program> make_gsim_run();
std::unique_ptr<Program> make_gsim_check();
std::unique_ptr<Program> make_gcode2lua();
std::unique_ptr<Program> make_path2gcode();
std::unique_ptr<Program> make_autopath();
std::unique_ptr<Program> make_gsim_data();
std::unique_ptr<Program> make_gsim_studio();

/// Program in the list of all programs. Everything that is made for each of them (links, man pages,
/// completions) is generated from this list.
struct ProgramEntry {
    std::string_view name;     ///< "gsim-run", as it is called by itself
    std::string_view command;  ///< "run", as gsim calls it
    std::unique_ptr<Program> (*make)();
};

/// Programs that one executable offers.
struct ProgramSet {
    std::span<const ProgramEntry> programs;  ///< Those that people begin with first.
    /// Handles requests of gsim-serve, its only caller; null if this executable does not.
    int (*studio_handler)(std::span<const std::string> arguments) = nullptr;
};

/// Returns all programs of gsim.
ProgramSet all_programs();

/// Returns the programs for translation and simulation, which `make run` builds first.
ProgramSet first_programs();

}  // namespace gsim::apps
