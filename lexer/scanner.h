#pragma once

#include "lexer/token.h"

namespace gsim::lexer {

class Lexer;

/// The scanner that flex generates from gcode.l. It calls the actions of `lexer`, which outlives it.
void* make_scanner(Lexer* lexer);
void free_scanner(void* scanner);
Token scan_token(Value& value, void* scanner);

}  // namespace gsim::lexer
