#include "toolpath/model/active_modes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace gsim::path {

namespace {

constexpr std::string_view kOffSuffix = "_off";
constexpr std::array<std::string_view, 2> kMistOn = {"mist_on", "coolant_2_on"};
constexpr std::array<std::string_view, 2> kFloodOn = {"flood_on", "waterjet_on"};
constexpr std::array<std::string_view, 2> kCoolantOff = {"coolant_off", "waterjet_off"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_spindle_on(const std::string& spindle) {
    return spindle == "spindle_cw" || spindle == "spindle_ccw";
}

}  // namespace

void ActiveModes::merge(const ActiveModes& other) {
    spindle.merge(other.spindle);
    speed.merge(other.speed);
    flood.merge(other.flood);
    mist.merge(other.mist);
}

void ActiveModes::pass(const std::string& action) {
    if (action.starts_with("spindle_")) spindle = Inherited<std::string>(action);
    if (action.starts_with("speed ")) speed = Inherited<std::string>(action);
    if (is_one_of(kMistOn, action)) mist = Inherited<std::string>(action);
    if (is_one_of(kFloodOn, action)) flood = Inherited<std::string>(action);
    if (is_one_of(kCoolantOff, action)) flood = mist = Inherited<std::string>(action);
}

void ActiveModes::set(const ActiveModes& later) {
    spindle.set(later.spindle);
    speed.set(later.speed);
    flood.set(later.flood);
    mist.set(later.mist);
}

bool is_tool_change(const std::string& action) {
    return action == "tool_change" || action.starts_with("tool_change ");
}

Result<std::vector<std::string>> restore_actions(const ActiveModes& active_modes,
                                                 const ToolChangeStops& stops) {
    std::vector<std::string> actions;
    const auto make_error = [](std::string_view what) {
        return Unexpected(
            fmt::format("this controller stops the {0} to change the tool, and the paths that lead to this "
                        "change have different states of it; switch it by an action before the change",
                        what));
    };
    if (stops.spindle) {
        if (active_modes.spindle.differs()) return make_error("spindle");
        const std::string spindle = active_modes.spindle.value().value_or("");
        if (is_spindle_on(spindle)) {
            if (const auto& speed = active_modes.speed.value()) actions.push_back(*speed);
            actions.push_back(spindle);
        }
    }
    if (!stops.coolant) return actions;
    for (const auto* coolant : {&active_modes.mist, &active_modes.flood}) {
        if (coolant->differs()) return make_error("coolant");
        const std::string action = coolant->value().value_or("");
        if (!action.empty() && !action.ends_with(kOffSuffix)) actions.push_back(action);
    }
    return actions;
}

Result<std::vector<std::string>> insert_restore_actions(const std::vector<std::string>& actions,
                                                        ActiveModes active_modes,
                                                        const ToolChangeStops& stops) {
    std::vector<std::string> all;
    for (const std::string& action : actions) {
        all.push_back(action);
        active_modes.pass(action);
        if (!is_tool_change(action)) continue;
        auto restored = restore_actions(active_modes, stops);
        if (!restored) return restored;
        all.insert(all.end(), restored->begin(), restored->end());
    }
    return all;
}

}  // namespace gsim::path
