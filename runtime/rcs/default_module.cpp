// Our own planner as a controller module.

#include "controller/module/rcs_export.h"
#include "motion/services/default_planner.h"
#include "runtime/rcs/rcs_machine.h"

namespace {

gsim::Result<std::unique_ptr<gsim::rrs::Shell>> make_planner(const gsim_rcs_machine& machine) {
    return gsim::rcs::setup_from_rcs_machine(machine).map(
        [](gsim::motion::PlannerSetup setup) -> std::unique_ptr<gsim::rrs::Shell> {
            return std::make_unique<gsim::motion::DefaultPlanner>(std::move(setup));
        });
}

}  // namespace

extern "C" {

int32_t gsim_rcs_version(void) {
    return GSIM_RCS_VERSION;
}

gsim_rcs_module* gsim_rcs_create(const gsim_rcs_machine* machine, gsim_rcs_message* message) {
    return gsim::rrs::create_exported(make_planner, machine, message);
}

void gsim_rcs_destroy(gsim_rcs_module* module) {
    gsim::rrs::destroy_exported(module);
}

int32_t gsim_rcs_call(gsim_rcs_module* module, int32_t opcode, const void* input, void* output) {
    return gsim::rrs::call_exported(module, opcode, input, output);
}
}
