#include "machine/model/figure.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/text/format.h"
#include "machine/file/times_section.h"

namespace gsim::machine {

namespace {

struct AxisFigure {
    std::string_view linear, rotary;  ///< Its keys.
    double Axis::*value;
};
constexpr std::array kAxisFigures{
    AxisFigure{"max_speed_mm_s", "max_speed_deg_s", &Axis::max_speed},
    AxisFigure{"max_acceleration_mm_s2", "max_acceleration_deg_s2", &Axis::max_acceleration},
    AxisFigure{"max_jerk_mm_s3", "max_jerk_deg_s3", &Axis::max_jerk}};

struct PathFigure {
    std::string_view key;
    double PathLimits::*value;
};
constexpr std::array kPathFigures{
    PathFigure{"max_feed_mm_s", &PathLimits::max_feed_mm_s},
    PathFigure{"max_rapid_mm_s", &PathLimits::max_rapid_mm_s},
    PathFigure{"max_acceleration_mm_s2", &PathLimits::max_acceleration_mm_s2},
    PathFigure{"max_rapid_acceleration_mm_s2", &PathLimits::max_rapid_acceleration_mm_s2}};

struct RuleFigure {
    std::string_view key;
    double rrs::ControllerRules::*value;
};
constexpr std::array kRuleFigures{
    RuleFigure{"speed_step_s", &rrs::ControllerRules::speed_step_s},
    RuleFigure{"junction_deviation_mm", &rrs::ControllerRules::junction_deviation_mm},
    RuleFigure{"blend_tolerance_mm", &rrs::ControllerRules::blend_tolerance_mm},
    RuleFigure{"centripetal_share", &rrs::ControllerRules::centripetal_share},
    RuleFigure{"continuous_acceleration_share", &rrs::ControllerRules::continuous_acceleration_share},
    RuleFigure{"block_time_s", &rrs::ControllerRules::block_time_s},
    RuleFigure{"servo_period_s", &rrs::ControllerRules::servo_period_s},
    RuleFigure{"settle_s", &rrs::ControllerRules::settle_s},
    RuleFigure{"rest_s", &rrs::ControllerRules::rest_s}};

template <typename Figures>
auto member_of(const Figures& figures, std::string_view key) -> decltype(figures.front().value) {
    for (const auto& figure : figures) {
        if (figure.key == key) return figure.value;
    }
    return nullptr;
}

double Axis::*member_of_axis(const Axis& axis, std::string_view key) {
    for (const AxisFigure& figure : kAxisFigures) {
        if ((axis.kind == AxisKind::rotary ? figure.rotary : figure.linear) == key) return figure.value;
    }
    return nullptr;
}

/// Returns all positions of the parameter in a machine; none if one of them is missing.
template <typename AMachine>
auto places_of(const Figure& figure, AMachine& machine) {
    std::vector<decltype(&machine.path.max_feed_mm_s)> places;
    if (figure.of == "path") {
        if (const auto member = member_of(kPathFigures, figure.key))
            places.push_back(&(machine.path.*member));
        return places;
    }
    if (figure.of == "controller") {
        if (const auto member = member_of(kRuleFigures, figure.key))
            places.push_back(&(machine.controller.*member));
        return places;
    }
    if (figure.of == "times") {
        if (auto* place = time_at(figure.key, machine.times)) places.push_back(place);
        return places;
    }
    for (const char letter : figure.of) {
        const auto before = places.size();
        for (auto& axis : machine.axes) {
            const auto member = axis.letter == letter ? member_of_axis(axis, figure.key) : nullptr;
            if (member != nullptr) places.push_back(&(axis.*member));
        }
        if (places.size() == before) return decltype(places){};
    }
    return places;
}

}  // namespace

std::string name_of(const Figure& figure) {
    if (figure.of == "path" || figure.of == "controller" || figure.of == "times")
        return fmt::format("{}: {}", figure.of, figure.key);
    std::vector<std::string> letters;
    for (const char letter : figure.of) letters.emplace_back(1, letter);
    return fmt::format("{} {}: {}", letters.size() == 1 ? "axis" : "axes", text::joined(letters, ", "),
                       figure.key);
}

std::optional<double> value_of(const Figure& figure, const Machine& machine) {
    const auto places = places_of(figure, machine);
    if (places.empty()) return std::nullopt;
    return *places.front();
}

void set_value(const Figure& figure, double value, Machine& machine) {
    for (double* place : places_of(figure, machine)) *place = value;
}

}  // namespace gsim::machine
