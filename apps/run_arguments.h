#pragma once

#include <cstdint>
#include <string>

#include "apps/findings.h"
#include "apps/limit_options.h"
#include "apps/machine_data_file.h"
#include "apps/machine_studies.h"
#include "apps/outputs.h"
#include "base/error.h"
#include "cli/command_line.h"
#include "engine/request.h"

namespace gsim::apps {

/// Options of gsim-run, as they are given; an empty name: not wanted.
struct RunArguments {
    engine::Request request;
    std::string save_machine_data;
    double wait_s = kMaxWait_s;  ///< For files that another program changes.
    OutputNames outputs;
    MachineStudies studies;
    std::uint64_t memory_mb = kDefaultMemory_mb;
    FindingOptions findings;  ///< `json`: the report is JSON.
    bool quiet = false;
    bool print_machine = false;
    bool no_collisions = false;
    bool no_confine = false;
    bool module_in_process = false;
};

/// Returns the request to the engine.
engine::Request make_request(const RunArguments& arguments);

/// Adds the options of gsim-run.
void add_run_options(CommandLine& line, RunArguments& arguments);
/// Adds those options that say what is run and on what: the machine, its data, its cell, the language.
void add_machine_options(CommandLine& line, RunArguments& arguments);
/// Adds those options that limit a run.
void add_limit_options(CommandLine& line, RunArguments& arguments);

/// Returns an error if options contradict each other.
std::optional<Error> find_contradiction(const RunArguments& arguments);

}  // namespace gsim::apps
