#include "tests/round_trip/compare_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace gsim::round_trip {

namespace {

constexpr double kSamePlace = 1e-3;  // mm or deg
constexpr double kOnArc_mm = 0.012;  // the writer's tolerance of lines in place of arcs, and the digits
constexpr double kSameShare = 1e-3;
constexpr double kSameTime_s = 2e-3;

double distance(const MadeMove& a, const MadeMove& b) {
    double max = 0;
    for (const auto& [letter, value] : a.to) max = std::max(max, std::abs(value - b.to.at(letter)));
    return max;
}

bool is_arc(const MadeMove& move) {
    return move.kind.starts_with("arc");
}

// Returns the kind of a move in messages: all straight feed moves are one.
std::string motion_name(const MadeMove& move) {
    return is_arc(move) || move.kind == "rapid" || move.kind == "dwell" || move.kind == "thread" ? move.kind
                                                                                                 : "linear";
}

double radius_at(const MadeMove& arc, const MadeMove& at) {
    double square = 0;
    for (const auto& [letter, value] : arc.center) {
        const bool in_plane = arc.plane.find(static_cast<char>(letter | 0x20)) != std::string::npos;
        if (in_plane) square += std::pow(at.to.at(letter) - value, 2);
    }
    return std::sqrt(square);
}

double center_distance(const MadeMove& a, const MadeMove& b) {
    double max = 0;
    for (const auto& [letter, value] : a.center) {
        const bool in_plane = a.plane.find(static_cast<char>(letter | 0x20)) != std::string::npos;
        const auto other = b.center.find(letter);
        if (in_plane && other != b.center.end()) max = std::max(max, std::abs(value - other->second));
    }
    return max;
}

// Returns true if `piece` is a part of the arc that it does not end.
bool is_piece(const MadeMove& arc, const MadeMove& arc_part) {
    if (!is_arc(arc)) return false;
    if (arc_part.kind == "linear")
        return std::abs(radius_at(arc, arc_part) - radius_at(arc, arc)) < kOnArc_mm;
    return arc_part.kind == arc.kind && arc_part.plane == arc.plane &&
           center_distance(arc, arc_part) < kOnArc_mm;
}

std::string display_text(const MadeMove& move) {
    std::string text = move.kind;
    for (const auto& [letter, value] : move.to) text += fmt::format(" {}{:.6f}", letter, value);
    return text;
}

std::string event_name(const MadeEvent& event) {
    if (event.detail.empty() || event.kind == "optional_stop") return event.kind;
    return event.kind + " " + event.detail;
}

std::string same_switch(const MadeEvent& event) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kEqualTolerance = {{
        {"jet_on", "M8"},
        {"flood_on", "M8"},
        {"jet_off", "M9"},
        {"coolant_off", "M9"},
        {"mist_on", "M7"},
        {"coolant_2_on", "M7"},
        {"abrasive_on", "digital_output P0 on"},  // as the post rs274ngc has it
        {"abrasive_off", "digital_output P0 off"},
        {"spindle_orient", "spindle_orient 0 deg, shortest way"},  // the marked angle is that of R0
    }};
    for (const auto& [kind, word] : kEqualTolerance) {
        if (event.kind == kind) return std::string(word);
    }
    return event_name(event);
}

std::vector<MadeEvent> events_of(const RunRecord& run, const std::set<std::string>& unsaid) {
    std::vector<MadeEvent> events;
    for (const MadeEvent& event : run.events) {
        const bool repeated = event.kind != "probe" && event.kind != "tool_table";
        if (!repeated || unsaid.contains(event_name(event))) continue;
        if (event.kind == "overrides_on" || event.kind == "overrides_off") {
            // M48 and M49 are two events in RS274/NGC.
            const std::string state = event.kind == "overrides_on" ? " enabled" : " disabled";
            events.push_back({event.t_s, "override", "feed" + state});
            events.push_back({event.t_s, "override", "speed" + state});
            continue;
        }
        events.push_back(event);
    }
    return events;
}

// A controller that stops the spindle to change the tool (M6 of LinuxCNC) stops a turning one; the program
// written for it starts the spindle again. If the second run stops it at a change that the first makes with
// it on, both events are added to the first. Each is therefore required.
std::vector<MadeEvent> with_stops_at_changes(const std::vector<MadeEvent>& first,
                                             const std::vector<MadeEvent>& second) {
    std::vector<MadeEvent> events;
    std::optional<MadeEvent> turning;
    for (const MadeEvent& event : first) {
        const std::size_t at = events.size();
        const bool stops =
            event.kind == "tool_change" && turning && at < second.size() && second[at].kind == "spindle_off";
        if (stops) events.push_back({event.t_s, "spindle_off", {}});
        events.push_back(event);
        if (stops) events.push_back({event.t_s, turning->kind, turning->detail});
        if (event.kind == "spindle_cw" || event.kind == "spindle_ccw") {
            turning = event;
        } else if (event.kind.starts_with("spindle_")) {
            turning.reset();
        }
    }
    return events;
}

// A dwell of no time is a program's mark for a standstill.
std::vector<MadeMove> read_moves(const RunRecord& run) {
    std::vector<MadeMove> moves;
    for (const MadeMove& move : run.moves) {
        if (move.kind != "dwell" || move.duration_s > 0) moves.push_back(move);
    }
    return moves;
}

bool is_same_time(double a_s, double b_s) {
    return std::abs(a_s - b_s) <= std::max(kSameTime_s, kSameShare * std::abs(a_s));
}

}  // namespace

std::string compare_positions(const RunRecord& first, const RunRecord& second) {
    const std::vector<MadeMove> wanted_moves = read_moves(first), found_moves = read_moves(second);
    const MadeMove* at = nullptr;  // position of the second run
    std::size_t j = 0;
    for (std::size_t i = 0; i < wanted_moves.size(); ++i) {
        const MadeMove& expected_value = wanted_moves[i];
        std::size_t found = j;
        // These are the parts of an arc, up to the one that ends at its end.
        while (found < found_moves.size() && is_piece(expected_value, found_moves[found]) &&
               (distance(expected_value, found_moves[found]) > kSamePlace)) {
            ++found;
        }
        const bool ends_there =
            found < found_moves.size() && distance(expected_value, found_moves[found]) <= kSamePlace;
        const bool same_way = ends_there && (motion_name(expected_value) == motion_name(found_moves[found]) ||
                                             is_piece(expected_value, found_moves[found]));
        if (same_way) {
            // Further turns end at the end of the first one.
            for (int turn = 1; turn < expected_value.turns && found + 1 < found_moves.size(); ++turn) {
                const MadeMove& next = found_moves[found + 1];
                if (!is_arc(next) || !is_piece(expected_value, next) ||
                    distance(expected_value, next) > kSamePlace)
                    break;
                ++found;
            }
            at = &found_moves[found];
            j = found + 1;
            continue;
        }
        const bool stays =
            expected_value.kind != "dwell" && (at == nullptr || distance(expected_value, *at) <= kSamePlace);
        if (stays) continue;
        return fmt::format("move {}: {}, found {}", i + 1, display_text(expected_value),
                           j < found_moves.size() ? display_text(found_moves[j]) : "none");
    }
    if (j < found_moves.size()) return fmt::format("a further move: {}", display_text(found_moves[j]));
    return {};
}

std::string compare_times(const RunRecord& first, const RunRecord& second) {
    if (is_same_time(first.time_s, second.time_s)) return {};
    return fmt::format("{:.4f} s, found {:.4f} s ({:+.2f} %)", first.time_s, second.time_s,
                       100 * (second.time_s / first.time_s - 1));
}

std::string compare_events(const RunRecord& first, const RunRecord& second,
                           const std::set<std::string>& unsaid) {
    const std::vector<MadeEvent> b = events_of(second, unsaid);
    const std::vector<MadeEvent> a = with_stops_at_changes(events_of(first, unsaid), b);
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        const std::string expected_value = i < a.size() ? same_switch(a[i]) : "none";
        const std::string found = i < b.size() ? same_switch(b[i]) : "none";
        if (expected_value != found)
            return fmt::format("event {}: {}, found {}", i + 1, expected_value, found);
        if (!is_same_time(a[i].t_s, b[i].t_s)) {
            return fmt::format("event {}, {}: at {:.4f} s, found at {:.4f} s", i + 1, expected_value,
                               a[i].t_s, b[i].t_s);
        }
    }
    return {};
}

}  // namespace gsim::round_trip
