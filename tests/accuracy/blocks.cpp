#include "tests/accuracy/blocks.h"

#include <exception>
#include <istream>

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::accuracy {

namespace {

using nlohmann::json;

Block read_move(const json& move) {
    const json& line = move.at("line");
    return {line.is_number() ? line.get<long>() : 0, move.at("start_s").get<double>(),
            move.at("end_s").get<double>()};
}

void append(std::vector<Block>& blocks, const Block& move) {
    if (move.line == 0 || !(move.end_s > move.start_s)) return;
    if (!blocks.empty() && blocks.back().line == move.line) {
        blocks.back().end_s = move.end_s;
    } else {
        blocks.push_back(move);
    }
}

}  // namespace

std::vector<Block> blocks_of(const std::vector<LineTime>& times) {
    std::vector<Block> blocks;
    double start_s = 0;
    for (const LineTime& time : times) {
        append(blocks, {time.line, start_s, start_s + time.duration_s});
        start_s += time.duration_s;
    }
    return blocks;
}

Result<std::vector<Block>> read_blocks(std::istream& moves) {
    std::vector<Block> blocks;
    std::string line;
    for (long number = 1; std::getline(moves, line); ++number) {
        if (line.empty()) continue;
        try {
            append(blocks, read_move(text::parse_json<json>(line)));
        } catch (const std::exception& error) {  // nlohmann's
            return Unexpected(
                fmt::format("line {} of the moves cannot be understood: {}", number, error.what()));
        }
    }
    return blocks;
}

}  // namespace gsim::accuracy
