#include "machine/schema/controller_keys.h"

#include <array>

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/override_keys.h"
#include "machine/model/stop_keys.h"

namespace gsim::machine {

namespace {

using base::NumberRule;
using base::TomlSection;
using base::TomlWriter;

using Rules = rrs::ControllerRules;

struct NumberKey {
    std::string_view key;
    double Rules::*value;
    NumberRule rule;
};

struct FlagKey {
    std::string_view key;
    bool Rules::*value;
};

struct CornerKey {
    std::string_view key;
    rrs::CornerRule Rules::*value;
};

constexpr std::string_view kName = "name";
constexpr std::string_view kPlanner = "planner";
constexpr std::string_view kRelease = "linuxcnc_release";
constexpr std::string_view kLookAhead = "look_ahead_blocks";
constexpr std::array kSingleKeys{kModelKey,  kName,           kPlanner,  kRelease,
                                 kLookAhead, kOrientationKey, kStopsKey, kOverridesKey};

// Names of rrs::PlannerKind, rrs::LinuxcncRelease, rrs::CornerRule and rrs::OrientationRule in their order.
constexpr std::array<std::string_view, 4> kPlanners{"rest-to-rest", "look-ahead", "linuxcnc", "klipper"};
constexpr std::array<std::string_view, 2> kReleases{"2.9", "2.10"};
constexpr std::array<std::string_view, 5> kCorners{"stop", "velocity-step", "junction-deviation",
                                                   "parabolic-blend", "smooth-blend"};

constexpr std::array<std::string_view, 2> kOrientations{"joints", "great-circle"};

struct MeasureKey {
    std::string_view key;
    rrs::PathMeasure Rules::*value;
};

constexpr std::array<std::string_view, 2> kMeasures{"tool", "all-axes"};

constexpr std::array kMeasureKeys{
    MeasureKey{"path_measure", &Rules::path_measure},
    MeasureKey{"feed_measure", &Rules::feed_measure},
};

constexpr std::array kCornerKeys{
    CornerKey{"corner", &Rules::corner},
    CornerKey{"exact_path_corner", &Rules::exact_path_corner},
};

constexpr std::array kNumberKeys{
    NumberKey{"junction_deviation_mm", &Rules::junction_deviation_mm, NumberRule::not_negative},
    NumberKey{"blend_tolerance_mm", &Rules::blend_tolerance_mm, NumberRule::not_negative},
    NumberKey{"blend_tolerance_deg", &Rules::blend_tolerance_deg, NumberRule::not_negative},
    NumberKey{"speed_step_s", &Rules::speed_step_s, NumberRule::positive},
    NumberKey{"centripetal_share", &Rules::centripetal_share, NumberRule::positive},
    NumberKey{"continuous_acceleration_share", &Rules::continuous_acceleration_share, NumberRule::share},
    NumberKey{"block_time_s", &Rules::block_time_s, NumberRule::step},
    NumberKey{"tcp_tolerance_mm", &Rules::tcp_tolerance_mm, NumberRule::positive},
    NumberKey{"arc_chord_tolerance_mm", &Rules::arc_chord_tolerance_mm, NumberRule::step},
    NumberKey{"spline_chord_tolerance_mm", &Rules::spline_chord_tolerance_mm, NumberRule::step},
    NumberKey{"ramp_step_s", &Rules::ramp_step_s, NumberRule::step},
    NumberKey{"peck_clearance_mm", &Rules::peck_clearance_mm, NumberRule::not_negative},
    NumberKey{"peck_dwell_s", &Rules::peck_dwell_s, NumberRule::not_negative},
    NumberKey{"arc_resolution_mm", &Rules::arc_resolution_mm, NumberRule::step},
    NumberKey{"square_corner_velocity_mm_s", &Rules::square_corner_velocity_mm_s, NumberRule::not_negative},
    NumberKey{"minimum_cruise_ratio", &Rules::minimum_cruise_ratio, NumberRule::part},
    NumberKey{"retract_length_mm", &Rules::retract_length_mm, NumberRule::not_negative},
    NumberKey{"retract_speed_mm_s", &Rules::retract_speed_mm_s, NumberRule::positive},
    NumberKey{"unretract_extra_length_mm", &Rules::unretract_extra_length_mm, NumberRule::not_negative},
    NumberKey{"unretract_speed_mm_s", &Rules::unretract_speed_mm_s, NumberRule::positive},
    NumberKey{"least_feed_mm_min", &Rules::min_feed_mm_min, NumberRule::not_negative},
    NumberKey{"settle_s", &Rules::settle_s, NumberRule::not_negative},
    NumberKey{"position_gain_1_s", &Rules::position_gain_1_s, NumberRule::step},
    NumberKey{"in_position_mm", &Rules::in_position_mm, NumberRule::positive},
    NumberKey{"in_position_deg", &Rules::in_position_deg, NumberRule::positive},
    NumberKey{"rest_s", &Rules::dwell_s, NumberRule::not_negative},
    NumberKey{"dwell_step_s", &Rules::dwell_step_s, NumberRule::step},
    NumberKey{"servo_period_s", &Rules::servo_period_s, NumberRule::step},
    NumberKey{"corner_override_percent", &Rules::corner_override_percent, NumberRule::percent},
    NumberKey{"corner_override_before_mm", &Rules::corner_override_before_mm, NumberRule::not_negative},
    NumberKey{"corner_override_after_mm", &Rules::corner_override_after_mm, NumberRule::not_negative},
    NumberKey{"corner_override_angle_deg", &Rules::corner_override_angle_deg, NumberRule::not_negative},
};

constexpr std::array kFlagKeys{
    FlagKey{"stop_between_rapid_and_feed", &Rules::stop_between_rapid_and_feed},
    FlagKey{"exact_path_stops", &Rules::exact_path_stops},
    FlagKey{"own_ramps", &Rules::independent_ramps},
    FlagKey{"interpolated_rapids", &Rules::interpolated_rapids},
    FlagKey{"limit_jerk", &Rules::limit_jerk},
    FlagKey{"inverse_time_of_chords", &Rules::inverse_time_per_chord},
    FlagKey{"pecks_feed_down", &Rules::pecks_feed_down},
    FlagKey{"boring_cycles", &Rules::boring_cycles},
};

constexpr auto kControllerKeys = [] {
    std::array<std::string_view, kSingleKeys.size() + kCornerKeys.size() + kMeasureKeys.size() +
                                     kNumberKeys.size() + kFlagKeys.size()>
        keys{};
    std::size_t end = 0;
    for (const std::string_view key : kSingleKeys) keys[end++] = key;
    for (const CornerKey& corner : kCornerKeys) keys[end++] = corner.key;
    for (const MeasureKey& measure : kMeasureKeys) keys[end++] = measure.key;
    for (const NumberKey& number : kNumberKeys) keys[end++] = number.key;
    for (const FlagKey& flag : kFlagKeys) keys[end++] = flag.key;
    return keys;
}();

template <typename Kind>
Kind read_kind(TomlSection& section, std::string_view key, Kind fallback,
               std::span<const std::string_view> names) {
    return static_cast<Kind>(section.choice(key, static_cast<std::size_t>(fallback), names));
}

template <typename Kind>
void print_kind(TomlWriter& out, std::string_view key, Kind kind, std::span<const std::string_view> names) {
    out.line(key, base::toml_string(names[static_cast<std::size_t>(kind)]));
}

}  // namespace

std::span<const std::string_view> controller_keys() {
    return kControllerKeys;
}

void read_controller_keys(TomlSection& section, Rules& rules) {
    if (section.has(kName)) rules.model = section.text(kName);
    rules.planner = read_kind(section, kPlanner, rules.planner, kPlanners);
    rules.linuxcnc_release = read_kind(section, kRelease, rules.linuxcnc_release, kReleases);
    rules.look_ahead_blocks = static_cast<std::size_t>(
        section.number(kLookAhead, static_cast<double>(rules.look_ahead_blocks), NumberRule::count));
    rules.orientation = read_kind(section, kOrientationKey, rules.orientation, kOrientations);
    for (const auto& [key, value] : kCornerKeys)
        rules.*value = read_kind(section, key, rules.*value, kCorners);
    for (const auto& [key, value] : kMeasureKeys)
        rules.*value = read_kind(section, key, rules.*value, kMeasures);
    for (const auto& [key, value, rule] : kNumberKeys) rules.*value = section.number(key, rules.*value, rule);
    for (const auto& [key, value] : kFlagKeys) rules.*value = section.flag(key, rules.*value);
    read_stops(section, rules);
    read_overrides(section, rules);
}

void print_controller_keys(TomlWriter& out, const Rules& rules, const Rules& base) {
    if (rules.model != base.model) out.line(kName, base::toml_string(rules.model));
    if (rules.planner != base.planner) print_kind(out, kPlanner, rules.planner, kPlanners);
    if (rules.linuxcnc_release != base.linuxcnc_release)
        print_kind(out, kRelease, rules.linuxcnc_release, kReleases);
    if (rules.look_ahead_blocks != base.look_ahead_blocks)
        out.line(kLookAhead, fmt::format("{}", rules.look_ahead_blocks));
    if (rules.orientation != base.orientation)
        print_kind(out, kOrientationKey, rules.orientation, kOrientations);
    for (const auto& [key, value] : kCornerKeys) {
        if (rules.*value != base.*value) print_kind(out, key, rules.*value, kCorners);
    }
    for (const auto& [key, value] : kMeasureKeys) {
        if (rules.*value != base.*value) print_kind(out, key, rules.*value, kMeasures);
    }
    for (const auto& [key, value, rule] : kNumberKeys) {
        if (rules.*value != base.*value) out.number(key, rules.*value);
    }
    for (const auto& [key, value] : kFlagKeys) {
        if (rules.*value != base.*value) out.line(key, rules.*value ? "true" : "false");
    }
    print_stops(out, rules, base);
    print_overrides(out, rules, base);
}

}  // namespace gsim::machine
