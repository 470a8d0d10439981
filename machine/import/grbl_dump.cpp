#include "machine/import/grbl_dump.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/units.h"
#include "machine/file/controller_file.h"
#include "machine/import/ini_file.h"

namespace gsim::import {

namespace {

constexpr std::string_view kGrblModel = "grbl-1.1";
constexpr std::string_view kLetters = "XYZABC";
constexpr std::size_t kMinAxes = 3;

// Numbers of settings; those of axes are for X, and those of the others follow.
constexpr int kJunctionDeviation = 11;
constexpr int kArcTolerance = 12;
constexpr int kReportInches = 13;
constexpr int kHoming = 22;
constexpr int kHomingDirection = 23;
constexpr int kPullOff = 27;
constexpr int kSteps = 100;
constexpr int kSpeed = 110;
constexpr int kAcceleration = 120;
constexpr int kTravel = 130;

struct Setting {
    double value = 0;
    std::string line;
    int line_number = 1;
    bool is_used = false;
};

/// A line in brackets.
struct Point {
    std::string line;
    int line_number = 1;
};

/// A point of `$#` with its parameters in gsim.
struct StoredPoint {
    std::string_view name;
    int first;
};
constexpr std::array kStoredPoints{StoredPoint{"G28", 5161}, StoredPoint{"G30", 5181},
                                   StoredPoint{"G92", 5211}};
constexpr int kGrblG92Active = 5210;

// Returns "110" and "5000.000 (x max rate)" of "$110=5000.000 (x max rate)".
std::optional<std::pair<int, double>> parse_setting(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (!line.starts_with('$') || equals == std::string_view::npos) return std::nullopt;
    const auto number = parse_number_text(line.substr(1, equals - 1));
    const std::string_view value = line.substr(equals + 1);
    const auto of = parse_number_text(value.substr(0, value.find_first_of(" \t(")));
    if (!number || !of || *number < 0 || *number > 999) return std::nullopt;
    return std::pair(static_cast<int>(*number), *of);
}

class GrblDump {
  public:
    explicit GrblDump(std::string_view file_name) : file_name_(file_name) {}

    Result<void> read(std::string_view text) {
        std::size_t at = 0;
        for (int number = 1; at < text.size(); ++number) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::string_view line = trimmed_text(text.substr(at, end - at));
            at = end + 1;
            if (line.empty() || line == "ok" || line.starts_with("Grbl") || line == "$$" || line == "$#")
                continue;
            if (const auto setting = parse_setting(line)) {
                settings_[setting->first] = {
                    .value = setting->second, .line = std::string(line), .line_number = number};
            } else if (line.starts_with('[')) {
                points_.push_back({std::string(line), number});
            } else {
                return Unexpected(fmt::format("{}:{}: '{}' is not a line of grbl's output for $$ and $#",
                                              file_name_, number, line));
            }
        }
        return {};
    }

    Result<ImportResult> release() {
        result_.machine.name = "grbl";
        result_.machine.inverse = machine::InverseKind::gantry;
        result_.machine.program.dialect = "grbl";
        if (Result<void> done = import_axes(); !done) return tl::unexpected(done.error());
        if (result_.machine.axes.size() > kMinAxes) result_.machine.inverse = machine::InverseKind::none;
        import_planner();
        report_unit_mm_ = value(kReportInches).value_or(0) != 0 ? kMmPerInch : 1;
        for (const Point& point : points_) {
            if (Result<void> done = import_point(point); !done) return tl::unexpected(done.error());
        }
        for (const auto& [number, setting] : settings_) {
            if (!setting.is_used) result_.left_out.push_back(setting.line);
        }
        return std::move(result_);
    }

  private:
    std::optional<double> value(int number) {
        const auto found = settings_.find(number);
        if (found == settings_.end()) return std::nullopt;
        found->second.is_used = true;
        return found->second.value;
    }

    bool has(int number) const { return settings_.find(number) != settings_.end(); }

    Result<void> import_axes() {
        for (std::size_t i = 0; i < kLetters.size(); ++i) {
            if (i >= kMinAxes && !has(kSpeed + static_cast<int>(i))) break;
            if (Result<void> done = import_axis(i); !done) return done;
        }
        if (value(kHoming).value_or(0) == 0) {
            result_.warnings.emplace_back(
                "$130 to $132 are not imported as ranges: without homing ($22=0) zero is the position at "
                "switch-on");
        }
        value(kHomingDirection);
        return {};
    }

    Result<void> import_axis(std::size_t index) {
        const int number = static_cast<int>(index);
        const bool rotary = index >= kMinAxes;
        machine::Axis axis;
        axis.letter = kLetters[index];
        axis.kind = rotary ? machine::AxisKind::rotary : machine::AxisKind::linear;
        axis.direction = static_cast<machine::AxisDirection>(index % kMinAxes);
        for (const int base : {kSteps, kSpeed, kAcceleration}) {
            const auto of = value(base + number);
            if (!of || *of <= 0) return missing_message(base + number, axis.letter);
            if (base == kSteps) axis.step = 1 / *of;
            if (base == kSpeed) axis.max_speed = *of / kSecondsPerMinute;
            if (base == kAcceleration) axis.max_acceleration = *of;
        }
        import_range(number, axis);
        result_.machine.axes.push_back(axis);
        return {};
    }

    Result<void> missing_message(int number, char letter) const {
        const auto found = settings_.find(number);
        if (found == settings_.end())
            return Unexpected(
                fmt::format("{}: ${} is missing; axis {} needs it", file_name_, number, letter));
        return Unexpected(fmt::format("{}:{}: ${}, which axis {} needs, must be greater than 0", file_name_,
                                      found->second.line_number, number, letter));
    }

    // After homing, machine coordinates run from minus the travel to 0, whichever end the switch is at.
    void import_range(int number, machine::Axis& axis) {
        axis.min = -std::numeric_limits<double>::infinity();
        axis.max = std::numeric_limits<double>::infinity();
        const double travel = value(kTravel + number).value_or(0);
        if (value(kHoming).value_or(0) == 0 || travel <= 0) return;
        axis.min = -travel;
        axis.max = 0;
        const double pull_off = std::min(value(kPullOff).value_or(0), travel);
        constexpr double kAllAxes = 255;  // the greatest mask of grbl
        const double mask = std::clamp(value(kHomingDirection).value_or(0), 0.0, kAllAxes);
        const auto homing_direction_bits = static_cast<unsigned>(mask) >> static_cast<unsigned>(number);
        axis.home = (homing_direction_bits & 1U) != 0 ? pull_off - travel : -pull_off;
    }

    void import_planner() {
        rrs::ControllerRules& rules = result_.machine.controller;
        rules = machine::built_in_controller(kGrblModel).value();
        rules.corners.junction_deviation_mm =
            value(kJunctionDeviation).value_or(rules.corners.junction_deviation_mm);
        rules.curves.arc_chord_tolerance_mm =
            value(kArcTolerance).value_or(rules.curves.arc_chord_tolerance_mm);
    }

    // Reads "[G54:4.000,0.000,0.000]".
    Result<void> import_point(const Point& given) {
        const std::string& line = given.line;
        const std::size_t colon = line.find(':');
        const std::string name = line.substr(1, std::min(colon, line.size()) - 1);
        const auto stored = std::find_if(kStoredPoints.begin(), kStoredPoints.end(),
                                         [&](const StoredPoint& point) { return point.name == name; });
        const bool system = name.size() == 3 && name >= "G54" && name <= "G59";
        if (!system && stored == kStoredPoints.end()) {
            result_.left_out.push_back(line);
            return {};
        }
        const auto values = point_values(std::string_view(line).substr(colon + 1));
        if (!values) {
            return Unexpected(fmt::format("{}:{}: '{}' must have numbers for its axes, separated by commas",
                                          file_name_, given.line_number, line));
        }
        result_.has_data = true;
        if (system) {
            result_.data.offsets[name.substr(1)] = *values;
            return {};
        }
        for (const auto& [letter, of] : *values) {
            if (of == 0) continue;
            const int number = stored->first + static_cast<int>(kLetters.find(letter));
            const bool rotary = kLetters.find(letter) >= kMinAxes;
            result_.data.variables[number] = rotary ? of : of / kMmPerInch;  // parameters hold inches
            if (name == "G92") result_.data.variables[kGrblG92Active] = 1;
        }
        return {};
    }

    std::optional<machine::AxisValues> point_values(std::string_view text) const {
        machine::AxisValues values;
        text = text.substr(0, text.find(']'));
        for (const machine::Axis& axis : result_.machine.axes) {
            const std::size_t comma = std::min(text.find(','), text.size());
            const auto of = parse_number_text(text.substr(0, comma));
            if (!of) return std::nullopt;
            values[axis.letter] =
                axis.kind == machine::AxisKind::linear ? remove_rounding_noise(*of * report_unit_mm_) : *of;
            text.remove_prefix(std::min(comma + 1, text.size()));
        }
        return values;
    }

    std::string_view file_name_;
    std::map<int, Setting> settings_;
    std::vector<Point> points_;
    double report_unit_mm_ = 1;
    ImportResult result_;
};

}  // namespace

bool is_grbl_dump(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (parse_setting(trimmed_text(text.substr(0, end)))) return true;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return false;
}

Result<ImportResult> import_grbl(std::string_view text, std::string_view file_name) {
    GrblDump dump(file_name);
    return dump.read(text).and_then([&] { return dump.release(); });
}

}  // namespace gsim::import
