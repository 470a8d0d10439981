#include "engine/findings.h"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "base/text/diagnostic_json.h"
#include "base/text/file_format.h"
#include "base/text/json.h"
#include "engine/src/conversions.h"
#include "engine/version.h"

namespace gsim::engine {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSarifSchema = "https://json.schemastore.org/sarif-2.1.0.json";

std::string dump_json(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Returns a file's name as a reference (RFC 3986): characters that are not plain in a path are written as
/// bytes.
std::string to_uri(std::string_view name) {
    std::string uri = name.starts_with('/') ? "file://" : "";
    for (const char c : name) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                           std::string_view("/-._~!$&'()*+,;=@").find(c) != std::string_view::npos;
        if (plain) {
            uri += c;
        } else {
            uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return uri;
}

Json sarif_location(const Diagnostic& diagnostic) {
    Json physical_location;
    physical_location["artifactLocation"] = {{"uri", to_uri(diagnostic.file)}};
    if (diagnostic.line > 0) {
        Json& region = physical_location["region"];
        region["startLine"] = diagnostic.line;
        if (diagnostic.column > 0) region["startColumn"] = diagnostic.column;
        if (diagnostic.end_column > diagnostic.column) region["endColumn"] = diagnostic.end_column;
    }
    return {{"physicalLocation", physical_location}};
}

Json sarif_result(const Diagnostic& diagnostic) {
    const std::string hint = diagnostic.hint.empty() ? "" : "; " + diagnostic.hint;
    Json result;
    result["ruleId"] = diagnostic.code;
    result["level"] = text::name(static_cast<text::Severity>(diagnostic.severity));
    result["message"] = {{"text", diagnostic.text + hint}};
    if (!diagnostic.file.empty()) result["locations"] = Json::array({sarif_location(diagnostic)});
    return result;
}

Json sarif_rules(std::span<const Diagnostic> diagnostics) {
    std::set<std::string_view> codes;
    for (const Diagnostic& diagnostic : diagnostics) codes.insert(diagnostic.code);
    Json rules = Json::array();
    for (const text::DiagnosticKindEntry& entry : text::diagnostic_kinds()) {
        if (codes.contains(entry.code))
            rules.push_back({{"id", entry.code}, {"shortDescription", {{"text", entry.meaning}}}});
    }
    return rules;
}

}  // namespace

std::string diagnostic_text(const Diagnostic& diagnostic) {
    return text::to_text(to_text_diagnostic(diagnostic));
}

Diagnostic to_diagnostic(const Error& error) {
    using text::DiagnosticKind;
    const auto kind = text::diagnostic_kind(error.code).value_or(DiagnosticKind::internal);
    Diagnostic diagnostic = to_diagnostic(text::to_diagnostic(kind, error.message));
    if (!diagnostic.file.empty() || error.file.empty()) return diagnostic;
    diagnostic.file = error.file;
    const std::string head = fmt::format("{}: ", error.file);
    if (diagnostic.text.starts_with(head)) diagnostic.text.erase(0, head.size());
    return diagnostic;
}

std::string findings_json(std::span<const Diagnostic> diagnostics, std::span<const CheckedProgram> programs) {
    Json document = {{"format", text::kFileFormat}};
    for (const CheckedProgram& each : programs) {
        document["programs"].push_back(
            {{"program", each.name}, {"status", each.status}, {"cycle_time_s", each.cycle_time_s}});
    }
    std::vector<text::Diagnostic> text_diagnostics;
    for (const Diagnostic& diagnostic : diagnostics)
        text_diagnostics.push_back(to_text_diagnostic(diagnostic));
    document["diagnostics"] = text::to_json(text_diagnostics);
    return dump_json(document);
}

std::string findings_sarif(std::span<const Diagnostic> diagnostics) {
    Json results = Json::array();
    for (const Diagnostic& diagnostic : diagnostics) results.push_back(sarif_result(diagnostic));
    Json driver = {{"name", "gsim"}, {"version", version()}, {"rules", sarif_rules(diagnostics)}};
    Json run = {{"tool", {{"driver", std::move(driver)}}}, {"results", std::move(results)}};
    return dump_json(
        {{"$schema", kSarifSchema}, {"version", "2.1.0"}, {"runs", Json::array({std::move(run)})}});
}

}  // namespace gsim::engine
