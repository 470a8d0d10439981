#include "apps/findings.h"

#include <cstdio>

#include "base/os/output_file.h"
#include "base/text/printable.h"
#include "cli/exit_status.h"
#include "cli/print.h"
#include "cli/usage_error.h"

namespace gsim::apps {

namespace {

/// Writes a text to standard error and returns the exit status.
int print_error(const std::string& text) {
    return std::fputs(text.c_str(), stderr) >= 0 ? kSuccess : kUsageError;
}

int write_output_file(const std::string& name, const std::string& text) {
    const auto written = os::write_file(name, text);
    if (written) return kSuccess;
    print_error(written.error().message + '\n');
    return kUsageError;
}

engine::Diagnostic to_diagnostic(const text::Diagnostic& diagnostic) {
    return {.severity = static_cast<engine::Severity>(diagnostic.severity),
            .code = std::string(text::diagnostic_code(diagnostic.kind)),
            .file = diagnostic.file,
            .line = diagnostic.line,
            .column = diagnostic.column,
            .end_column = diagnostic.end_column,
            .text = diagnostic.text,
            .hint = diagnostic.hint,
            .excerpt = diagnostic.excerpt};
}

}  // namespace

std::string output_destination(const std::string& output) {
    return output.empty() ? os::kStandardStream : output;
}

std::optional<Error> sarif_conflict(const FindingOptions& options, const std::string& product) {
    if (options.sarif != os::kStandardStream || product != os::kStandardStream) return std::nullopt;
    return "--sarif - and the output both use standard output; write one of them to a file";
}

void add_sarif_option(CommandLine& line, FindingOptions& options) {
    line.add("--sarif", &options.sarif,
             "also write the diagnostics as SARIF, for code hosts; - for standard output")
        .takes_file(FileKind::output, {".sarif"});
}

void add_finding_options(CommandLine& line, FindingOptions& options) {
    line.add("--json", &options.json,
             "print the diagnostics as JSON instead of text: to standard output, or to standard error if the "
             "output is written to standard output");
    add_sarif_option(line, options);
}

void Findings::print_text(const std::string& text) const {
    if (options_.json) return;
    if (text_stream_ == Stream::standard_output && options_.sarif != os::kStandardStream) {
        apps::print(text::printable(text));
    } else {
        print_error(text::printable(text));
    }
}

void Findings::add(const engine::Diagnostic& diagnostic) {
    all_.push_back(diagnostic);
    print_text(engine::diagnostic_text(diagnostic));
}

void Findings::add(const text::Diagnostic& diagnostic) {
    add(to_diagnostic(diagnostic));
}

int Findings::fail(const engine::Error& error) {
    all_.push_back(engine::to_diagnostic(error));
    if (!options_.json) report_error(program_, error.message);
    return kUsageError;
}

int Findings::fail(text::DiagnosticKind kind, std::string_view message, std::string_view file) {
    return fail({.code = std::string(text::diagnostic_code(kind)),
                 .message = std::string(message),
                 .file = std::string(file)});
}

int Findings::finish(int status, Stream json_stream) {
    if (options_.json) {
        const std::string document = engine::findings_json(all_, programs_);
        if (json_stream == Stream::standard_output) {
            apps::print(document);
        } else if (print_error(document) != kSuccess && status == kSuccess) {
            status = kUsageError;
        }
    }
    return finish_sarif_only(status);
}

int Findings::finish_sarif_only(int status) {
    if (options_.sarif.empty()) return status;
    const std::string document = engine::findings_sarif(all_);
    if (options_.sarif == os::kStandardStream) {
        apps::print(document);
        return status;
    }
    const int written = write_output_file(options_.sarif, document);
    return status == kSuccess ? written : status;
}

}  // namespace gsim::apps
