#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

/// Feed of the lines below.
inline constexpr double kFed_mm_s = 100;

/// Runs a line of X and Y from the machine's position, at that speed.
inline void feed(Simulator& simulator, double x, double y, std::uint32_t line,
                 MoveKind kind = MoveKind::linear) {
    LineMove move{.kind = kind,
                  .target = simulator.position().axes(),
                  .feed = {.linear_mm_min = kFed_mm_s * 60},
                  .location = {0, line}};
    move.target[0] = x;
    move.target[1] = y;
    ASSERT_TRUE(simulator.moves().enqueue(move));
}

}  // namespace gsim::simulation
