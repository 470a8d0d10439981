#include "tests/round_trip/run_record.h"

#include <fstream>

#include "base/text/json.h"

namespace gsim::round_trip {

using nlohmann::json;

namespace {

std::map<char, double> read_axis_values(const json& object) {
    std::map<char, double> values;
    for (const auto& [letter, value] : object.items()) values[letter[0]] = value.get<double>();
    return values;
}

MadeMove move_of(const json& line) {
    MadeMove move;
    move.kind = line["kind"].get<std::string>();
    move.to = read_axis_values(line["to"]);
    move.duration_s = line["end_s"].get<double>() - line["start_s"].get<double>();
    if (line.contains("center") && line["center"].is_object()) {
        move.center = read_axis_values(line["center"]);
        move.turns = line["turns"].get<int>();
        if (line["plane"].is_string()) move.plane = line["plane"].get<std::string>();
    }
    return move;
}

}  // namespace

RunRecord read_run(const std::filesystem::path& moves, const std::filesystem::path& report) {
    RunRecord run;
    std::ifstream lines(moves);
    for (std::string line; std::getline(lines, line);)
        run.moves.push_back(move_of(text::parse_json<json>(line)));
    std::ifstream text(report);
    const json full = text::parse_json<json>(text);
    run.time_s = full["cycle_time_s"].get<double>();
    for (const json& event : full["events"])
        run.events.push_back({event["t_s"].get<double>(), event["kind"].get<std::string>(),
                              event.value("detail", std::string())});
    return run;
}

}  // namespace gsim::round_trip
