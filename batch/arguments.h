#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/run_arguments.h"
#include "cli/command_line.h"

namespace gsim::batch {

/// Arguments of gsim-batch.
struct Arguments : RunArguments {
    Arguments() { results = "gsim-batch.sqlite"; }

    std::vector<std::string> inputs;
    std::vector<std::string> machines;
    std::string machine_data, cell, dialect;
    bool no_collisions = false;
    bool reports = false, pictures = false;
    bool status = false, cancel = false, wait = false;
    std::string csv, json_lines, junit, sarif;
    bool statistics = false;
    std::string statistics_json, page, pages;
    bool views = false;
    std::optional<double> since;
    bool quiet = false;
};

void add_options(apps::CommandLine& line, Arguments& arguments);

}  // namespace gsim::batch
