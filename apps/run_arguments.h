#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "apps/command_line.h"
#include "apps/findings.h"
#include "apps/language.h"
#include "apps/limit_options.h"
#include "apps/machine_data_file.h"
#include "apps/machine_studies.h"
#include "apps/outputs.h"
#include "apps/override_options.h"
#include "apps/run_cell.h"
#include "base/os/input_file.h"
#include "runtime/script/lua_state.h"
#include "runtime/simulation/simulator.h"

namespace gsim::apps {

/// The options of gsim-run, as they are given; an empty name: not wanted.
struct RunArguments {
    std::string input;
    std::string machine;
    std::string machine_data;
    std::string save_machine_data;
    std::string cell;
    std::shared_ptr<const cell::Cell> cell_read;  ///< As in CellChoice.
    std::string cell_text;                        ///< Of that file, which is read once: it may be a pipe.
    os::NamedBy machine_named_by = os::NamedBy::command_line;  ///< Or by the cell file.
    os::NamedBy machine_data_named_by = os::NamedBy::command_line;
    std::string probe;
    LanguageNames language;
    std::string setup;
    std::string variables;
    double wait_s = kLongestWait_s;  ///< For files that another program changes.
    std::string lua_lib;
    std::string rcs;
    std::string robots;
    OverrideOptions overrides;
    OutputNames outputs;
    MachineStudies studies;
    simulation::RunLimits limits;
    std::uint64_t memory_mb = kMemory_mb;
    std::uint64_t passes = 1;      ///< Of a main program that leads back to its start.
    double max_cpu_s = kMaxCpu_s;  ///< What `limits.cpu` is made of.
    std::uint64_t max_steps = script::LuaState::Limits{}.steps;
    FindingOptions findings;  ///< `json`: the report is JSON.
    bool quiet = false;
    bool print_machine = false;
    bool block_delete = false;
    bool optional_stop = false;
    bool no_collisions = false;
    bool no_confine = false;
};

/// What the options say to look at.
CellChoice cell_choice(const RunArguments& arguments);

/// The options of gsim-run.
void add_run_options(CommandLine& line, RunArguments& arguments);
/// Those of them that say what is run and on what: the machine, its data, its cell, the language.
void add_machine_options(CommandLine& line, RunArguments& arguments);
/// Those that bound a run.
void add_limit_options(CommandLine& line, RunArguments& arguments);

/// Why options do not go together, as a sentence; empty where they do.
std::string find_contradiction(const RunArguments& arguments);

}  // namespace gsim::apps
