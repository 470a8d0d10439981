#include "tests/accuracy/path_distance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace gsim::accuracy {

namespace {

double distance_mm(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::string describe(const std::vector<Block>& blocks, std::size_t at) {
    return at < blocks.size() ? fmt::format("line {}", blocks[at].line) : "the end";
}

std::optional<std::string> find_foreign_block(const std::vector<Block>& recorded,
                                              const std::vector<Block>& found) {
    const std::size_t count = std::max(recorded.size(), found.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (i < recorded.size() && i < found.size() && recorded[i].line == found[i].line) continue;
        return fmt::format("block {} is {}, {} is recorded", i + 1, describe(found, i),
                           describe(recorded, i));
    }
    return std::nullopt;
}

}  // namespace

Result<Distance> largest_distance(const TimedPath& recorded, const TimedPath& found) {
    if (auto foreign = find_foreign_block(recorded.blocks, found.blocks))
        return tl::unexpected(*std::move(foreign));
    std::optional<Distance> largest;
    std::size_t at = 0;
    for (const Sample& sample : recorded.trajectory) {
        while (at < recorded.blocks.size() && recorded.blocks[at].end_s < sample.t_s) ++at;
        if (at == recorded.blocks.size()) break;
        if (sample.t_s < recorded.blocks[at].start_s) continue;
        const double into_block_s = sample.t_s - recorded.blocks[at].start_s;
        const Block& block = found.blocks[at];
        const double found_t_s = std::min(block.start_s + into_block_s, block.end_s);
        const double mm = distance_mm(sample.at_mm, place_at_mm(found.trajectory, found_t_s));
        if (!largest || mm > largest->mm) largest = {mm, block.line, into_block_s};
    }
    if (!largest) return Unexpected("no sample lies in a block");
    return *largest;
}

}  // namespace gsim::accuracy
