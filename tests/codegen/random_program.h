#pragma once

#include <random>
#include <string>

namespace gsim::codegen {

struct RandomOptions {
    int lines = 60;
    bool errors = false;  ///< Blocks with an error among the others.
    bool jumps = true;    ///< GOTOs, loops left open at no time.
};

/// A program of several kinds of blocks, the same for the same state of `random`.
std::string random_program(std::mt19937& random, const RandomOptions& options);

/// A program of RS274/NGC without an error: O-words that nest, settings, active comments, blanks within
/// words.
std::string random_ngc_program(std::mt19937& random, int lines);

}  // namespace gsim::codegen
