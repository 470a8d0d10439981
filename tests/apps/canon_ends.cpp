#include "tests/apps/canon_ends.h"

#include <cstdlib>
#include <regex>
#include <sstream>

#include "base/text/json.h"

namespace gsim::apps {

namespace {

void add(Ends& ends, const std::array<double, 5>& end, bool arc) {
    if (arc || end != (ends.empty() ? std::array<double, 5>{} : ends.back())) ends.push_back(end);
}

}  // namespace

bool has_rs274() {
    return std::system("command -v rs274 >/dev/null") == 0;
}

Ended run_rs274(const std::filesystem::path& folder, const std::string& program) {
    return run_program("/usr/bin/env", {"rs274", "-g", program}, folder);
}

Ends ends_of_canon(const std::string& calls) {
    static const std::regex kCall(R"((STRAIGHT_TRAVERSE|STRAIGHT_FEED|ARC_FEED|SELECT_PLANE)\(([^)]*)\))");
    Ends ends;
    std::string plane = "CANON_PLANE_XY";
    std::istringstream lines(calls);
    for (std::string line; std::getline(lines, line);) {
        std::smatch call;
        if (!std::regex_search(line, call, kCall)) continue;
        if (call[1] == "SELECT_PLANE") {
            plane = call[2];
            continue;
        }
        std::vector<double> n;
        std::istringstream numbers(call[2]);
        for (std::string number; std::getline(numbers, number, ',');) n.push_back(std::stod(number));
        if (call[1] != "ARC_FEED") {
            add(ends, {n.at(0), n.at(1), n.at(2), n.at(4), n.at(5)}, false);
        } else if (plane.ends_with("XY")) {
            add(ends, {n.at(0), n.at(1), n.at(5), n.at(7), n.at(8)}, true);
        } else if (plane.ends_with("YZ")) {
            add(ends, {n.at(5), n.at(0), n.at(1), n.at(7), n.at(8)}, true);
        } else {
            add(ends, {n.at(1), n.at(5), n.at(0), n.at(7), n.at(8)}, true);
        }
    }
    return ends;
}

Ends ends_of_moves(const std::string& jsonl) {
    Ends ends;
    std::istringstream lines(jsonl);
    for (std::string line; std::getline(lines, line);) {
        const auto move = text::parse_json<nlohmann::json>(line);
        if (move["kind"] == "dwell" || !move.contains("to")) continue;
        const auto& to = move["to"];
        add(ends, {to["X"], to["Y"], to["Z"], to.value("B", 0.0), to.value("C", 0.0)},
            move.contains("center"));
    }
    return ends;
}

}  // namespace gsim::apps
