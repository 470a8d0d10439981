#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/error.h"
#include "controller/module/rcs_module.h"
#include "controller/services/shell.h"

namespace gsim::rrs {

/// Adapter of any Shell to a controller module: a library's functions of rcs_module.h call these.

/// Function that creates a Shell; the error is a message.
using ShellFactory = Result<std::unique_ptr<Shell>> (*)(const gsim_rcs_machine& machine);

/// Works as gsim_rcs_create(); an exception of the factory is an error with its text.
gsim_rcs_module* create_exported(ShellFactory make, const gsim_rcs_machine* machine,
                                 gsim_rcs_message* message) noexcept;
void destroy_exported(gsim_rcs_module* module) noexcept;
/// Works as gsim_rcs_call(); on an exception of the Shell it returns GSIM_RCS_FAULT, with its text as the
/// message.
std::int32_t call_exported(gsim_rcs_module* module, std::int32_t opcode, const void* input,
                           void* output) noexcept;

}  // namespace gsim::rrs
