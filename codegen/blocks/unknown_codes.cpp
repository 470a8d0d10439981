#include "codegen/blocks/unknown_codes.h"

#include <fmt/format.h>

namespace gsim::codegen {

using lexer::DiagnosticKind;

void UnknownCodes::report(lexer::Diagnostics& diagnostics, std::string_view dialect_title,
                          std::string_view consequence) const {
    for (const auto& [code, entry] : codes_) {
        diagnostics.warning(entry.first, DiagnosticKind::code_unknown,
                            fmt::format("{} is not a code of {}; {} ({} in total)", code, dialect_title,
                                        consequence, entry.count));
    }
}

}  // namespace gsim::codegen
