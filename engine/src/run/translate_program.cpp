#include "engine/src/run/translate_program.h"

#include <utility>

#include "codegen/blocks/program_hints.h"
#include "runtime/simulator/run_limits.h"

namespace gsim::engine {

using simulation::cpu_limit_reached;

namespace {

text::Diagnostic caution_diagnostic(const lexer::Source& source, const Language& language,
                                    text::Severity severity) {
    return {.severity = severity,
            .kind = text::DiagnosticKind::dialect,
            .file = source.name(),
            .text = language.caution};
}

}  // namespace

codegen::Translation translate_source(lexer::Source& source, codegen::LuaSpool& spool,
                                      const Language& language, codegen::TranslateOptions options,
                                      const TextDiagnosticHandler& on_diagnostic) {
    options.source_name = source.name();
    options.dialect = language.dialect;
    options.aliases = language.aliases;
    options.unknown = language.unknown;
    options.inch = language.units == machine::ProgramUnits::inch;
    if (language.cpu != nullptr) {
        options.should_stop = [cpu = language.cpu] { return cpu->reached(); };
        options.end_reason = [cpu = language.cpu] { return cpu_limit_reached(*cpu); };
    }
    codegen::Translation result = codegen::translate(source, spool, options, on_diagnostic);
    if (!result.ok && (source.ended_early() || source.error() != 0)) return result;
    if (!result.ok) {
        if (const auto hint = codegen::find_dialect_hint(source, *language.dialect)) {
            on_diagnostic(*hint);
        } else if (!language.caution.empty()) {
            on_diagnostic(caution_diagnostic(source, language, text::Severity::note));
        }
        return result;
    }
    if (!language.caution.empty())
        on_diagnostic(caution_diagnostic(source, language, text::Severity::warning));
    if (language.units || language.dialect->rules().always_mm) return result;
    if (const auto inches = codegen::find_inch_hint(source)) on_diagnostic(*inches);
    return result;
}

}  // namespace gsim::engine
