#include "tests/conformance/moves_reader.h"

#include <istream>
#include <stdexcept>

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::conformance {

namespace {

using nlohmann::json;

double axis_value(const json& values, char letter) {
    return values.value(std::string(1, letter), 0.0);
}

ArcPart read_arc(const json& object) {
    ArcPart arc;
    arc.turns = object.at("turns").get<int>();
    const json& center = object.at("center");
    const json& normal = object.at("normal");
    for (std::size_t axis = 0; axis < kLinearAxes; ++axis) {
        arc.center_mm[axis] = axis_value(center, kAxes[axis]);
        arc.normal[axis] = axis_value(normal, kAxes[axis]);
    }
    return arc;
}

Move read_move(const json& object) {
    Move move;
    const std::string kind_name = object.at("kind").get<std::string>();
    const auto kind = parse_kind(kind_name);
    if (!kind) throw std::runtime_error(fmt::format("its kind '{}' is not known", kind_name));
    move.kind = *kind;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        move.to[axis] = axis_value(object.at("to"), kAxes[axis]);
    }
    if (is_arc(move.kind)) move.arc = read_arc(object);
    if (const json& feed = object.at("feed"); feed.is_number()) move.feed_per_min = feed.get<double>();
    if (const json& line = object.at("line"); line.is_number()) move.line = line.get<long>();
    if (move.kind == Kind::dwell) {
        move.dwell_s = object.at("end_s").get<double>() - object.at("start_s").get<double>();
    }
    return move;
}

}  // namespace

Result<std::vector<Move>> read_moves(std::istream& text) {
    std::vector<Move> moves;
    std::string line;
    for (long number = 1; std::getline(text, line); ++number) {
        if (line.empty()) continue;
        try {
            moves.push_back(read_move(text::parse_json<json>(line)));
        } catch (const std::exception& error) {  // those of nlohmann and our own
            return Unexpected(
                fmt::format("line {} of the moves cannot be understood: {}", number, error.what()));
        }
    }
    return moves;
}

}  // namespace gsim::conformance
