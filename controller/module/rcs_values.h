#pragma once

#include <span>
#include <string_view>

#include "controller/module/rcs_module.h"
#include "controller/services/types.h"

namespace gsim::rrs {

/// Values of the services as rcs_module.h has them, and back.

gsim_rcs_pose to_rcs(const CartPos& pose);
CartPos from_rcs(const gsim_rcs_pose& pose);

/// At most kMaxJoints values.
gsim_rcs_joints to_rcs(const JointPos& joints);
/// A count out of range is taken as 0.
JointPos from_rcs(const gsim_rcs_joints& joints);

/// Writes `text` with a zero byte behind it; false, and cut, where it does not fit or holds a zero byte.
bool put_text(std::string_view text, std::span<char> place);

}  // namespace gsim::rrs
