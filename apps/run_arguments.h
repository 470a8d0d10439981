#pragma once

#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>

#include "apps/language.h"
#include "apps/machine_studies.h"
#include "apps/outputs.h"
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
    LanguageNames language;
    std::string setup;
    std::string variables;
    std::string lua_lib;
    std::string rcs;
    std::string robots;
    OutputNames outputs;
    MachineStudies studies;
    simulation::RunLimits limits;
    std::size_t memory_mb = 2048;
    std::uint64_t max_steps = script::LuaState::Limits{}.steps;
    bool json = false;
    bool quiet = false;
    bool print_machine = false;
    bool block_delete = false;
    bool optional_stop = false;
};

void add_run_options(CLI::App& app, RunArguments& arguments);

/// Why options do not go together, as a sentence; empty where they do.
std::string find_contradiction(const RunArguments& arguments);

}  // namespace gsim::apps
