#pragma once

#include <vector>

#include "machine/model/machine.h"

namespace gsim::machine {

/// All joint values (mm, rad) between two corners: a finite part of what a machine can take, which stands for
/// all of it as far as that can be.
struct JointBox {
    rrs::JointPos low;
    rrs::JointPos high;
    /// Joints of slides without ends: the box goes as far from home as the chain reaches, but at least 1 m.
    std::vector<int> cut = {};

    rrs::JointPos middle() const;
    /// The joint values at shares between 0 and 1 of the box's sides.
    rrs::JointPos at(const rrs::JointPos& shares) const;
};

/// The ranges of the axes. A rotary axis that turns farther than once round, or on without end, has one turn
/// in it, about its home as far as the range allows: beyond it all comes again.
JointBox joint_box(const Machine& machine);

/// Point `number` of a low-discrepancy sequence in the unit box (J. H. Halton, Numerische Mathematik 2,
/// 1960): values between 0 and 1, the same each time.
rrs::JointPos halton_point(int number, int joints);

}  // namespace gsim::machine
