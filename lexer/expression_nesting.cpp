#include "lexer/expression_nesting.h"

#include <fmt/format.h>

namespace gsim::lexer {

bool ExpressionNesting::open_bracket() {
    if (++brackets_ <= kMaxBrackets) return true;
    errors_.exceed(cursor_.column(), DiagnosticKind::nesting,
                   fmt::format("brackets are nested more than {} deep", kMaxBrackets));
    return false;
}

}  // namespace gsim::lexer
