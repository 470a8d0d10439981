#pragma once

#include "codegen/lua/lua_spool.h"
#include "codegen/translate.h"
#include "engine/src/run/script_input.h"

namespace gsim::engine {

/// Translates a program; `on_diagnostic` receives the diagnostics. For a program with errors, a note follows
/// if it looks like one of another dialect. For a program without errors, warnings follow about a controller
/// whose language is only similar to the dialect, and about inches that are read as mm. `options` contains
/// the settings that the language does not.
codegen::Translation translate_source(lexer::Source& source, codegen::LuaSpool& spool,
                                      const Language& language, codegen::TranslateOptions options,
                                      const TextDiagnosticHandler& on_diagnostic);

}  // namespace gsim::engine
