#include "machine/model/machine_parameter.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/text/format.h"
#include "controller/services/rule_field.h"
#include "machine/file/times_section.h"

namespace gsim::machine {

namespace {

struct AxisParameter {
    std::string_view linear, rotary;  ///< Its keys.
    double Axis::*value;
};
constexpr std::array kAxisParameters{
    AxisParameter{"max_speed_mm_s", "max_speed_deg_s", &Axis::max_speed},
    AxisParameter{"max_acceleration_mm_s2", "max_acceleration_deg_s2", &Axis::max_acceleration},
    AxisParameter{"max_jerk_mm_s3", "max_jerk_deg_s3", &Axis::max_jerk}};

struct PathParameter {
    std::string_view key;
    double PathLimits::*value;
};
constexpr std::array kPathParameters{
    PathParameter{"max_feed_mm_s", &PathLimits::max_feed_mm_s},
    PathParameter{"max_rapid_mm_s", &PathLimits::max_rapid_mm_s},
    PathParameter{"max_acceleration_mm_s2", &PathLimits::max_acceleration_mm_s2},
    PathParameter{"max_rapid_acceleration_mm_s2", &PathLimits::max_rapid_acceleration_mm_s2}};

using Rules = rrs::ControllerRules;

struct RuleParameter {
    std::string_view key;
    rrs::RuleField<double> value;
};
constexpr std::array kRuleParameters{
    RuleParameter{"speed_step_s", rrs::rule_field<&Rules::corners, &rrs::CornerRules::speed_step_s>()},
    RuleParameter{"junction_deviation_mm",
                  rrs::rule_field<&Rules::corners, &rrs::CornerRules::junction_deviation_mm>()},
    RuleParameter{"blend_tolerance_mm",
                  rrs::rule_field<&Rules::corners, &rrs::CornerRules::blend_tolerance_mm>()},
    RuleParameter{"centripetal_share", rrs::rule_field<&Rules::ramps, &rrs::RampRules::centripetal_share>()},
    RuleParameter{"continuous_acceleration_share",
                  rrs::rule_field<&Rules::ramps, &rrs::RampRules::continuous_acceleration_share>()},
    RuleParameter{"block_time_s", rrs::rule_field<&Rules::blocks, &rrs::BlockRules::time_s>()},
    RuleParameter{"servo_period_s",
                  rrs::rule_field<&Rules::position_loop, &rrs::PositionLoopRules::servo_period_s>()},
    RuleParameter{"settle_s", rrs::rule_field<&Rules::position_loop, &rrs::PositionLoopRules::settle_s>()},
    RuleParameter{"standstill_s", rrs::rule_field<&Rules::standstill, &rrs::StandstillRules::dwell_s>()}};

template <typename Parameters>
auto find_member(const Parameters& parameters, std::string_view key) -> decltype(&parameters.front().value) {
    for (const auto& parameter_id : parameters) {
        if (parameter_id.key == key) return &parameter_id.value;
    }
    return nullptr;
}

double Axis::*find_axis_member(const Axis& axis, std::string_view key) {
    for (const AxisParameter& parameter_id : kAxisParameters) {
        if ((axis.kind == AxisKind::rotary ? parameter_id.rotary : parameter_id.linear) == key)
            return parameter_id.value;
    }
    return nullptr;
}

/// Returns all positions of the parameter in a machine; none if one of them is missing.
template <typename AMachine>
auto parameter_locations(const MachineParameter& parameter_id, AMachine& machine) {
    std::vector<decltype(&machine.path.max_feed_mm_s)> value_pointers;
    if (parameter_id.of == "path") {
        if (const auto* member = find_member(kPathParameters, parameter_id.key))
            value_pointers.push_back(&(machine.path.**member));
        return value_pointers;
    }
    if (parameter_id.of == "controller") {
        if (const auto* member = find_member(kRuleParameters, parameter_id.key))
            value_pointers.push_back(&(*member)(machine.controller));
        return value_pointers;
    }
    if (parameter_id.of == "times") {
        if (auto* value_pointer = word_time(parameter_id.key, machine.times))
            value_pointers.push_back(value_pointer);
        return value_pointers;
    }
    for (const char letter : parameter_id.of) {
        const auto before = value_pointers.size();
        for (auto& axis : machine.axes) {
            const auto member = axis.letter == letter ? find_axis_member(axis, parameter_id.key) : nullptr;
            if (member != nullptr) value_pointers.push_back(&(axis.*member));
        }
        if (value_pointers.size() == before) return decltype(value_pointers){};
    }
    return value_pointers;
}

}  // namespace

std::string parameter_name(const MachineParameter& parameter_id) {
    if (parameter_id.of == "path" || parameter_id.of == "controller" || parameter_id.of == "times")
        return fmt::format("{}: {}", parameter_id.of, parameter_id.key);
    std::vector<std::string> letters;
    for (const char letter : parameter_id.of) letters.emplace_back(1, letter);
    return fmt::format("{} {}: {}", letters.size() == 1 ? "axis" : "axes", text::joined(letters, ", "),
                       parameter_id.key);
}

std::optional<double> parameter_value(const MachineParameter& parameter_id, const Machine& machine) {
    const auto value_pointers = parameter_locations(parameter_id, machine);
    if (value_pointers.empty()) return std::nullopt;
    return *value_pointers.front();
}

void set_value(const MachineParameter& parameter_id, double value, Machine& machine) {
    for (double* value_pointer : parameter_locations(parameter_id, machine)) *value_pointer = value;
}

}  // namespace gsim::machine
