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

/// A program in the list of all: everything that is made for each of them (links, man pages, completions) is
/// made from this list.
struct ProgramEntry {
    std::string_view name;     ///< "gsim-run", as it is called by itself
    std::string_view command;  ///< "run", as gsim calls it
    std::unique_ptr<Program> (*make)();
};

/// What one executable offers.
struct FrontPrograms {
    std::span<const ProgramEntry> programs;  ///< Those that people begin with first.
    /// Answers gsim-serve, by which alone it is called; null if this executable does not.
    int (*studio_answer)(std::span<const std::string> arguments) = nullptr;
};

/// All programs: what gsim has.
FrontPrograms all_programs();

/// Translation and simulation: what `make run` builds first.
FrontPrograms first_programs();

}  // namespace gsim::apps
