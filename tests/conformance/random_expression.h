#pragma once

#include <string>

#include "tests/conformance/random_source.h"

namespace gsim::conformance {

/// Returns a random expression of RS274/NGC in brackets: operators, functions, EXISTS, parameters by number,
/// by number of a number and by name. Its value is finite, and it never divides by 0. It may read #1 to #9,
/// #20 (an integer), #<size>, #<_size>. With `reads_control` it may read the controller's own state
/// (#<_feed>, #5221), too.
std::string random_expression(RandomSource& random, int depth, bool reads_control);

/// Returns an expression of up to `depth` levels with a value between -`size` and `size`.
std::string bounded_expression(RandomSource& random, int size, int depth, bool reads_control);

/// An expression that is 0 or 1 as a truth value.
std::string random_condition(RandomSource& random, bool reads_control);

}  // namespace gsim::conformance
