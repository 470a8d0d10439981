#pragma once

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "controller/module/rcs_host.h"
#include "controller/module/rcs_process.h"
#include "controller/module/rcs_values.h"
#include "tests/build_files/build_files.h"

namespace gsim::rrs {

/// The path of one of the modules in tests/controller/modules.
inline std::string module_path(const std::string& name) {
    return tests::build_path("lib/test_modules/") + name + ".so";
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

/// Process in which a module of a test runs.
enum class HostProcess { this_process, separate_process };

inline std::string place_name(const testing::TestParamInfo<HostProcess>& info) {
    return info.param == HostProcess::separate_process ? "own_process" : "this_process";
}

inline auto both_places() {
    return testing::Values(HostProcess::this_process, HostProcess::separate_process);
}

/// Returns the module; the error is the reason why it cannot be used.
inline Result<RcsModule> module_at(HostProcess place, const std::string& name, RcsProcessLimits limits = {}) {
    const gsim_rcs_machine machine = slides();
    if (place == HostProcess::separate_process)
        return start_rcs_process(tests::program_path("gsim-rcs-host"), module_path(name), machine, limits);
    auto library = RcsLibrary::load(module_path(name), machine, limits.response_timeout_ms);
    if (!library) return tl::unexpected(library.error());
    return RcsModule::create(*library, machine);
}

}  // namespace gsim::rrs
