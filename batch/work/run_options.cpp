#include "batch/work/run_options.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "base/text/nearest_name.h"

namespace gsim::batch {

namespace {

using engine::Request;
using nlohmann::json;
using Kind = RunOption::Kind;

constexpr std::array kOptions{
    RunOption{"dialect", Kind::text, "language of the programs; else as the machine file says",
              [](Request& r, const json& v) { r.language.dialect = v; }},
    RunOption{"unknown", Kind::text, "\"error\" or \"warn\": what a code is that the dialect does not have",
              [](Request& r, const json& v) { r.language.unknown = v; }},
    RunOption{"machine_data", Kind::file, "machine data (NCFILE)",
              [](Request& r, const json& v) { r.machine_data = v; }},
    RunOption{"cell", Kind::file, "cell file", [](Request& r, const json& v) { r.cell = v; }},
    RunOption{"setup", Kind::file, "script that runs before the program",
              [](Request& r, const json& v) { r.setup = v; }},
    RunOption{"robots", Kind::file, "robots and conveyors", [](Request& r, const json& v) { r.robots = v; }},
    RunOption{"variables", Kind::file, "permanent variables; they are read, not written",
              [](Request& r, const json& v) { r.variables = v; }},
    RunOption{"library", Kind::file, "folder of the library in Lua",
              [](Request& r, const json& v) { r.library = v; }},
    RunOption{"module", Kind::file, "controller module", [](Request& r, const json& v) { r.module = v; }},
    RunOption{"probe", Kind::text, "what probes touch: \"none\", \"z=-3.2\"",
              [](Request& r, const json& v) { r.probe = v; }},
    RunOption{"overrides", Kind::file, "changes of the overrides in the course of the run",
              [](Request& r, const json& v) { r.overrides.file = v; }},
    RunOption{"feed_override_percent", Kind::number, "of the whole run",
              [](Request& r, const json& v) { r.overrides.feed_percent = v.get<double>(); }},
    RunOption{"rapid_override_percent", Kind::number, "of the whole run",
              [](Request& r, const json& v) { r.overrides.rapid_percent = v.get<double>(); }},
    RunOption{"spindle_override_percent", Kind::number, "of the whole run",
              [](Request& r, const json& v) { r.overrides.spindle_percent = v.get<double>(); }},
    RunOption{"collisions", Kind::flag, "look at the bodies of machines and cells",
              [](Request& r, const json& v) { r.collisions = v; }},
    RunOption{"block_delete", Kind::flag, "leave out blocks that begin with /",
              [](Request& r, const json& v) { r.block_delete = v; }},
    RunOption{"optional_stop", Kind::flag, "M01 stops",
              [](Request& r, const json& v) { r.optional_stop = v; }},
    RunOption{"stop_at_first", Kind::flag, "the first violation ends the run",
              [](Request& r, const json& v) { r.stop_at_first = v; }},
    RunOption{"passes", Kind::count, "of a main program that leads back to its start",
              [](Request& r, const json& v) { r.passes = v; }},
    RunOption{"max_time_s", Kind::number, "of the machine",
              [](Request& r, const json& v) { r.limits.machine_s = v; }},
    RunOption{"max_cpu_s", Kind::number, "of the processor",
              [](Request& r, const json& v) { r.limits.cpu_s = v; }},
    RunOption{"max_blocks", Kind::count, "that are executed",
              [](Request& r, const json& v) { r.limits.blocks = v; }},
    RunOption{"max_steps", Kind::count, "of scripts without a motion",
              [](Request& r, const json& v) { r.limits.steps = v; }},
};

std::string_view wanted(Kind kind) {
    switch (kind) {
        case Kind::flag: return "true or false";
        case Kind::number: return "a number";
        case Kind::count: return "a whole number from 1 on";
        case Kind::text:
        case Kind::file: break;
    }
    return "a text";
}

bool is_of_kind(const json& value, Kind kind) {
    switch (kind) {
        case Kind::flag: return value.is_boolean();
        case Kind::number: return value.is_number();
        case Kind::count: return value.is_number_integer() && value > 0;
        case Kind::text:
        case Kind::file: break;
    }
    return value.is_string();
}

}  // namespace

std::span<const RunOption> run_options() {
    return kOptions;
}

const RunOption* find_option(std::string_view name) {
    const auto* const found = std::find_if(kOptions.begin(), kOptions.end(),
                                           [name](const RunOption& option) { return option.name == name; });
    return found == kOptions.end() ? nullptr : found;
}

tl::expected<void, std::string> check_option(std::string_view name, const json& value) {
    const RunOption* option = find_option(name);
    if (option == nullptr) {
        std::vector<std::string_view> names;
        names.reserve(kOptions.size());
        for (const RunOption& each : kOptions) names.emplace_back(each.name);
        const auto nearest = text::nearest_name(name, names);
        return tl::unexpected(
            nearest ? fmt::format("there is no option '{}'; did you mean '{}'?", name, *nearest)
                    : fmt::format("there is no option '{}'; there are: {}", name, fmt::join(names, ", ")));
    }
    if (is_of_kind(value, option->kind)) return {};
    return tl::unexpected(fmt::format("'{}' must be {}, not {}", name, wanted(option->kind), value.dump()));
}

tl::expected<void, std::string> set_option(Request& request, std::string_view name, const json& value) {
    return check_option(name, value).map([&] { find_option(name)->set(request, value); });
}

}  // namespace gsim::batch
