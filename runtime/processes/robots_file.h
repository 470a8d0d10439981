#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "controller/services/types.h"
#include "runtime/processes/conveyor.h"
#include "runtime/processes/shared_zones.h"

namespace gsim::process {

/// Robot as a file of robots defines it.
struct RobotEntry {
    std::string name;
    std::filesystem::path machine;                 ///< Empty: the one that is built in.
    std::filesystem::path machine_data;            ///< Empty: none.
    std::filesystem::path cell;                    ///< Cell of the robot; empty: none.
    std::string dialect;                           ///< Empty: that of the run.
    rrs::CartPos base = rrs::CartPos::Identity();  ///< Pose of the machine's world in that of the file.
};

/// Robots and conveyors of a run, in the order of the file.
struct RobotsFile {
    std::vector<RobotEntry> robots;
    std::vector<Conveyor> conveyors;
    std::vector<SharedZone> zones;
};

/// Reads the tables [[robot]], [[conveyor]] and [[zone]] (docs/processes.md), strictly; those of cells are
/// skipped. The error is "file:line:column: message". Files that it names are searched in its folder. A robot
/// may have one of `dialects`, which are names of languages.
Result<RobotsFile> read_robots(std::string_view toml_text, std::string_view file_name,
                               std::span<const std::string_view> dialects);

}  // namespace gsim::process
