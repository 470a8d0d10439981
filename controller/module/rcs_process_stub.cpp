// Replaces rcs_process.cpp in the WebAssembly build, which cannot start processes.
#include "controller/module/rcs_process.h"

namespace gsim::rrs {

Result<RcsModule> start_rcs_process(const std::filesystem::path& /*program*/, const std::string& path,
                                    const gsim_rcs_machine& /*machine*/, RcsProcessLimits /*limits*/) {
    return Unexpected("the controller module " + path + " requires a process, which this build cannot start");
}

}  // namespace gsim::rrs
