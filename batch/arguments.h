#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "apps/command_line.h"

namespace gsim::batch {

/// What gsim-batch is told.
struct Arguments {
    std::vector<std::string> inputs;
    std::vector<std::string> machines;
    std::string machine_data, cell, dialect;
    bool no_collisions = false;
    bool reports = false, pictures = false;
    std::string results = "gsim-batch.sqlite";
    std::uint64_t workers = std::max(std::thread::hardware_concurrency(), 1U);
    std::optional<double> memory_mb;
    double timeout_s = 600;
    bool retry = false;
    bool slurm = false, status = false, cancel = false, wait = false;
    std::string partition;
    std::uint64_t shard_runs = 1000, task_workers = 1, time_limit_min = 0;
    std::string csv, json_lines, junit, sarif;
    bool statistics = false;
    std::string statistics_json, page, pages;
    bool views = false;
    std::optional<double> since;
    bool quiet = false;
};

void add_options(apps::CommandLine& line, Arguments& arguments);

}  // namespace gsim::batch
