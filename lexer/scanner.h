#pragma once

#include "lexer/token.h"

namespace gsim::lexer {

class Lexer;

/// Makes the scanner that flex generates from gcode.l. It calls the actions of `lexer`, which must outlive
/// it.
void* make_scanner(Lexer* lexer);
void free_scanner(void* scanner);
Token scan_token(Value& value, void* scanner);

}  // namespace gsim::lexer
