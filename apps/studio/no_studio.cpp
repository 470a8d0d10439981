// Systems without processes have no server of the studio.

#include "apps/programs.h"
#include "apps/studio/studio_answer.h"
#include "cli/usage_error.h"

namespace gsim::apps {

namespace {

struct NoArguments {};

int refuse(const NoArguments& /*arguments*/) {
    return usage_error("gsim-studio", "this build serves no page");
}

}  // namespace

std::unique_ptr<Program> make_gsim_studio() {
    return std::make_unique<ProgramOf<NoArguments>>(
        "gsim-studio", "Shows a machine run a program, and changes both, in a browser",
        [](CommandLine&, NoArguments&) {}, refuse);
}

int answer_studio(std::span<const std::string> /*arguments*/) {
    return refuse({});
}

}  // namespace gsim::apps
