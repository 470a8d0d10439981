#pragma once

#include <cstddef>
#include <deque>

#include "motion/lookahead/block.h"

namespace gsim::motion {

/// Blocks that lead to a corner: the first `count` >= 1 blocks of a look-ahead window, the last of which ends
/// there.
struct PrecedingBlocks {
    const std::deque<Block>& window;
    std::size_t count;

    std::size_t size() const { return count; }
    const Block& operator[](std::size_t index) const { return window[index]; }
    const Block& back() const { return window[count - 1]; }
};

}  // namespace gsim::motion
