#pragma once

#include <vector>

#include "machine/model/machine.h"

namespace gsim::machine {

/// All joint values (mm, rad) between two corners: a finite part of a machine's range, which represents the
/// full range as far as possible.
struct JointBox {
    rrs::JointPos low;
    rrs::JointPos high;
    /// Joints of slides without ends: the box extends as far from home as the chain reaches, but at least 1
    /// m.
    std::vector<int> cut = {};

    rrs::JointPos middle() const;
    /// Returns the joint values at shares between 0 and 1 of the box's sides.
    rrs::JointPos at(const rrs::JointPos& shares) const;
};

/// Returns the ranges of the axes. A rotary axis that turns farther than once round, or without end, has one
/// turn in it, about its home as far as the range allows. Beyond that turn all poses repeat.
JointBox joint_box(const Machine& machine);

/// Returns point `number` of a low-discrepancy sequence in the unit box (J. H. Halton, Numerische Mathematik
/// 2, 1960): values between 0 and 1, the same each time.
rrs::JointPos halton_point(int number, int joints);

}  // namespace gsim::machine
