#pragma once

#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/conformance/canon_reader.h"

namespace gsim::conformance {

/// Returns the moves of canonical calls written as `NAME(...)`, each on a line of its own with the usual
/// beginning.
inline std::vector<ExpectedMove> expected_moves(std::initializer_list<const char*> calls) {
    std::stringstream text;
    int number = 0;
    for (const char* call : calls) text << "  " << ++number << " N..... " << call << '\n';
    auto moves = read_canon(text);
    EXPECT_TRUE(moves) << moves.error().message;
    return std::move(moves).value_or(std::vector<ExpectedMove>{});
}

}  // namespace gsim::conformance
