#include "toolpath/model/running.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace gsim::path {

namespace {

constexpr std::string_view kOff = "_off";
constexpr std::array<std::string_view, 2> kMist = {"mist_on", "coolant_2_on"};
constexpr std::array<std::string_view, 2> kFlood = {"flood_on", "waterjet_on"};
constexpr std::array<std::string_view, 2> kNoCoolant = {"coolant_off", "waterjet_off"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool turns(const std::string& spindle) {
    return spindle == "spindle_cw" || spindle == "spindle_ccw";
}

}  // namespace

void Running::merge(const Running& other) {
    spindle.merge(other.spindle);
    speed.merge(other.speed);
    flood.merge(other.flood);
    mist.merge(other.mist);
}

void Running::pass(const std::string& action) {
    if (action.starts_with("spindle_")) spindle = Inherited<std::string>(action);
    if (action.starts_with("speed ")) speed = Inherited<std::string>(action);
    if (is_one_of(kMist, action)) mist = Inherited<std::string>(action);
    if (is_one_of(kFlood, action)) flood = Inherited<std::string>(action);
    if (is_one_of(kNoCoolant, action)) flood = mist = Inherited<std::string>(action);
}

void Running::set(const Running& later) {
    spindle.set(later.spindle);
    speed.set(later.speed);
    flood.set(later.flood);
    mist.set(later.mist);
}

bool is_tool_change(const std::string& action) {
    return action == "tool_change" || action.starts_with("tool_change ");
}

tl::expected<std::vector<std::string>, std::string> restored(const Running& running,
                                                             const ToolChangeStops& stops) {
    std::vector<std::string> actions;
    const auto fault = [](std::string_view what) {
        return tl::unexpected(
            fmt::format("this control stops the {0} to change the tool, and the places that lead to this "
                        "change hand over "
                        "different states of it; switch it by an action in front of the change",
                        what));
    };
    if (stops.spindle) {
        if (running.spindle.differs()) return fault("spindle");
        const std::string spindle = running.spindle.value().value_or("");
        if (turns(spindle)) {
            if (const auto& speed = running.speed.value()) actions.push_back(*speed);
            actions.push_back(spindle);
        }
    }
    if (!stops.coolant) return actions;
    for (const auto* coolant : {&running.mist, &running.flood}) {
        if (coolant->differs()) return fault("coolant");
        const std::string action = coolant->value().value_or("");
        if (!action.empty() && !action.ends_with(kOff)) actions.push_back(action);
    }
    return actions;
}

tl::expected<std::vector<std::string>, std::string> with_restored(const std::vector<std::string>& actions,
                                                                  Running running,
                                                                  const ToolChangeStops& stops) {
    std::vector<std::string> all;
    for (const std::string& action : actions) {
        all.push_back(action);
        running.pass(action);
        if (!is_tool_change(action)) continue;
        auto again = restored(running, stops);
        if (!again) return again;
        all.insert(all.end(), again->begin(), again->end());
    }
    return all;
}

}  // namespace gsim::path
