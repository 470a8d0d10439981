#pragma once

#include <optional>
#include <string>

#include "tests/conformance/canon_reader.h"

namespace gsim::conformance {

/// Positions of both sides before a move.
struct EvaluationState {
    AxisValues expected{};  ///< The reference, mm and deg.
    AxisValues found{};     ///< gsim, mm and deg.
    AxisValues apart{};     ///< found - expected, as far as a probe has left a difference.
};

/// Returns a message about the difference between a move of gsim and the reference's, or none if they agree.
std::optional<std::string> find_mismatch(const ExpectedMove& expected, const Move& found,
                                         const EvaluationState& state);

/// Returns the positions of both after moves that agree.
EvaluationState after(const ExpectedMove& expected, const Move& found, const EvaluationState& state);

/// Returns true if the feeds agree. `rotary_only`: no linear axis moves, so that the feed is in deg/min.
bool feeds_agree(const ExpectedMove& expected, const Move& found, bool rotary_only);

/// Returns true if the move has no length, as far as the printed digits show.
bool has_no_length(const ExpectedMove& expected, const EvaluationState& state);
/// Returns true if the move is too short for the digits that the reference would print it with.
bool has_no_length(const Move& found, const EvaluationState& state, const AxisValues& tolerance);

}  // namespace gsim::conformance
