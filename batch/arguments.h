#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/run_arguments.h"
#include "cli/command_line.h"

namespace gsim::batch {

/// Files that gsim-batch writes from the results.
struct OutputFiles {
    std::string csv, json_lines, junit, sarif;
    bool statistics = false;  ///< Printed.
    std::string statistics_json, page, pages;
    bool views = false;
    std::optional<double> since;
};

/// Commands for a batch on a cluster.
struct ClusterCommand {
    bool status = false, cancel = false, wait = false;
};

/// Arguments of gsim-batch.
struct Arguments : RunArguments {
    Arguments() { results = "gsim-batch.sqlite"; }

    std::vector<std::string> inputs;
    std::vector<std::string> machines;
    std::string machine_data, cell, dialect;
    bool no_collisions = false;
    bool reports = false, pictures = false;
    ClusterCommand cluster;
    OutputFiles outputs;
    bool quiet = false;
};

void add_options(apps::CommandLine& line, Arguments& arguments);

}  // namespace gsim::batch
