#include "codegen/flow/program_names.h"

#include <fmt/format.h>

namespace gsim::codegen {

void ProgramNames::report_missing(lexer::Diagnostics& diagnostics) const {
    for (const auto& [number, location] : called_) {
        if (programs_.contains(std::to_string(number))) continue;
        diagnostics.warning(
            location, lexer::DiagnosticKind::program_missing,
            fmt::format("program O{} is not in this file; it is searched for next to it when it is called",
                        number));
    }
}

}  // namespace gsim::codegen
