#include "engine/src/run/translate_program.h"

#include <utility>

#include "codegen/blocks/program_signs.h"
#include "runtime/simulator/run_limits.h"

namespace gsim::engine {

using simulation::cpu_limit_reached;

namespace {

text::Diagnostic about_control(const lexer::Source& source, const Language& language,
                               text::Severity severity) {
    return {.severity = severity,
            .kind = text::DiagnosticKind::dialect,
            .file = source.name(),
            .text = language.caution};
}

}  // namespace

codegen::Translation translate_source(lexer::Source& source, codegen::LuaSpool& spool,
                                      const Language& language, codegen::TranslateOptions options,
                                      const TellDiagnostic& tell) {
    options.source_name = source.name();
    options.dialect = language.dialect;
    options.aliases = language.aliases;
    options.unknown = language.unknown;
    options.inch = language.units == machine::ProgramUnits::inch;
    if (language.cpu != nullptr) {
        options.ends = [cpu = language.cpu] { return cpu->reached(); };
        options.end_reason = [cpu = language.cpu] { return cpu_limit_reached(*cpu); };
    }
    codegen::Translation made = codegen::translate(source, spool, options, tell);
    if (!made.ok && (source.was_ended() || source.error() != 0)) return made;
    if (!made.ok) {
        if (const auto hint = codegen::find_dialect_hint(source, *language.dialect)) {
            tell(*hint);
        } else if (!language.caution.empty()) {
            tell(about_control(source, language, text::Severity::note));
        }
        return made;
    }
    if (!language.caution.empty()) tell(about_control(source, language, text::Severity::warning));
    const bool always_mm = language.dialect->rules().style == lexer::Style::command_lines;
    if (language.units || always_mm) return made;
    if (const auto inches = codegen::find_inch_signs(source)) tell(*inches);
    return made;
}

}  // namespace gsim::engine
