#include "engine/findings.h"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "base/text/diagnostic_json.h"
#include "base/text/file_format.h"
#include "base/text/json.h"
#include "engine/src/values.h"
#include "engine/version.h"

namespace gsim::engine {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSarifSchema = "https://json.schemastore.org/sarif-2.1.0.json";

std::string as_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Returns a file's name as a reference (RFC 3986): characters that are not plain in a path are written as
/// bytes.
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

Json sarif_location(const Diagnostic& told) {
    Json physical;
    physical["artifactLocation"] = {{"uri", as_uri(told.file)}};
    if (told.line > 0) {
        Json& region = physical["region"];
        region["startLine"] = told.line;
        if (told.column > 0) region["startColumn"] = told.column;
        if (told.end_column > told.column) region["endColumn"] = told.end_column;
    }
    return {{"physicalLocation", physical}};
}

Json sarif_result(const Diagnostic& told) {
    const std::string hint = told.hint.empty() ? "" : "; " + told.hint;
    Json result;
    result["ruleId"] = told.code;
    result["level"] = text::name(static_cast<text::Severity>(told.severity));
    result["message"] = {{"text", told.text + hint}};
    if (!told.file.empty()) result["locations"] = Json::array({sarif_location(told)});
    return result;
}

Json sarif_rules(std::span<const Diagnostic> diagnostics) {
    std::set<std::string_view> codes;
    for (const Diagnostic& told : diagnostics) codes.insert(told.code);
    Json rules = Json::array();
    for (const text::DiagnosticKindEntry& entry : text::diagnostic_kinds()) {
        if (codes.contains(entry.code))
            rules.push_back({{"id", entry.code}, {"shortDescription", {{"text", entry.meaning}}}});
    }
    return rules;
}

}  // namespace

std::string text_of(const Diagnostic& told) {
    return text::to_text(inner_diagnostic(told));
}

Diagnostic diagnostic_of(const Failure& failure) {
    using text::DiagnosticKind;
    const auto kind = text::diagnostic_kind(failure.code).value_or(DiagnosticKind::internal);
    Diagnostic told = diagnostic_of(text::diagnostic_of(kind, failure.message));
    if (!told.file.empty() || failure.file.empty()) return told;
    told.file = failure.file;
    const std::string head = fmt::format("{}: ", failure.file);
    if (told.text.starts_with(head)) told.text.erase(0, head.size());
    return told;
}

std::string findings_json(std::span<const Diagnostic> diagnostics, std::span<const CheckedProgram> programs) {
    Json document = {{"format", text::kFileFormat}};
    for (const CheckedProgram& each : programs) {
        document["programs"].push_back(
            {{"program", each.name}, {"status", each.status}, {"cycle_time_s", each.cycle_time_s}});
    }
    std::vector<text::Diagnostic> inner;
    for (const Diagnostic& told : diagnostics) inner.push_back(inner_diagnostic(told));
    document["diagnostics"] = text::to_json(inner);
    return as_text(document);
}

std::string findings_sarif(std::span<const Diagnostic> diagnostics) {
    Json results = Json::array();
    for (const Diagnostic& told : diagnostics) results.push_back(sarif_result(told));
    Json driver = {{"name", "gsim"}, {"version", version()}, {"rules", sarif_rules(diagnostics)}};
    Json run = {{"tool", {{"driver", std::move(driver)}}}, {"results", std::move(results)}};
    return as_text(
        {{"$schema", kSarifSchema}, {"version", "2.1.0"}, {"runs", Json::array({std::move(run)})}});
}

}  // namespace gsim::engine
