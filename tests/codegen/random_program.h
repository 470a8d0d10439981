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

}  // namespace gsim::codegen
