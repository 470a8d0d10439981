#pragma once

#include <string>

#include "machine/model/joint_box.h"

namespace gsim::check {

/// Check that the inverse leads back: random joint values to a pose, from there to joint values, and again to
/// a pose.
struct InverseCheck {
    int poses = 0;                 ///< 0: the machine has no inverse.
    int unsolved = 0;              ///< No solution was found, though there is one.
    int out_of_range = 0;          ///< One was found, but beyond the axes' ranges.
    int inaccurate_count = 0;      ///< One was found that does not lead back to 1e-6 mm and 1e-6 rad.
    double worst_mm = 0;           ///< The greatest distance between pose and pose ...
    double worst_rad = 0;          ///< ... and the greatest angle, of those that were solved.
    std::string message = {};      ///< Message of the inverse about the first unsolved one ...
    rrs::JointPos first_bad = {};  ///< ... and the joint values of the first one that is not well.

    bool is_consistent() const { return unsolved == 0 && out_of_range == 0 && inaccurate_count == 0; }
};

/// Checks poses of Halton points of the box, solved from home.
InverseCheck check_inverse(const machine::Machine& machine, const machine::JointBox& box);

}  // namespace gsim::check
