#pragma once

#include <optional>
#include <string>

#include "tests/conformance/canon_reader.h"

namespace gsim::conformance {

/// Where both sides stand before a move.
struct Standing {
    AxisValues expected{};  ///< The reference, mm and deg.
    AxisValues found{};     ///< gsim, mm and deg.
    AxisValues apart{};     ///< found - expected, as far as a probe has left them apart.
};

/// In what a move of gsim differs from the reference's, as a sentence; nothing where they agree.
std::optional<std::string> find_mismatch(const ExpectedMove& expected, const Move& found,
                                         const Standing& standing);

/// Where both stand after moves that agree.
Standing after(const ExpectedMove& expected, const Move& found, const Standing& standing);

/// Whether the feeds agree. `rotary_only`: no linear axis moves, so that the feed is in deg/min.
bool feeds_agree(const ExpectedMove& expected, const Move& found, bool rotary_only);

/// Whether the move goes nowhere, as far as the printed digits tell.
bool has_no_length(const ExpectedMove& expected, const Standing& standing);
/// Whether the move is too short for the digits that the reference would print it with.
bool has_no_length(const Move& found, const Standing& standing, const AxisValues& tolerance);

}  // namespace gsim::conformance
