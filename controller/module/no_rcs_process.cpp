// Replaces rcs_process.cpp in the WebAssembly build, which cannot start processes.
#include "controller/module/rcs_process.h"

namespace gsim::rrs {

tl::expected<RcsModule, std::string> start_rcs_process(const std::filesystem::path& /*program*/,
                                                       const std::string& path,
                                                       const gsim_rcs_machine& /*machine*/,
                                                       RcsProcessLimits /*limits*/) {
    return tl::unexpected("the controller module " + path +
                          " needs a process, which this build cannot begin");
}

}  // namespace gsim::rrs
