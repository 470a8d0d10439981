#pragma once

#include <random>

#include "toolpath/model/path.h"

namespace gsim::path {

/// Permitted content of random programs.
struct RandomPathOptions {
    bool tilted_arcs = true;
    bool orientations = true;  ///< rotary_deg with B and C; otherwise none.
    bool extras = true;        ///< Names, dwells, actions, accelerations, durations.
    int sub_paths = 3;
    bool machine_points = false;  ///< Fixed and reference points at unknown positions.
};

/// A well-formed program inside a box of 100 mm to 400 mm.
Program random_program(std::mt19937& random, const RandomPathOptions& options = {});

}  // namespace gsim::path
