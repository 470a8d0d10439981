#include "controller/services/shell.h"

namespace gsim::rrs {

// The parameters have names, as in the list, but are not used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
// NOLINTBEGIN(misc-unused-parameters)
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    Status Shell::method parameters {                                                         \
        return not_supported(#method);                                                        \
    }
#include "controller/module/rcs_services.def"
// NOLINTEND(misc-unused-parameters)
#pragma GCC diagnostic pop

Status Shell::not_supported(std::string_view) {
    return Status::RRS_SERVICE_NOT_SUPPORTED;
}

}  // namespace gsim::rrs
