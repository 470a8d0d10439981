#include "apps/findings.h"

#include <cstdio>

#include <fmt/format.h>

#include "apps/exit_status.h"
#include "apps/print.h"
#include "runtime/simulation/output_file.h"

namespace gsim::apps {

namespace {

/// Writes a text to standard error; the status.
int print_error(const std::string& text) {
    return std::fputs(text.c_str(), stderr) >= 0 ? kDone : kUsage;
}

int write_document(const std::string& name, const std::string& text) {
    const auto written = simulation::write_file(name, text);
    if (written) return kDone;
    print_error(written.error() + '\n');
    return kUsage;
}

}  // namespace

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

void Findings::print(const std::string& text) const {
    if (!options_.json) std::fputs(text.c_str(), text_to_ == Stream::standard_output ? stdout : stderr);
}

void Findings::take(const text::Diagnostic& diagnostic) {
    all_.push_back(diagnostic);
    print(text::to_text(diagnostic));
}

int Findings::fail(text::DiagnosticKind kind, std::string_view sentence, std::string_view file) {
    text::Diagnostic diagnostic = text::diagnostic_of(kind, sentence);
    if (diagnostic.file.empty() && !file.empty()) {
        diagnostic.file = file;
        const std::string head = fmt::format("{}: ", file);
        if (diagnostic.text.starts_with(head)) diagnostic.text.erase(0, head.size());
    }
    all_.push_back(std::move(diagnostic));
    if (!options_.json) print_error(fmt::format("{}: {}\n", program_, sentence));
    return kUsage;
}

int Findings::finish(int status, Stream json_to) {
    if (options_.json) {
        const std::string document = findings_json(all_, programs_);
        const int printed =
            json_to == Stream::standard_output ? apps::print(document) : print_error(document);
        if (printed != kDone) status = printed;
    }
    return finish_told(status);
}

int Findings::finish_told(int status) {
    if (options_.sarif.empty()) return status;
    const std::string document = findings_sarif(all_);
    const int written =
        options_.sarif == "-" ? apps::print(document) : write_document(options_.sarif, document);
    return written == kDone ? status : written;
}

}  // namespace gsim::apps
