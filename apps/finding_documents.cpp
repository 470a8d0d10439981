#include "apps/finding_documents.h"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/version.h"
#include "base/text/diagnostic_json.h"

namespace gsim::apps {

namespace {

using Json = nlohmann::ordered_json;
using text::Diagnostic;

constexpr const char* kSarifSchema = "https://json.schemastore.org/sarif-2.1.0.json";

std::string as_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// A file's name as a reference (RFC 3986): what is not plain in a path is written as its bytes.
std::string as_uri(std::string_view name) {
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
    Json physical;
    physical["artifactLocation"] = {{"uri", as_uri(diagnostic.file)}};
    if (diagnostic.line > 0) {
        Json& region = physical["region"];
        region["startLine"] = diagnostic.line;
        if (diagnostic.column > 0) region["startColumn"] = diagnostic.column;
        if (diagnostic.end_column > diagnostic.column) region["endColumn"] = diagnostic.end_column;
    }
    return {{"physicalLocation", physical}};
}

Json sarif_result(const Diagnostic& diagnostic) {
    const std::string hint = diagnostic.hint.empty() ? "" : "; " + diagnostic.hint;
    Json result;
    result["ruleId"] = text::code_of(diagnostic.kind);
    result["level"] = text::name(diagnostic.severity);
    result["message"] = {{"text", diagnostic.text + hint}};
    if (!diagnostic.file.empty()) result["locations"] = Json::array({sarif_location(diagnostic)});
    return result;
}

Json sarif_rules(std::span<const Diagnostic> diagnostics) {
    std::set<text::DiagnosticKind> kinds;
    for (const Diagnostic& diagnostic : diagnostics) kinds.insert(diagnostic.kind);
    Json rules = Json::array();
    for (const text::DiagnosticKindEntry& entry : text::diagnostic_kinds()) {
        if (kinds.contains(entry.kind))
            rules.push_back({{"id", entry.code}, {"shortDescription", {{"text", entry.meaning}}}});
    }
    return rules;
}

}  // namespace

std::string findings_json(std::span<const Diagnostic> diagnostics, std::span<const CheckedProgram> programs) {
    Json document;
    for (const CheckedProgram& each : programs) {
        document["programs"].push_back(
            {{"program", each.name}, {"status", each.status}, {"cycle_time_s", each.cycle_time_s}});
    }
    document["diagnostics"] = text::to_json(diagnostics);
    return as_text(document);
}

std::string findings_sarif(std::span<const Diagnostic> diagnostics) {
    Json results = Json::array();
    for (const Diagnostic& diagnostic : diagnostics) results.push_back(sarif_result(diagnostic));
    Json driver = {{"name", "gsim"}, {"version", version()}, {"rules", sarif_rules(diagnostics)}};
    Json run = {{"tool", {{"driver", std::move(driver)}}}, {"results", std::move(results)}};
    return as_text(
        {{"$schema", kSarifSchema}, {"version", "2.1.0"}, {"runs", Json::array({std::move(run)})}});
}

}  // namespace gsim::apps
