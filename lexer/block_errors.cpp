#include "lexer/block_errors.h"

namespace gsim::lexer {

void BlockErrors::fail(std::uint32_t column, DiagnosticKind kind, std::string_view message,
                       std::string_view hint) {
    // All but the first error of a block are mostly its consequence.
    if (!block_.bad) diagnostics_.error(block_.at(column), kind, message, hint);
    block_.bad = true;
}

void BlockErrors::exceed(std::uint32_t column, DiagnosticKind kind, std::string_view message) {
    fail(column, kind, message);
    is_dropping_ = true;
}

}  // namespace gsim::lexer
