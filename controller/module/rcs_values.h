#pragma once

#include <span>
#include <string_view>

#include "controller/module/rcs_module.h"
#include "controller/services/types.h"

namespace gsim::rrs {

/// Conversions between values of the services and those of rcs_module.h.

gsim_rcs_pose to_rcs(const CartPos& pose);
CartPos from_rcs(const gsim_rcs_pose& pose);

/// Converts at most kMaxJoints values.
gsim_rcs_joints to_rcs(const JointPos& joints);
/// Converts joint values; a count out of range is taken as 0.
JointPos from_rcs(const gsim_rcs_joints& joints);

/// Writes `text` with a trailing zero byte. Returns false, and truncates, if it does not fit or holds a zero
/// byte.
bool copy_text(std::string_view text, std::span<char> field);

}  // namespace gsim::rrs
