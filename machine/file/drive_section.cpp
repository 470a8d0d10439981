#include "machine/file/drive_section.h"

#include <cmath>

#include "machine/file/number_list.h"

namespace gsim::machine {

namespace {

using base::NumberRule;
using base::TomlSection;

struct DriveKeys {
    std::string_view coulomb_friction, viscous, rotor, counterweight, peak, continuous, curve_speeds,
        curve_peaks;

    std::vector<std::string_view> all() const {
        return {coulomb_friction, viscous, rotor, counterweight, peak, continuous, curve_speeds, curve_peaks};
    }
};

constexpr DriveKeys kLinearDrive{"coulomb_n", "viscous_n_per_mm_s", "rotor_kg",         "counterweight_n",
                                 "peak_n",    "continuous_n",       "curve_speed_mm_s", "curve_peak_n"};
constexpr DriveKeys kRotaryDrive{
    "coulomb_nm", "viscous_nm_per_deg_s", "rotor_kg_m2",       "counterweight_nm",
    "peak_nm",    "continuous_nm",        "curve_speed_deg_s", "curve_peak_nm"};

const DriveKeys& drive_keys_of_kind(AxisKind kind) {
    return kind == AxisKind::linear ? kLinearDrive : kRotaryDrive;
}

bool rises_from_zero(const std::vector<double>& speeds) {
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        if (!(i == 0 ? speeds[i] >= 0 : speeds[i] > speeds[i - 1])) return false;
    }
    return true;
}

void read_curve(TomlSection& axis, const toml::table& table, const DriveKeys& keys, Drive& drive) {
    const auto speeds = read_numbers(axis, table, keys.curve_speeds, "a list of speeds");
    const auto peaks = read_numbers(axis, table, keys.curve_peaks, "a list, one for each speed of the curve");
    if (!speeds && !peaks) return;
    const std::string_view missing_message = speeds ? keys.curve_peaks : keys.curve_speeds;
    if (!axis.has(missing_message)) {
        axis.fail(speeds ? keys.curve_speeds : keys.curve_peaks,
                  fmt::format("a motor curve needs '{}' and '{}', but '{}' is missing", keys.curve_speeds,
                              keys.curve_peaks, missing_message));
        return;
    }
    if (!speeds || !peaks) return;
    if (speeds->size() != peaks->size() || speeds->empty()) {
        axis.fail(keys.curve_peaks,
                  fmt::format(
                      "'{}' and '{}' must have the same number of values, at least one; they have {} and {}",
                      keys.curve_peaks, keys.curve_speeds, peaks->size(), speeds->size()));
        return;
    }
    if (!rises_from_zero(*speeds)) {
        axis.fail(keys.curve_speeds,
                  fmt::format("'{}' must be speeds from 0 up, in ascending order", keys.curve_speeds));
        return;
    }
    for (const double peak : *peaks) {
        if (peak >= 0) continue;
        axis.fail(keys.curve_peaks,
                  fmt::format("'{}' must be 0 or greater; {} is not", keys.curve_peaks, peak));
        return;
    }
    drive.curve_speeds = *speeds;
    drive.curve_peaks = *peaks;
}

}  // namespace

std::vector<std::string_view> drive_keys(AxisKind kind) {
    return drive_keys_of_kind(kind).all();
}

Drive read_drive(TomlSection& axis, const toml::table& table, AxisKind kind) {
    const DriveKeys& keys = drive_keys_of_kind(kind);
    const Drive none;
    Drive drive;
    drive.coulomb_friction = axis.number(keys.coulomb_friction, 0, NumberRule::not_negative);
    drive.viscous = axis.number(keys.viscous, 0, NumberRule::not_negative);
    drive.rotor = axis.number(keys.rotor, 0, NumberRule::not_negative);
    drive.counterweight = axis.number(keys.counterweight, 0, NumberRule::finite);
    drive.peak = axis.number(keys.peak, none.peak, NumberRule::positive);
    drive.continuous = axis.number(keys.continuous, none.continuous, NumberRule::positive);
    read_curve(axis, table, keys, drive);
    return drive;
}

void print_drive(base::TomlWriter& out, const Axis& axis) {
    const DriveKeys& keys = drive_keys_of_kind(axis.kind);
    const Drive& drive = axis.drive;
    const auto number = [&](std::string_view key, double value) {
        if (value != 0) out.number(key, value);
    };
    number(keys.coulomb_friction, drive.coulomb_friction);
    number(keys.viscous, drive.viscous);
    number(keys.rotor, drive.rotor);
    number(keys.counterweight, drive.counterweight);
    out.limit(keys.peak, drive.peak);
    out.limit(keys.continuous, drive.continuous);
    if (drive.curve_speeds.empty()) return;
    out.line(keys.curve_speeds, number_list(drive.curve_speeds));
    out.line(keys.curve_peaks, number_list(drive.curve_peaks));
}

}  // namespace gsim::machine
