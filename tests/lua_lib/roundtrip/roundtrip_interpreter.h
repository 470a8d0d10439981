#pragma once

#include <array>
#include <memory>
#include <vector>

#include "tests/lua_lib/roundtrip/roundtrip_control.h"
#include "tests/lua_lib/roundtrip/roundtrip_model.h"
#include "tests/lua_lib/roundtrip/roundtrip_variables.h"

namespace gsim::roundtrip {

/// Required behaviour of a program.
struct Reading {
    std::vector<Move> moves;
    bool fragile = false;   ///< The last bit of rounding may decide its course.
    bool too_long = false;  ///< It was ended at kMaxMoves.
};

inline constexpr std::size_t kMaxMoves = 3000;

/// Carries out a program. `systems`: the stored offsets of G54, G55, ..
Reading read(const Program& program, const std::array<Point, 9>& systems);

}  // namespace gsim::roundtrip
