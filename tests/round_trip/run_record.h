#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gsim::round_trip {

/// A move or dwell of gsim-run --moves.
struct MadeMove {
    std::string kind;
    std::map<char, double> to;  ///< Axis values, mm or deg.
    std::map<char, double> center;
    std::string plane;
    int turns = 0;
    double duration_s = 0;
};

struct MadeEvent {
    double t_s = 0;
    std::string kind, detail;
};

/// Record of a run, from its moves and its report.
struct RunRecord {
    std::vector<MadeMove> moves;
    std::vector<MadeEvent> events;
    double time_s = 0;
};

/// Reads what gsim-run --moves and --report have written.
RunRecord read_run(const std::filesystem::path& moves, const std::filesystem::path& report);

}  // namespace gsim::round_trip
