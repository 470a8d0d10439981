#include "machine/import/linuxcnc_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/units.h"

namespace gsim::import {

namespace {

constexpr std::string_view kTrivialKinematics = "trivkins";
constexpr std::string_view kJointLetters = "XYZABCUVW";  // if the kinematics name none
constexpr double kUnlimited = 1e9;                       // what LinuxCNC has for no limit is 1e99
constexpr double kDefaultSpeed = 1;  // units/s, if an [AXIS_..] gives no MAX_VELOCITY or MAX_ACCELERATION

template <typename T>
using Read = Result<T>;

bool is_letter(char c) {
    return kJointLetters.find(c) != std::string_view::npos;
}

machine::AxisDirection letter_direction(char letter) {
    constexpr std::size_t kSpatialDirections = 3;
    return static_cast<machine::AxisDirection>(kJointLetters.find(letter) % kSpatialDirections);
}

// Returns the letters of a value such as "X Y Z" or "XYZ", in capitals.
std::string parse_letters(std::string_view value) {
    std::string letters;
    for (const char c : text::upper(value)) {
        if (is_letter(c)) letters += c;
    }
    return letters;
}

std::string remove_duplicates(const std::string& letters) {
    std::string once;
    for (const char c : letters) {
        if (once.find(c) == std::string::npos) once += c;
    }
    return once;
}

// Returns the letter of each joint, from KINEMATICS = trivkins coordinates=XYYZ kinstype=BOTH.
Read<std::string> joint_letters(IniFile& ini) {
    const IniEntry* entry = ini.find("KINS", "KINEMATICS");
    if (entry == nullptr) return std::string(kJointLetters);
    const std::string_view value = entry->value;
    const std::size_t blank = std::min(value.find_first_of(" \t"), value.size());
    if (value.substr(0, blank) != kTrivialKinematics) {
        return tl::unexpected(
            ini.at(*entry, fmt::format("the kinematics '{}' cannot be imported, only trivkins; write a "
                                       "machine file with its frames and copy the limits from here",
                                       value.substr(0, blank))));
    }
    const std::size_t coordinates = text::lower(value).find("coordinates=");
    if (coordinates == std::string::npos) return std::string(kJointLetters);
    const std::string_view given = value.substr(coordinates + std::string_view("coordinates=").size());
    return parse_letters(given.substr(0, given.find_first_of(" \t")));
}

struct Unit {
    std::string_view name;
    double size;
};

Read<double> read_unit(IniFile& ini, std::string_view key, std::initializer_list<Unit> units) {
    const IniEntry* entry = ini.find("TRAJ", key);
    if (entry == nullptr) return 1.0;
    const std::string name = text::lower(entry->value);
    // A number gives how many units make a mm, or a degree.
    if (const auto per_unit = parse_number_text(name); per_unit && *per_unit > 0) return 1 / *per_unit;
    std::string names;
    for (const Unit& unit : units) {
        if (name == unit.name) return unit.size;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", unit.name);
    }
    return tl::unexpected(
        ini.at(*entry, fmt::format("{} is '{}'; allowed values are {}", key, entry->value, names)));
}

/// Limits from one section [AXIS_X] or [JOINT_0], in mm or deg.
struct Limits {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    double speed = std::numeric_limits<double>::infinity();
    double acceleration = std::numeric_limits<double>::infinity();
    double jerk = std::numeric_limits<double>::infinity();
    double home = 0;

    void narrow(const Limits& other) {
        min = std::max(min, other.min);
        max = std::min(max, other.max);
        speed = std::min(speed, other.speed);
        acceleration = std::min(acceleration, other.acceleration);
        // LinuxCNC's planner treats an axis without a jerk limit as unlimited, whatever limits its joints
        // have.
        if (std::isfinite(jerk)) jerk = std::min(jerk, other.jerk);
    }
};

class AxisReader {
  public:
    AxisReader(IniFile& ini, const IniUnits& units, std::vector<std::string>& warnings)
        : ini_(ini), units_(units), warnings_(warnings) {}

    Read<machine::Axis> read(char letter, const std::vector<std::size_t>& joints) {
        const bool rotary = letter >= 'A' && letter <= 'C';
        unit_ = rotary ? units_.angular_deg : units_.linear_mm;
        Limits limits;
        const std::string axis_section = fmt::format("AXIS_{}", letter);
        if (ini_.has_section(axis_section)) read_limits(axis_section, kDefaultSpeed, limits);
        bool first = true;
        for (const std::size_t joint : joints) {
            Limits joint_limits;
            const std::string section = joint_section(joint);
            if (!ini_.has_section(section)) continue;
            read_limits(section, kDefaultSpeed, joint_limits);
            check_type(section, letter, rotary);
            limits.narrow(joint_limits);
            if (first) limits.home = joint_limits.home;
            first = false;
        }
        if (error_) return tl::unexpected(*error_);
        if (first && !ini_.has_section(axis_section)) {
            return Unexpected(fmt::format("{}: neither [{}] nor a section [JOINT_n] exists for axis {}",
                                          ini_.file_name(), axis_section, letter));
        }
        return make_axis(letter, rotary, limits);
    }

  private:
    // Up to version 2.7 joints were in sections [AXIS_0].
    std::string joint_section(std::size_t joint) const {
        const std::string now = fmt::format("JOINT_{}", joint);
        return ini_.has_section(now) ? now : fmt::format("AXIS_{}", joint);
    }

    std::optional<double> number(const std::string& section, std::string_view key) {
        const auto read = ini_.number(section, key);
        if (!read && !error_) error_ = read.error();
        return read ? *read : std::nullopt;
    }

    void read_limits(const std::string& section, double default_speed, Limits& limits) {
        const auto length = [&](std::string_view key, double unlimited) {
            const std::optional<double> value = number(section, key);
            return value && std::abs(*value) < kUnlimited ? remove_rounding_noise(*value * unit_) : unlimited;
        };
        limits.min = length("MIN_LIMIT", limits.min);
        limits.max = length("MAX_LIMIT", limits.max);
        limits.speed = number(section, "MAX_VELOCITY").value_or(default_speed) * unit_;
        limits.acceleration = number(section, "MAX_ACCELERATION").value_or(default_speed) * unit_;
        if (const auto jerk = number(section, "MAX_JERK"); jerk && *jerk > 0)
            limits.jerk = remove_rounding_noise(*jerk * unit_);
        limits.home = remove_rounding_noise(number(section, "HOME").value_or(0) * unit_);
        for (const std::string_view key : {"MAX_VELOCITY", "MAX_ACCELERATION"}) {
            const std::optional<double> value = number(section, key);
            if (!value || *value > 0 || error_) continue;
            error_ = ini_.at(*ini_.find(section, key),
                             fmt::format("{} of [{}] must be greater than 0", key, section));
        }
    }

    void check_type(const std::string& section, char letter, bool rotary) {
        const auto type = ini_.text(section, "TYPE");
        if (!type || text::upper(*type) == (rotary ? "ANGULAR" : "LINEAR")) return;
        warnings_.push_back(fmt::format("[{}] TYPE = {} is not imported: axis {} is {}", section, *type,
                                        letter, rotary ? "rotary" : "linear"));
    }

    Read<machine::Axis> make_axis(char letter, bool rotary, const Limits& limits) {
        if (limits.min > limits.max) {
            return Unexpected(fmt::format("{}: the limits of axis {} leave no range: {} .. {}",
                                          ini_.file_name(), letter, limits.min, limits.max));
        }
        machine::Axis axis;
        axis.letter = letter;
        axis.kind = rotary ? machine::AxisKind::rotary : machine::AxisKind::linear;
        axis.min = limits.min;
        axis.max = limits.max;
        axis.max_speed = limits.speed;
        axis.max_acceleration = limits.acceleration;
        axis.max_jerk = limits.jerk;
        axis.home = std::clamp(limits.home, limits.min, limits.max);
        if (axis.home != limits.home) {
            warnings_.push_back(
                fmt::format("HOME of axis {} is outside its range; it is imported as {}", letter, axis.home));
        }
        axis.direction = letter_direction(letter);
        return axis;
    }

    IniFile& ini_;
    const IniUnits& units_;
    std::vector<std::string>& warnings_;
    double unit_ = 1;
    std::optional<Error> error_;
};

}  // namespace

Read<IniUnits> read_units(IniFile& ini) {
    const auto linear = read_unit(ini, "LINEAR_UNITS",
                                  {{"mm", 1},
                                   {"metric", 1},
                                   {"inch", kMmPerInch},
                                   {"in", kMmPerInch},
                                   {"imperial", kMmPerInch},
                                   {"cm", 10}});
    if (!linear) return tl::unexpected(linear.error());
    const auto angular = read_unit(ini, "ANGULAR_UNITS",
                                   {{"degree", 1},
                                    {"deg", 1},
                                    {"degrees", 1},
                                    {"radian", kDegPerRad},
                                    {"rad", kDegPerRad},
                                    {"grad", 0.9},
                                    {"gon", 0.9}});
    if (!angular) return tl::unexpected(angular.error());
    return IniUnits{*linear, *angular};
}

Read<std::vector<machine::Axis>> read_axes(IniFile& ini, const IniUnits& units,
                                           std::vector<std::string>& warnings) {
    const auto pose_from_joints = joint_letters(ini);
    if (!pose_from_joints) return tl::unexpected(pose_from_joints.error());
    const std::string letters =
        remove_duplicates(parse_letters(ini.text("TRAJ", "COORDINATES").value_or(*pose_from_joints)));
    if (letters.empty())
        return Unexpected(fmt::format("{}: [TRAJ] COORDINATES names no axes", ini.file_name()));
    const auto joint_count = ini.number("KINS", "JOINTS");
    if (!joint_count) return tl::unexpected(joint_count.error());
    const auto max = static_cast<double>(pose_from_joints->size());
    const double configured_count = joint_count->value_or(max);
    const auto count =
        static_cast<std::size_t>(configured_count >= 0 ? std::min(configured_count, max) : max);
    std::map<char, std::vector<std::size_t>> joints;
    for (std::size_t joint = 0; joint < count; ++joint) joints[(*pose_from_joints)[joint]].push_back(joint);
    std::vector<machine::Axis> axes;
    for (const char letter : letters) {
        auto axis = AxisReader(ini, units, warnings).read(letter, joints[letter]);
        if (!axis) return tl::unexpected(axis.error());
        axes.push_back(*std::move(axis));
    }
    return axes;
}

}  // namespace gsim::import
