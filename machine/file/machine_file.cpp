#include "machine/file/machine_file.h"

#include <algorithm>
#include <array>

#include "base/text/format.h"
#include "base/toml/toml_section.h"
#include "machine/embedded_machines.h"
#include "machine/file/calibration_section.h"
#include "machine/file/controller_file.h"
#include "machine/file/drive_section.h"
#include "machine/file/dynamics_section.h"
#include "machine/file/frame_section.h"
#include "machine/file/group_section.h"
#include "machine/file/process_section.h"
#include "machine/file/program_section.h"
#include "machine/file/servo_section.h"
#include "machine/file/times_section.h"
#include "machine/model/link_shapes.h"
#include "machine/model/torque_limit.h"
#include "machine/schema/controller_keys.h"

namespace gsim::machine {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;

using std::string_view_literals::operator""sv;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr std::string_view kLetters = "ABCEUVWXYZ";
constexpr char kNoLetter = '?';  // of an axis that could not be read

constexpr std::array kMachineFileKeys{
    "machine"sv,  "path"sv,   "base"sv,    "tool"sv,        "work"sv,      "controller"sv, "axis"sv,
    "shape"sv,    "ignore"sv, "process"sv, "checks"sv,      "program"sv,   "times"sv,      "group"sv,
    "dynamics"sv, "mass"sv,   "hose"sv,    "calibration"sv, "calibrated"sv};
constexpr std::array kMachineKeys{"name"sv, "inverse"sv};
constexpr std::array kPathKeys{"max_feed_mm_s"sv, "max_rapid_mm_s"sv, "max_acceleration_mm_s2"sv,
                               "max_rapid_acceleration_mm_s2"sv, "max_jerk_mm_s3"sv};
constexpr std::array kInverseNames{"none"sv, "gantry"sv, "numeric"sv};         // in the order of InverseKind
constexpr std::array kCarriedPartNames{"tool"sv, "work"sv, "nothing"sv};       // of CarriedPart
constexpr std::array kRotaryModeNames{"limited"sv, "shortest"sv, "unwind"sv};  // of RotaryMode
constexpr std::array kDhKeys{"theta_deg"sv, "d_mm"sv, "a_mm"sv, "alpha_deg"sv};

// The keys of an axis; their units depend on its kind.
struct AxisKeys {
    std::string_view title;
    std::string_view min, max, max_speed, max_acceleration, max_deceleration, max_jerk, max_speed_step, step;
    std::array<std::string_view, kHomeCount> homes;
    std::string_view zero;
    std::string_view turning;  ///< Empty if an axis of the kind has no such key.

    std::vector<std::string_view> all(AxisKind of) const {
        std::vector<std::string_view> keys{
            "letter", "kind",         "carries", min,  max,  max_speed, max_acceleration, max_deceleration,
            max_jerk, max_speed_step, step,      zero, "dh", "frame",   "direction"};
        keys.insert(keys.end(), homes.begin(), homes.end());
        if (!turning.empty()) keys.push_back(turning);
        for (const std::string_view key : drive_keys(of)) keys.push_back(key);
        for (const std::string_view key : servo_keys()) keys.push_back(key);
        return keys;
    }
};

constexpr AxisKeys kLinearKeys{"a linear [[axis]]",
                               "min_mm",
                               "max_mm",
                               "max_speed_mm_s",
                               "max_acceleration_mm_s2",
                               "max_deceleration_mm_s2",
                               "max_jerk_mm_s3",
                               "max_speed_step_mm_s",
                               "step_mm",
                               {"home_mm", "home2_mm", "home3_mm", "home4_mm"},
                               "zero_mm",
                               ""};
constexpr AxisKeys kRotaryKeys{"a rotary [[axis]]",
                               "min_deg",
                               "max_deg",
                               "max_speed_deg_s",
                               "max_acceleration_deg_s2",
                               "max_deceleration_deg_s2",
                               "max_jerk_deg_s3",
                               "max_speed_step_deg_s",
                               "step_deg",
                               {"home_deg", "home2_deg", "home3_deg", "home4_deg"},
                               "zero_deg",
                               "turning"};

PathLimits read_path_limits(FirstError& error, const toml::table* table) {
    if (!table) return {};
    TomlSection section(error, *table, "[path]", kPathKeys);
    const auto number = [&](std::string_view key) {
        return section.number(key, kUnlimited, NumberRule::positive);
    };
    return {.max_feed_mm_s = number("max_feed_mm_s"),
            .max_rapid_mm_s = number("max_rapid_mm_s"),
            .max_acceleration_mm_s2 = number("max_acceleration_mm_s2"),
            .max_rapid_acceleration_mm_s2 = number("max_rapid_acceleration_mm_s2"),
            .max_jerk_mm_s3 = number("max_jerk_mm_s3")};
}

DhRow read_dh_row(FirstError& error, const toml::table* table) {
    if (!table) return {};
    TomlSection section(error, *table, "'dh'", kDhKeys);
    const auto number = [&](std::string_view key) { return section.number(key, 0, NumberRule::finite); };
    return {.theta_deg = number("theta_deg"),
            .d_mm = number("d_mm"),
            .a_mm = number("a_mm"),
            .alpha_deg = number("alpha_deg")};
}

// The kind decides which keys an axis may have, so it is read first.
std::optional<AxisKind> read_axis_kind(FirstError& error, const toml::table& table) {
    const toml::node* node = table.get("kind");
    if (!node) {
        error.report(table.source().begin, "[[axis]] lacks the key 'kind'");
        return std::nullopt;
    }
    const auto kind = node->value<std::string_view>();
    if (kind == "linear") return AxisKind::linear;
    if (kind == "rotary") return AxisKind::rotary;
    error.report(node->source().begin, "'kind' must be \"linear\" or \"rotary\"");
    return std::nullopt;
}

char read_letter(TomlSection& section) {
    const std::string letter = section.text("letter");
    if (letter.size() == 1 && kLetters.find(letter[0]) != std::string_view::npos) return letter[0];
    section.fail("letter", fmt::format("'letter' must be one of {}", text::joined(kLetters, " ")));
    return kNoLetter;
}

void check_in_range(TomlSection& section, std::string_view key, const Axis& axis, double value) {
    if (value >= axis.min && value <= axis.max) return;
    section.fail(key,
                 fmt::format("'{}' is {}, outside the axis range {} .. {}", key, value, axis.min, axis.max));
}

void check_range(TomlSection& section, const AxisKeys& keys, const Axis& axis) {
    if (axis.min > axis.max) {
        section.fail(keys.min, fmt::format("'{}' is {}, greater than '{}', {}", keys.min, axis.min, keys.max,
                                           axis.max));
    }
    if (axis.min == axis.max && std::isinf(axis.min)) {
        section.fail(keys.min, fmt::format("'{}' and '{}' leave no range", keys.min, keys.max));
    }
    check_in_range(section, keys.homes[0], axis, axis.home);
}

void read_homes(TomlSection& section, const AxisKeys& keys, Axis& axis) {
    for (std::size_t i = 0; i < axis.other_homes.size(); ++i) {
        const std::string_view key = keys.homes[i + 1];
        if (!section.has(key)) continue;
        axis.other_homes[i] = section.number(key, 0, NumberRule::finite);
        check_in_range(section, key, axis, *axis.other_homes[i]);
    }
}

// Reads a table of joints, by rows, frames or directions.
void read_joint(FirstError& error, TomlSection& section, Axis& axis) {
    const bool carries_nothing = axis.carries == CarriedPart::none;
    if (carries_nothing && axis.kind == AxisKind::rotary)
        section.fail("carries", "'carries = \"nothing\"' is only for linear axes");
    if (!carries_nothing && !section.has("frame") && !section.has("direction") && !section.has("dh")) {
        section.fail(
            "dh",
            fmt::format("{} needs one of the keys 'direction', 'frame' and 'dh', which define its joint",
                        section.title()));
    }
    if (section.has("direction") && section.has("dh"))
        section.fail(
            "direction",
            fmt::format("{} has both 'dh' and 'direction'; only one may define its joint", section.title()));
    if (section.has("direction"))
        axis.direction = static_cast<AxisDirection>(section.choice("direction", 0, kDirectionNames));
    if (section.has("frame")) axis.frame = read_frame(error, section.table("frame"), "'frame'");
    axis.dh = read_dh_row(error, section.table("dh"));
}

RotaryMode read_rotary_mode(TomlSection& section, const AxisKeys& keys, const Axis& axis) {
    const auto turning = static_cast<RotaryMode>(section.choice("turning", 0, kRotaryModeNames));
    if (turning == RotaryMode::unwind && (std::isfinite(axis.min) || std::isfinite(axis.max))) {
        section.fail("turning", fmt::format("an axis that unwinds turns without limit; remove '{}' and '{}'",
                                            keys.min, keys.max));
    }
    return turning;
}

Axis read_axis(FirstError& error, const toml::table& table) {
    Axis axis;
    const auto kind = read_axis_kind(error, table);
    axis.letter = kNoLetter;
    if (!kind) return axis;
    axis.kind = *kind;
    const AxisKeys& keys = axis.kind == AxisKind::linear ? kLinearKeys : kRotaryKeys;
    TomlSection section(error, table, std::string(keys.title), keys.all(axis.kind));
    axis.letter = read_letter(section);
    axis.min = section.number(keys.min, -kUnlimited, NumberRule::any);
    axis.max = section.number(keys.max, kUnlimited, NumberRule::any);
    axis.max_speed = section.number(keys.max_speed, kUnlimited, NumberRule::positive);
    axis.max_acceleration = section.number(keys.max_acceleration, kUnlimited, NumberRule::positive);
    if (section.has(keys.max_deceleration))
        axis.max_deceleration = section.number(keys.max_deceleration, kUnlimited, NumberRule::positive);
    axis.max_jerk = section.number(keys.max_jerk, kUnlimited, NumberRule::positive);
    axis.max_speed_step = section.number(keys.max_speed_step, kUnlimited, NumberRule::positive);
    axis.step = section.number(keys.step, 0, NumberRule::step);
    axis.home = section.number(keys.homes[0], 0, NumberRule::finite);
    axis.zero = section.number(keys.zero, 0, NumberRule::finite);
    check_range(section, keys, axis);
    read_homes(section, keys, axis);
    axis.carries = static_cast<CarriedPart>(section.choice("carries", 0, kCarriedPartNames));
    if (axis.kind == AxisKind::rotary) axis.turning = read_rotary_mode(section, keys, axis);
    read_joint(error, section, axis);
    axis.drive = read_drive(section, table, axis.kind);
    axis.servo = read_servo(section);
    return axis;
}

std::vector<Axis> read_axes(FirstError& error, TomlSection& file) {
    std::vector<Axis> axes;
    std::vector<toml::source_position> locations;
    for (const toml::table* table : file.tables("axis")) {
        const Axis axis = read_axis(error, *table);
        const toml::node* letter = table->get("letter");
        const auto location = (letter == nullptr ? table : letter)->source().begin;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            if (axes[i].letter != axis.letter || axis.letter == kNoLetter) continue;
            error.report(location, fmt::format("the letter {} is given twice; first in line {}", axis.letter,
                                               locations[i].line));
        }
        axes.push_back(axis);
        locations.push_back(location);
    }
    if (axes.empty()) file.fail("axis", "a machine needs at least one [[axis]]");
    return axes;
}

rrs::ControllerRules read_controller_table(FirstError& error, const toml::table* table,
                                           const std::filesystem::path& folder, const os::Files& files) {
    if (!table) return {};
    TomlSection section(error, *table, "[controller]", controller_keys());
    return read_controller_section(section, folder, files);
}

Machine read_tables(FirstError& error, const toml::table& root, const std::filesystem::path& folder,
                    const os::Files& files) {
    Machine machine;
    TomlSection file(error, root, "a machine file", kMachineFileKeys);
    file.require("machine");
    const toml::table* head = file.table("machine");
    if (!head) return machine;
    TomlSection section(error, *head, "[machine]", kMachineKeys);
    machine.name = section.text("name");
    machine.inverse = static_cast<InverseKind>(section.choice("inverse", 0, kInverseNames));
    machine.path = read_path_limits(error, file.table("path"));
    machine.base = read_frame(error, file.table("base"), "[base]");
    machine.tool = read_frame(error, file.table("tool"), "[tool]");
    machine.work = read_frame(error, file.table("work"), "[work]");
    machine.program = read_program_section(error, file.table("program"));
    machine.controller = read_controller_table(error, file.table("controller"), folder, files);
    machine.process = read_process(error, file);
    machine.times = read_times(error, file.table("times"));
    machine.axes = read_axes(error, file);
    const bool has_letters = std::none_of(machine.axes.begin(), machine.axes.end(),
                                          [](const Axis& axis) { return axis.letter == kNoLetter; });
    if (machine.axes.empty() || !has_letters) return machine;
    read_link_shapes(error, file, root, folder, files, machine);
    read_groups(error, file, machine);
    read_dynamics(error, file, machine);
    read_calibration(error, file, machine);
    if (error.text()) return machine;
    if (const auto found = find_kinematic_error(machine)) section.fail("inverse", found->message);
    if (error.text()) return machine;
    if (const auto found = find_controller_error(machine)) file.fail("controller", found->message);
    if (const auto found = find_torque_limit_error(machine)) file.fail("dynamics", found->message);
    if (const auto found = find_servo_error(machine)) file.fail("axis", found->message);
    return machine;
}

}  // namespace

Result<Machine> read_machine(std::string_view toml_text, std::string_view file_name, const os::Files& files,
                             FileMessages* messages) {
    FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    Machine machine = read_tables(error, root, std::filesystem::path(file_name).parent_path(), files);
    if (messages != nullptr) *messages = {error.all(), error.warnings()};
    if (error.text()) return tl::unexpected(*error.text());
    return machine;
}

Result<Machine> load_machine(const std::filesystem::path& path, os::NameSource name_source,
                             const os::Files& files, FileMessages* messages) {
    return files.read_text(path, name_source).and_then([&](const std::string& text) {
        return read_machine(text, path.string(), files, messages);
    });
}

std::string_view built_in_machine_toml() {
    return embedded::embedded_machines("af5.toml");
}

}  // namespace gsim::machine
