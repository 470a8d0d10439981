// Systems without processes have no server of the studio.

#include "apps/programs.h"
#include "apps/studio/studio_request.h"
#include "cli/usage_error.h"

namespace gsim::apps {

namespace {

struct NoArguments {};

int report_no_studio(const NoArguments& /*arguments*/) {
    return usage_error("gsim-studio", "this build does not serve pages");
}

}  // namespace

std::unique_ptr<Program> make_gsim_studio() {
    return std::make_unique<ProgramWithArguments<NoArguments>>(
        "gsim-studio", "Simulates a program on a machine, and edits both, in a browser",
        [](CommandLine&, NoArguments&) {}, report_no_studio);
}

int handle_studio_request(std::span<const std::string> /*arguments*/) {
    return report_no_studio({});
}

}  // namespace gsim::apps
