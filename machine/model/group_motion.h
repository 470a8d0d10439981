#pragma once

#include <string_view>

#include "machine/model/axis_group.h"

namespace gsim::machine {

/// Returns "synchronous", "coordinated" or "independent".
std::string_view name(GroupMotion motion);

}  // namespace gsim::machine
