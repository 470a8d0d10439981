#pragma once

#include <string>

#include <fmt/format.h>

#include "runtime/rrs/rcs_host.h"
#include "runtime/rrs/rcs_values.h"

namespace gsim::rrs {

/// The path of one of the modules in tests/rrs/modules.
inline std::string module_path(const std::string& name) {
    return fmt::format("{}/{}.so", GSIM_TEST_MODULES, name);
}

/// Three slides without limits but of rapid speed.
inline gsim_rcs_machine slides() {
    gsim_rcs_machine machine{};
    machine.joint_count = 3;
    machine.base = machine.tool = to_rcs(CartPos::Identity());
    machine.max_rapid_mm_s = 500;
    machine.queue_capacity = 8;
    return machine;
}

}  // namespace gsim::rrs
