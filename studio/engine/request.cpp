#include "studio/engine/request.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "studio/engine/key_reader.h"

namespace gsim::studio {

namespace {

using engine::Request;

struct TextKey {
    const char* key;
    std::string& (*target)(Request&);
};
struct NumberKey {
    const char* key;
    double min, max;
    void (*set)(Request&, double);
};
struct SwitchKey {
    const char* key;
    bool& (*target)(Request&);
};

constexpr double kMaxPercent = 1000;
constexpr double kMaxCount = 1e15;
constexpr double kMaxPasses = 1e6;
constexpr double kMinTime_s = 1e-6;

constexpr std::array kTextKeys = {
    TextKey{"program", [](Request& of) -> std::string& { return of.program; }},
    TextKey{"machine", [](Request& of) -> std::string& { return of.machine; }},
    TextKey{"machine_data", [](Request& of) -> std::string& { return of.machine_data; }},
    TextKey{"cell", [](Request& of) -> std::string& { return of.cell; }},
    TextKey{"setup", [](Request& of) -> std::string& { return of.setup; }},
    TextKey{"robots", [](Request& of) -> std::string& { return of.robots; }},
    TextKey{"variables", [](Request& of) -> std::string& { return of.variables; }},
    TextKey{"probe", [](Request& of) -> std::string& { return of.probe; }},
    TextKey{"dialect", [](Request& of) -> std::string& { return of.language.dialect; }},
    TextKey{"unknown", [](Request& of) -> std::string& { return of.language.unknown; }},
    TextKey{"overrides", [](Request& of) -> std::string& { return of.overrides.file; }},
};
constexpr std::array kNumberKeys = {
    NumberKey{"machine_s", kMinTime_s, kMaxCount,
              [](Request& of, double value) { of.limits.machine_s = value; }},
    NumberKey{"cpu_s", kMinTime_s, kMaxCount, [](Request& of, double value) { of.limits.cpu_s = value; }},
    NumberKey{"blocks", 1, kMaxCount,
              [](Request& of, double value) { of.limits.blocks = static_cast<std::uint64_t>(value); }},
    NumberKey{"steps", 1, kMaxCount,
              [](Request& of, double value) { of.limits.steps = static_cast<std::uint64_t>(value); }},
    NumberKey{"memory_bytes", 1, kMaxCount,
              [](Request& of, double value) { of.limits.memory_bytes = static_cast<std::uint64_t>(value); }},
    NumberKey{"passes", 1, kMaxPasses,
              [](Request& of, double value) { of.execution.passes = static_cast<std::uint64_t>(value); }},
    NumberKey{"feed_override_percent", 0, kMaxPercent,
              [](Request& of, double value) { of.overrides.feed_percent = value; }},
    NumberKey{"rapid_override_percent", 0, kMaxPercent,
              [](Request& of, double value) { of.overrides.rapid_percent = value; }},
    NumberKey{"spindle_override_percent", 0, kMaxPercent,
              [](Request& of, double value) { of.overrides.spindle_percent = value; }},
};
constexpr std::array kSwitches = {
    SwitchKey{"stop_at_first", [](Request& of) -> bool& { return of.execution.stop_at_first; }},
    SwitchKey{"collisions", [](Request& of) -> bool& { return of.collisions; }},
    SwitchKey{"block_delete", [](Request& of) -> bool& { return of.execution.block_delete; }},
    SwitchKey{"optional_stop", [](Request& of) -> bool& { return of.execution.optional_stop; }},
    SwitchKey{"explain", [](Request& of) -> bool& { return of.explain; }}};

/// Returns the row of a key; null: not found.
template <typename Rows>
const auto* find_row(const Rows& rows, const std::string& key) {
    for (const auto& row : rows) {
        if (key == row.key) return &row;
    }
    return static_cast<decltype(rows.data())>(nullptr);
}

Result<void> set(Request& request, const std::string& key, const nlohmann::json& value) {
    const auto error = [&](const std::string& expected_type) {
        return Unexpected(fmt::format("'{}' must be {}, not {}", key, expected_type, display_text(value)));
    };
    if (const TextKey* text = find_row(kTextKeys, key)) {
        if (!value.is_string()) return error("a string");
        text->target(request) = value.get<std::string>();
        return {};
    }
    if (const NumberKey* number = find_row(kNumberKeys, key)) {
        if (!value.is_number()) return error("a number");
        const auto parsed_value = value.get<double>();
        if (!(parsed_value >= number->min && parsed_value <= number->max))
            return error(fmt::format("from {} to {}", number->min, number->max));
        number->set(request, parsed_value);
        return {};
    }
    if (const SwitchKey* switch_key = find_row(kSwitches, key)) {
        if (!value.is_boolean()) return error("true or false");
        switch_key->target(request) = value.get<bool>();
        return {};
    }
    return Unexpected(fmt::format("unknown key '{}' of a run", key));
}

}  // namespace

Result<Request> run_request(const nlohmann::json& request_json) {
    if (!request_json.is_object()) return Unexpected("a request must be an object");
    Request request;
    for (const auto& [key, value] : request_json.items()) {
        if (auto done = set(request, key, value); !done) return tl::unexpected(done.error());
    }
    return request;
}

Result<Request> form_request(nlohmann::json& request_json) {
    Request request;
    for (const char* key : {"machine", "machine_data", "cell"}) {
        const auto value = request_json.find(key);
        if (value == request_json.end()) continue;
        if (auto done = set(request, key, *value); !done) return tl::unexpected(done.error());
        request_json.erase(value);
    }
    return request;
}

engine::TranslationRequest translation_request(const Request& run) {
    engine::TranslationRequest request;
    request.program = run.program;
    request.machine = run.machine;
    request.machine_data = run.machine_data;
    request.cell = run.cell;
    request.language = run.language;
    request.cpu_s = run.limits.cpu_s;
    request.host = run.host;
    request.cancel = run.cancel;
    return request;
}

}  // namespace gsim::studio
