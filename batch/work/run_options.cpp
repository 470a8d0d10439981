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
    RunOption{"dialect", Kind::text, "language of the programs; else as the machine file says",
              [](JobRequest& r, const json& v) { r.run.language.dialect = v; }},
    RunOption{"unknown", Kind::text, "\"error\" or \"warn\": what a code is that the dialect does not have",
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
    RunOption{"library", Kind::file, "folder of the library in Lua",
              [](JobRequest& r, const json& v) { r.run.library = v; }},
    RunOption{"module", Kind::file, "controller module",
              [](JobRequest& r, const json& v) { r.run.module = v; }},
    RunOption{"probe", Kind::text, "what probes touch: \"none\", \"z=-3.2\"",
              [](JobRequest& r, const json& v) { r.run.probe = v; }},
    RunOption{"overrides", Kind::file, "changes of the overrides in the course of the run",
              [](JobRequest& r, const json& v) { r.run.overrides.file = v; }},
    RunOption{"feed_override_percent", Kind::number, "of the whole run",
              [](JobRequest& r, const json& v) { r.run.overrides.feed_percent = v.get<double>(); }},
    RunOption{"rapid_override_percent", Kind::number, "of the whole run",
              [](JobRequest& r, const json& v) { r.run.overrides.rapid_percent = v.get<double>(); }},
    RunOption{"spindle_override_percent", Kind::number, "of the whole run",
              [](JobRequest& r, const json& v) { r.run.overrides.spindle_percent = v.get<double>(); }},
    RunOption{"collisions", Kind::flag, "look at the bodies of machines and cells",
              [](JobRequest& r, const json& v) { r.run.collisions = v; }},
    RunOption{"block_delete", Kind::flag, "leave out blocks that begin with /",
              [](JobRequest& r, const json& v) { r.run.block_delete = v; }},
    RunOption{"optional_stop", Kind::flag, "M01 stops",
              [](JobRequest& r, const json& v) { r.run.optional_stop = v; }},
    RunOption{"stop_at_first", Kind::flag, "the first violation ends the run",
              [](JobRequest& r, const json& v) { r.run.stop_at_first = v; }},
    RunOption{"passes", Kind::count, "of a main program that leads back to its start",
              [](JobRequest& r, const json& v) { r.run.passes = v; }},
    RunOption{"max_time_s", Kind::number, "of the machine",
              [](JobRequest& r, const json& v) { r.run.limits.machine_s = v; }},
    RunOption{"max_cpu_s", Kind::number, "of the processor",
              [](JobRequest& r, const json& v) { r.run.limits.cpu_s = v; }},
    RunOption{"max_blocks", Kind::count, "that are executed",
              [](JobRequest& r, const json& v) { r.run.limits.blocks = v; }},
    RunOption{"max_steps", Kind::count, "of scripts without a motion",
              [](JobRequest& r, const json& v) { r.run.limits.steps = v; }},
    RunOption{"lower_bound", Kind::flag, "the least time in which any controller could do it, too",
              [](JobRequest& r, const json& v) { r.run.explain = v; }},
    RunOption{"joint_speeds", Kind::flag,
              "the greatest share of its limit that the speed of an axis comes to, too",
              [](JobRequest& r, const json& v) { r.joint_speeds = v; }},
    RunOption{"post", Kind::file, "how programs of paths are written; else as the machine reads them",
              [](JobRequest& r, const json& v) { r.path.post = v; }},
    RunOption{"path_frame", Kind::text, "frame or object of the cell that paths go along with",
              [](JobRequest& r, const json& v) { r.path_frame = v; }},
    RunOption{"rotary_as_given", Kind::flag, "rotary_deg of paths is taken as it is",
              [](JobRequest& r, const json& v) { r.path.rotary_as_given = v.get<bool>(); }},
};

std::string_view kind_text(Kind kind) {
    switch (kind) {
        case Kind::flag: return "true or false";
        case Kind::number: return "a number";
        case Kind::count: return "a whole number from 1 on";
        case Kind::text:
        case Kind::file: break;
    }
    return "a text";
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

tl::expected<void, std::string> check_option(std::string_view name, const json& value) {
    const RunOption* option = find_option(name);
    if (option == nullptr) {
        std::vector<std::string_view> names;
        names.reserve(kOptions.size());
        for (const RunOption& each : kOptions) names.emplace_back(each.name);
        const auto nearest = text::nearest_name(name, names);
        return tl::unexpected(
            nearest ? fmt::format("there is no option '{}'; did you mean '{}'?", name, *nearest)
                    : fmt::format("there is no option '{}'; there are: {}", name, text::joined(names, ", ")));
    }
    if (has_kind(value, option->kind)) return {};
    return tl::unexpected(
        fmt::format("'{}' must be {}, not {}", name, kind_text(option->kind), value.dump()));
}

tl::expected<void, std::string> set_option(JobRequest& request, std::string_view name, const json& value) {
    return check_option(name, value).map([&] { find_option(name)->set(request, value); });
}

}  // namespace gsim::batch
