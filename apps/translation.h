#pragma once

#include "apps/script_input.h"
#include "codegen/lua_spool.h"
#include "codegen/translate.h"

namespace gsim::apps {

/// Translates a program; `tell` gets the diagnostics. Behind those of a program that fails comes a note, if
/// it looks like one of another dialect; behind those of one that does not, warnings of a control whose
/// language is only near to the dialect, and of inches that are read as mm. `options` has what the language
/// does not say.
codegen::Translation translate_source(lexer::Source& source, codegen::LuaSpool& spool,
                                      const Language& language, codegen::TranslateOptions options,
                                      const TellDiagnostic& tell);

}  // namespace gsim::apps
