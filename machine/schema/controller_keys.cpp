#include "machine/schema/controller_keys.h"

#include <array>

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "controller/services/rule_field.h"
#include "machine/model/override_keys.h"
#include "machine/model/stop_keys.h"

namespace gsim::machine {

namespace {

using base::NumberRule;
using base::TomlSection;
using base::TomlWriter;

using Rules = rrs::ControllerRules;
using Blocks = rrs::BlockRules;
using Coordination = rrs::CoordinationRules;
using CornerOverride = rrs::CornerOverrideRules;
using Corners = rrs::CornerRules;
using Curves = rrs::CurveRules;
using Drilling = rrs::DrillingRules;
using Klipper = rrs::KlipperRules;
using PositionLoop = rrs::PositionLoopRules;
using Ramps = rrs::RampRules;
using Retraction = rrs::RetractionRules;
using Standstill = rrs::StandstillRules;

using rrs::rule_field;
using rrs::RuleField;

struct NumberKey {
    std::string_view key;
    RuleField<double> value;
    NumberRule rule;
};

struct FlagKey {
    std::string_view key;
    RuleField<bool> value;
};

struct CornerKey {
    std::string_view key;
    RuleField<rrs::CornerRule> value;
};

constexpr std::string_view kName = "name";
constexpr std::string_view kPlanner = "planner";
constexpr std::string_view kRelease = "linuxcnc_release";
constexpr std::string_view kLookAhead = "look_ahead_blocks";
constexpr std::array kSingleKeys{kModelKey,  kName,           kPlanner,  kRelease,
                                 kLookAhead, kOrientationKey, kStopsKey, kOverridesKey};

constexpr auto kPlanners = rrs::planner_names();

// Names of rrs::LinuxcncRelease, rrs::CornerRule and rrs::OrientationRule in their order.
constexpr std::array<std::string_view, 2> kReleases{"2.9", "2.10"};
constexpr std::array<std::string_view, 5> kCorners{"stop", "velocity-step", "junction-deviation",
                                                   "parabolic-blend", "smooth-blend"};

constexpr std::array<std::string_view, 2> kOrientations{"joints", "great-circle"};

struct MeasureKey {
    std::string_view key;
    RuleField<rrs::PathMeasure> value;
};

constexpr std::array<std::string_view, 2> kMeasures{"tool", "all-axes"};

constexpr std::array kMeasureKeys{
    MeasureKey{"path_measure", rule_field<&Rules::blocks, &Blocks::path_measure>()},
    MeasureKey{"feed_measure", rule_field<&Rules::blocks, &Blocks::feed_measure>()},
};

constexpr std::array kCornerKeys{
    CornerKey{"corner", rule_field<&Rules::corners, &Corners::continuous>()},
    CornerKey{"exact_path_corner", rule_field<&Rules::corners, &Corners::exact_path>()},
};

constexpr std::array kNumberKeys{
    NumberKey{"junction_deviation_mm", rule_field<&Rules::corners, &Corners::junction_deviation_mm>(),
              NumberRule::not_negative},
    NumberKey{"blend_tolerance_mm", rule_field<&Rules::corners, &Corners::blend_tolerance_mm>(),
              NumberRule::not_negative},
    NumberKey{"blend_tolerance_deg", rule_field<&Rules::corners, &Corners::blend_tolerance_deg>(),
              NumberRule::not_negative},
    NumberKey{"speed_step_s", rule_field<&Rules::corners, &Corners::speed_step_s>(), NumberRule::positive},
    NumberKey{"centripetal_share", rule_field<&Rules::ramps, &Ramps::centripetal_share>(),
              NumberRule::positive},
    NumberKey{"continuous_acceleration_share",
              rule_field<&Rules::ramps, &Ramps::continuous_acceleration_share>(), NumberRule::share},
    NumberKey{"block_time_s", rule_field<&Rules::blocks, &Blocks::time_s>(), NumberRule::step},
    NumberKey{"tcp_tolerance_mm", rule_field<&Rules::coordination, &Coordination::tcp_tolerance_mm>(),
              NumberRule::positive},
    NumberKey{"arc_chord_tolerance_mm", rule_field<&Rules::curves, &Curves::arc_chord_tolerance_mm>(),
              NumberRule::step},
    NumberKey{"spline_chord_tolerance_mm", rule_field<&Rules::curves, &Curves::spline_chord_tolerance_mm>(),
              NumberRule::step},
    NumberKey{"ramp_step_s", rule_field<&Rules::ramps, &Ramps::step_s>(), NumberRule::step},
    NumberKey{"peck_clearance_mm", rule_field<&Rules::drilling, &Drilling::peck_clearance_mm>(),
              NumberRule::not_negative},
    NumberKey{"peck_dwell_s", rule_field<&Rules::drilling, &Drilling::peck_dwell_s>(),
              NumberRule::not_negative},
    NumberKey{"arc_resolution_mm", rule_field<&Rules::klipper, &Klipper::arc_resolution_mm>(),
              NumberRule::step},
    NumberKey{"square_corner_velocity_mm_s",
              rule_field<&Rules::klipper, &Klipper::square_corner_velocity_mm_s>(), NumberRule::not_negative},
    NumberKey{"minimum_cruise_ratio", rule_field<&Rules::klipper, &Klipper::minimum_cruise_ratio>(),
              NumberRule::part},
    NumberKey{"retract_length_mm", rule_field<&Rules::retraction, &Retraction::length_mm>(),
              NumberRule::not_negative},
    NumberKey{"retract_speed_mm_s", rule_field<&Rules::retraction, &Retraction::speed_mm_s>(),
              NumberRule::positive},
    NumberKey{"unretract_extra_length_mm",
              rule_field<&Rules::retraction, &Retraction::unretract_extra_length_mm>(),
              NumberRule::not_negative},
    NumberKey{"unretract_speed_mm_s", rule_field<&Rules::retraction, &Retraction::unretract_speed_mm_s>(),
              NumberRule::positive},
    NumberKey{"min_feed_mm_min", rule_field<&Rules::blocks, &Blocks::min_feed_mm_min>(),
              NumberRule::not_negative},
    NumberKey{"settle_s", rule_field<&Rules::position_loop, &PositionLoop::settle_s>(),
              NumberRule::not_negative},
    NumberKey{"position_gain_1_s", rule_field<&Rules::position_loop, &PositionLoop::gain_1_s>(),
              NumberRule::step},
    NumberKey{"in_position_mm", rule_field<&Rules::position_loop, &PositionLoop::in_position_mm>(),
              NumberRule::positive},
    NumberKey{"in_position_deg", rule_field<&Rules::position_loop, &PositionLoop::in_position_deg>(),
              NumberRule::positive},
    NumberKey{"standstill_s", rule_field<&Rules::standstill, &Standstill::dwell_s>(),
              NumberRule::not_negative},
    NumberKey{"dwell_step_s", rule_field<&Rules::standstill, &Standstill::dwell_step_s>(), NumberRule::step},
    NumberKey{"servo_period_s", rule_field<&Rules::position_loop, &PositionLoop::servo_period_s>(),
              NumberRule::step},
    NumberKey{"corner_override_percent", rule_field<&Rules::corner_override, &CornerOverride::percent>(),
              NumberRule::percent},
    NumberKey{"corner_override_before_mm", rule_field<&Rules::corner_override, &CornerOverride::before_mm>(),
              NumberRule::not_negative},
    NumberKey{"corner_override_after_mm", rule_field<&Rules::corner_override, &CornerOverride::after_mm>(),
              NumberRule::not_negative},
    NumberKey{"corner_override_angle_deg",
              rule_field<&Rules::corner_override, &CornerOverride::max_angle_deg>(),
              NumberRule::not_negative},
};

constexpr std::array kFlagKeys{
    FlagKey{"stop_between_rapid_and_feed",
            rule_field<&Rules::corners, &Corners::stop_between_rapid_and_feed>()},
    FlagKey{"exact_path_stops", rule_field<&Rules::corners, &Corners::exact_path_stops>()},
    FlagKey{"independent_ramps", rule_field<&Rules::coordination, &Coordination::independent_ramps>()},
    FlagKey{"interpolated_rapids", rule_field<&Rules::coordination, &Coordination::interpolated_rapids>()},
    FlagKey{"limit_jerk", rule_field<&Rules::ramps, &Ramps::limit_jerk>()},
    FlagKey{"inverse_time_of_chords", rule_field<&Rules::curves, &Curves::inverse_time_per_chord>()},
    FlagKey{"pecks_feed_down", rule_field<&Rules::drilling, &Drilling::pecks_feed_down>()},
    FlagKey{"boring_cycles", rule_field<&Rules::drilling, &Drilling::boring_cycles>()},
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
    rules.linuxcnc.release = read_kind(section, kRelease, rules.linuxcnc.release, kReleases);
    rules.blocks.look_ahead = static_cast<std::size_t>(
        section.number(kLookAhead, static_cast<double>(rules.blocks.look_ahead), NumberRule::count));
    rules.coordination.orientation =
        read_kind(section, kOrientationKey, rules.coordination.orientation, kOrientations);
    for (const auto& [key, value] : kCornerKeys)
        value(rules) = read_kind(section, key, value(rules), kCorners);
    for (const auto& [key, value] : kMeasureKeys)
        value(rules) = read_kind(section, key, value(rules), kMeasures);
    for (const auto& [key, value, rule] : kNumberKeys) value(rules) = section.number(key, value(rules), rule);
    for (const auto& [key, value] : kFlagKeys) value(rules) = section.flag(key, value(rules));
    read_stops(section, rules.standstill);
    read_overrides(section, rules.overrides);
}

void print_controller_keys(TomlWriter& out, const Rules& rules, const Rules& base) {
    if (rules.model != base.model) out.line(kName, base::toml_string(rules.model));
    if (rules.planner != base.planner) print_kind(out, kPlanner, rules.planner, kPlanners);
    if (rules.linuxcnc.release != base.linuxcnc.release)
        print_kind(out, kRelease, rules.linuxcnc.release, kReleases);
    if (rules.blocks.look_ahead != base.blocks.look_ahead)
        out.line(kLookAhead, fmt::format("{}", rules.blocks.look_ahead));
    if (rules.coordination.orientation != base.coordination.orientation)
        print_kind(out, kOrientationKey, rules.coordination.orientation, kOrientations);
    for (const auto& [key, value] : kCornerKeys) {
        if (value(rules) != value(base)) print_kind(out, key, value(rules), kCorners);
    }
    for (const auto& [key, value] : kMeasureKeys) {
        if (value(rules) != value(base)) print_kind(out, key, value(rules), kMeasures);
    }
    for (const auto& [key, value, rule] : kNumberKeys) {
        if (value(rules) != value(base)) out.number(key, value(rules));
    }
    for (const auto& [key, value] : kFlagKeys) {
        if (value(rules) != value(base)) out.line(key, value(rules) ? "true" : "false");
    }
    print_stops(out, rules.standstill, base.standstill);
    print_overrides(out, rules.overrides, base.overrides);
}

}  // namespace gsim::machine
