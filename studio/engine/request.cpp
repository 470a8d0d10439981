#include "studio/engine/request.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "studio/engine/keys.h"

namespace gsim::studio {

namespace {

using engine::Request;

struct TextKey {
    const char* key;
    std::string& (*place)(Request&);
};
struct NumberKey {
    const char* key;
    double least, most;
    void (*put)(Request&, double);
};
struct SwitchKey {
    const char* key;
    bool Request::*place;
};

constexpr double kMostPercent = 1000;
constexpr double kMostCount = 1e15;
constexpr double kMostPasses = 1e6;
constexpr double kLeastTime_s = 1e-6;

constexpr std::array kTexts = {
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
constexpr std::array kNumbers = {
    NumberKey{"machine_s", kLeastTime_s, kMostCount,
              [](Request& of, double value) { of.limits.machine_s = value; }},
    NumberKey{"cpu_s", kLeastTime_s, kMostCount, [](Request& of, double value) { of.limits.cpu_s = value; }},
    NumberKey{"blocks", 1, kMostCount,
              [](Request& of, double value) { of.limits.blocks = static_cast<std::uint64_t>(value); }},
    NumberKey{"steps", 1, kMostCount,
              [](Request& of, double value) { of.limits.steps = static_cast<std::uint64_t>(value); }},
    NumberKey{"memory_bytes", 1, kMostCount,
              [](Request& of, double value) { of.limits.memory_bytes = static_cast<std::uint64_t>(value); }},
    NumberKey{"passes", 1, kMostPasses,
              [](Request& of, double value) { of.passes = static_cast<std::uint64_t>(value); }},
    NumberKey{"feed_override_percent", 0, kMostPercent,
              [](Request& of, double value) { of.overrides.feed_percent = value; }},
    NumberKey{"rapid_override_percent", 0, kMostPercent,
              [](Request& of, double value) { of.overrides.rapid_percent = value; }},
    NumberKey{"spindle_override_percent", 0, kMostPercent,
              [](Request& of, double value) { of.overrides.spindle_percent = value; }},
};
constexpr std::array kSwitches = {
    SwitchKey{"stop_at_first", &Request::stop_at_first}, SwitchKey{"collisions", &Request::collisions},
    SwitchKey{"block_delete", &Request::block_delete}, SwitchKey{"optional_stop", &Request::optional_stop},
    SwitchKey{"explain", &Request::explain}};

/// Returns the row of a key; null: not found.
template <typename Rows>
const auto* row_of(const Rows& rows, const std::string& key) {
    for (const auto& row : rows) {
        if (key == row.key) return &row;
    }
    return static_cast<decltype(rows.data())>(nullptr);
}

tl::expected<void, std::string> put(Request& request, const std::string& key, const nlohmann::json& value) {
    const auto fault = [&](const std::string& wanted) {
        return tl::unexpected(fmt::format("'{}' should be {}, not {}", key, wanted, shown(value)));
    };
    if (const TextKey* text = row_of(kTexts, key)) {
        if (!value.is_string()) return fault("a text");
        text->place(request) = value.get<std::string>();
        return {};
    }
    if (const NumberKey* number = row_of(kNumbers, key)) {
        if (!value.is_number()) return fault("a number");
        const auto given = value.get<double>();
        if (!(given >= number->least && given <= number->most))
            return fault(fmt::format("from {} to {}", number->least, number->most));
        number->put(request, given);
        return {};
    }
    if (const SwitchKey* key_of_switch = row_of(kSwitches, key)) {
        if (!value.is_boolean()) return fault("true or false");
        request.*key_of_switch->place = value.get<bool>();
        return {};
    }
    return tl::unexpected(fmt::format("there is no key '{}' of a run", key));
}

}  // namespace

tl::expected<Request, std::string> run_request(const nlohmann::json& asked) {
    if (!asked.is_object()) return tl::unexpected(std::string("a request should be an object"));
    Request request;
    for (const auto& [key, value] : asked.items()) {
        if (auto done = put(request, key, value); !done) return tl::unexpected(done.error());
    }
    return request;
}

tl::expected<Request, std::string> form_request(nlohmann::json& asked) {
    Request request;
    for (const char* key : {"machine", "machine_data", "cell"}) {
        const auto value = asked.find(key);
        if (value == asked.end()) continue;
        if (auto done = put(request, key, *value); !done) return tl::unexpected(done.error());
        asked.erase(value);
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
