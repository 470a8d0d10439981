#include "codegen/translate.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "codegen/lua/command_writer.h"
#include "codegen/lua/lua_writer.h"

namespace gsim::codegen {

namespace {

std::string leader_warning(std::uint32_t lines) {
    const std::string subject = lines == 1 ? "the line before the first % is"
                                           : fmt::format("the {} lines before the first % are", lines);
    return subject + " skipped: the leader of a tape, not a program";
}

std::string_view file_name(const TranslateOptions& options) {
    const std::size_t slash = options.source_name.rfind('/');
    return std::string_view(options.source_name).substr(slash == std::string::npos ? 0 : slash + 1);
}

/// Result of one reading of the source.
struct WrittenCode {
    ProgramMap programs;
    std::uint32_t last_line = 0;
};

WrittenCode write_commands(lexer::Source& source, LuaSpool& spool, const TranslateOptions& options,
                           lexer::Diagnostics& diagnostics) {
    CommandWriter writer(*options.dialect, diagnostics, spool, options.annotate);
    writer.write(source, file_name(options));
    return {writer.map(), writer.line()};
}

WrittenCode write_blocks(lexer::Source& source, LuaSpool& spool, const TranslateOptions& options,
                         lexer::Diagnostics& diagnostics) {
    const FileScan scan = scan_file(source, options.aliases, *options.dialect);
    lexer::Lexer lexer(source, diagnostics, options.aliases, options.dialect->text(), options.annotate);
    lexer.extent().skip_leader(scan.leader_lines);
    if (scan.leader_lines > 0)
        diagnostics.warning({0, 1, 1}, lexer::DiagnosticKind::syntax, leader_warning(scan.leader_lines));
    LuaWriter writer(*options.dialect, scan, lexer, diagnostics, spool,
                     {options.annotate, options.unknown == UnknownCodePolicy::warn, options.inch});
    writer.begin_file(file_name(options));
    grammar::Parser(lexer, diagnostics, writer).run();
    if (!diagnostics.full()) writer.end_file();
    return {writer.map(), lexer.cursor().line()};
}

}  // namespace

Translation translate(lexer::Source& source, LuaSpool& spool, const TranslateOptions& options,
                      const std::function<void(const text::Diagnostic&)>& on_diagnostic) {
    source.set_name(options.source_name);
    source.set_end_condition(options.should_stop);
    // Errors of a program that was read in part are meaningless.
    const auto report_diagnostic = [&](const text::Diagnostic& diagnostic) {
        if (!source.ended_early() && source.error() == 0) on_diagnostic(diagnostic);
    };
    lexer::Diagnostics diagnostics(source, options.max_errors, report_diagnostic);
    const bool commands = options.dialect->text().form == lexer::TextForm::command_lines;
    WrittenCode written = commands ? write_commands(source, spool, options, diagnostics)
                                   : write_blocks(source, spool, options, diagnostics);
    Translation result;
    result.ok = diagnostics.error_count() == 0;
    result.first_error = diagnostics.first_error();
    if (source.error() != 0) {
        result.ok = false;
        result.first_error =
            text::Diagnostic{.kind = text::DiagnosticKind::file, .text = *source.error_message()};
    }
    if (source.ended_early()) {
        result.ok = false;
        result.first_error = text::Diagnostic{.kind = text::DiagnosticKind::run_limit,
                                              .file = options.source_name,
                                              .line = written.last_line,
                                              .text = options.end_reason()};
        on_diagnostic(*result.first_error);
    }
    if (result.ok) {
        if (const auto finished = spool.finish(); !finished)
            throw std::runtime_error(finished.error().message);
    }
    result.programs = std::move(written.programs);
    return result;
}

TextTranslation translate_text(std::string_view gcode, const TranslateOptions& options) {
    lexer::Source source = lexer::Source::from_text(std::string(gcode), options.source_name);
    LuaSpool spool;
    TextTranslation result;
    Translation translation = translate(source, spool, options, [&](const text::Diagnostic& diagnostic) {
        result.diagnostics += text::to_text(diagnostic);
    });
    result.ok = translation.ok;
    if (!result.ok) return result;
    auto lua = spool.read(0, spool.size());
    if (!lua) throw std::runtime_error(lua.error().message);
    result.lua = *std::move(lua);
    result.programs = std::move(translation.programs);
    return result;
}

}  // namespace gsim::codegen
