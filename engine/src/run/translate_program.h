#pragma once

#include "codegen/lua/lua_spool.h"
#include "codegen/translate.h"
#include "engine/src/run/script_input.h"

namespace gsim::engine {

/// Translates a program; `tell` gets the diagnostics. Behind those of a program that fails comes a note, if
/// it looks like one of another dialect; behind those of one that does not, warnings of a control whose
/// language is only near to the dialect, and of inches that are read as mm. `options` has what the language
/// does not say.
codegen::Translation translate_source(lexer::Source& source, codegen::LuaSpool& spool,
                                      const Language& language, codegen::TranslateOptions options,
                                      const TellDiagnostic& tell);

}  // namespace gsim::engine
