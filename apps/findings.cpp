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
    return std::fputs(text.c_str(), stderr) >= 0 ? kDone : kUsage;
}

int write_document(const std::string& name, const std::string& text) {
    const auto written = os::write_file(name, text);
    if (written) return kDone;
    print_error(written.error() + '\n');
    return kUsage;
}

engine::Diagnostic plain(const text::Diagnostic& told) {
    return {.severity = static_cast<engine::Severity>(told.severity),
            .code = std::string(text::code_of(told.kind)),
            .file = told.file,
            .line = told.line,
            .column = told.column,
            .end_column = told.end_column,
            .text = told.text,
            .hint = told.hint,
            .excerpt = told.excerpt};
}

}  // namespace

std::string product_name(const std::string& output) {
    return output.empty() ? os::kStandardStream : output;
}

std::optional<std::string> sarif_conflict(const FindingOptions& options, const std::string& product) {
    if (options.sarif != os::kStandardStream || product != os::kStandardStream) return std::nullopt;
    return "--sarif - and the product both want standard output; give one of them a file";
}

void add_sarif_option(CommandLine& line, FindingOptions& options) {
    line.add("--sarif", &options.sarif,
             "write what was found as SARIF too, which code hosts show; - for standard output")
        .of_file(FileKind::output, {".sarif"});
}

void add_finding_options(CommandLine& line, FindingOptions& options) {
    line.add("--json", &options.json,
             "what was found as JSON in place of text: on standard output, or on standard error where the "
             "product goes to standard output");
    add_sarif_option(line, options);
}

void Findings::say(const std::string& text) const {
    if (options_.json) return;
    if (text_to_ == Stream::standard_output && options_.sarif != os::kStandardStream) {
        apps::print(text::printable(text));
    } else {
        print_error(text::printable(text));
    }
}

void Findings::take(const engine::Diagnostic& told) {
    all_.push_back(told);
    say(engine::text_of(told));
}

void Findings::take(const text::Diagnostic& told) {
    take(plain(told));
}

int Findings::fail(const engine::Failure& failure) {
    all_.push_back(engine::diagnostic_of(failure));
    if (!options_.json) tell_fault(program_, failure.message);
    return kUsage;
}

int Findings::fail(text::DiagnosticKind kind, std::string_view sentence, std::string_view file) {
    return fail({.code = std::string(text::code_of(kind)),
                 .message = std::string(sentence),
                 .file = std::string(file)});
}

int Findings::finish(int status, Stream json_to) {
    if (options_.json) {
        const std::string document = engine::findings_json(all_, programs_);
        if (json_to == Stream::standard_output) {
            apps::print(document);
        } else if (print_error(document) != kDone && status == kDone) {
            status = kUsage;
        }
    }
    return finish_told(status);
}

int Findings::finish_told(int status) {
    if (options_.sarif.empty()) return status;
    const std::string document = engine::findings_sarif(all_);
    if (options_.sarif == os::kStandardStream) {
        apps::print(document);
        return status;
    }
    const int written = write_document(options_.sarif, document);
    return status == kDone ? written : status;
}

}  // namespace gsim::apps
