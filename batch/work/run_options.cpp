#include "batch/work/run_options.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"

namespace gsim::batch {

namespace {

using nlohmann::json;
using Kind = RunOption::Kind;

constexpr std::array kOptions{
    RunOption{"dialect", Kind::text, "language of the programs; default: as in the machine file",
              [](JobRequest& r, const json& v) { r.run.language.dialect = v; }},
    RunOption{"unknown", Kind::text,
              "\"error\" or \"warn\": treatment of codes that the dialect does not have",
              [](JobRequest& r, const json& v) { r.run.language.unknown = v; }},
    RunOption{"machine_data", Kind::file, "machine data (NCFILE)",
              [](JobRequest& r, const json& v) { r.run.machine_data = v; }},
    RunOption{"cell", Kind::file, "cell file", [](JobRequest& r, const json& v) { r.run.cell = v; }},
    RunOption{"setup", Kind::file, "script that runs before the program",
              [](JobRequest& r, const json& v) { r.run.setup = v; }},
    RunOption{"robots", Kind::file, "robots and conveyors",
              [](JobRequest& r, const json& v) { r.run.robots = v; }},
    RunOption{"variables", Kind::file, "permanent variables; they are read, not written",
              [](JobRequest& r, const json& v) { r.run.variables = v; }},
    RunOption{"library", Kind::file, "folder with the Lua library",
              [](JobRequest& r, const json& v) { r.run.library = v; }},
    RunOption{"module", Kind::file, "controller module",
              [](JobRequest& r, const json& v) { r.run.module = v; }},
    RunOption{"probe", Kind::text, "surface that probes touch: \"none\", \"z=-3.2\"",
              [](JobRequest& r, const json& v) { r.run.probe = v; }},
    RunOption{"overrides", Kind::file, "changes of the overrides during the run",
              [](JobRequest& r, const json& v) { r.run.overrides.file = v; }},
    RunOption{"feed_override_percent", Kind::number, "override of the complete run",
              [](JobRequest& r, const json& v) { r.run.overrides.feed_percent = v.get<double>(); }},
    RunOption{"rapid_override_percent", Kind::number, "override of the complete run",
              [](JobRequest& r, const json& v) { r.run.overrides.rapid_percent = v.get<double>(); }},
    RunOption{"spindle_override_percent", Kind::number, "override of the complete run",
              [](JobRequest& r, const json& v) { r.run.overrides.spindle_percent = v.get<double>(); }},
    RunOption{"collisions", Kind::flag, "check the bodies of machines and cells for collisions",
              [](JobRequest& r, const json& v) { r.run.collisions = v; }},
    RunOption{"block_delete", Kind::flag, "skip blocks that begin with /",
              [](JobRequest& r, const json& v) { r.run.execution.block_delete = v; }},
    RunOption{"optional_stop", Kind::flag, "stop at M01",
              [](JobRequest& r, const json& v) { r.run.execution.optional_stop = v; }},
    RunOption{"stop_at_first", Kind::flag, "the first violation ends the run",
              [](JobRequest& r, const json& v) { r.run.execution.stop_at_first = v; }},
    RunOption{"passes", Kind::count, "number of runs of a main program that returns to its start",
              [](JobRequest& r, const json& v) { r.run.execution.passes = v; }},
    RunOption{"max_time_s", Kind::number, "max machine time",
              [](JobRequest& r, const json& v) { r.run.limits.machine_s = v; }},
    RunOption{"max_cpu_s", Kind::number, "max processor time",
              [](JobRequest& r, const json& v) { r.run.limits.cpu_s = v; }},
    RunOption{"max_blocks", Kind::count, "max number of executed blocks",
              [](JobRequest& r, const json& v) { r.run.limits.blocks = v; }},
    RunOption{"max_steps", Kind::count, "max steps of scripts without a motion",
              [](JobRequest& r, const json& v) { r.run.limits.steps = v; }},
    RunOption{"lower_bound", Kind::flag, "also compute the min time that is possible with any controller",
              [](JobRequest& r, const json& v) { r.run.explain = v; }},
    RunOption{"joint_speeds", Kind::flag, "also compute the max ratio of the speed of an axis to its limit",
              [](JobRequest& r, const json& v) { r.joint_speeds = v; }},
    RunOption{"post", Kind::file, "post of the paths; default: the dialect of the machine",
              [](JobRequest& r, const json& v) { r.path.post = v; }},
    RunOption{"path_frame", Kind::text, "frame or object of the cell with which paths move",
              [](JobRequest& r, const json& v) { r.path_frame = v; }},
    RunOption{"rotary_as_given", Kind::flag, "rotary_deg of paths is used unchanged",
              [](JobRequest& r, const json& v) { r.path.rotary_as_given = v.get<bool>(); }},
};

std::string_view kind_text(Kind kind) {
    switch (kind) {
        case Kind::flag: return "true or false";
        case Kind::number: return "a number";
        case Kind::count: return "an integer from 1 on";
        case Kind::text:
        case Kind::file: break;
    }
    return "a string";
}

bool has_kind(const json& value, Kind kind) {
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

Result<void> check_option(std::string_view name, const json& value) {
    const RunOption* option = find_option(name);
    if (option == nullptr) {
        std::vector<std::string_view> names;
        names.reserve(kOptions.size());
        for (const RunOption& each : kOptions) names.emplace_back(each.name);
        const auto nearest = text::nearest_name(name, names);
        return tl::unexpected(
            nearest ? fmt::format("unknown option '{}'; did you mean '{}'?", name, *nearest)
                    : fmt::format("unknown option '{}'; known options: {}", name, text::joined(names, ", ")));
    }
    if (has_kind(value, option->kind)) return {};
    return Unexpected(fmt::format("'{}' must be {}, not {}", name, kind_text(option->kind), value.dump()));
}

Result<void> set_option(JobRequest& request, std::string_view name, const json& value) {
    return check_option(name, value).map([&] { find_option(name)->set(request, value); });
}

}  // namespace gsim::batch
