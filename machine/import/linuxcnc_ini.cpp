#include "machine/import/linuxcnc_ini.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/units.h"
#include "machine/file/controller_file.h"
#include "machine/import/ini_file.h"
#include "machine/import/linuxcnc_axes.h"
#include "machine/import/linuxcnc_tables.h"

namespace gsim::import {

namespace {

constexpr std::string_view kModel29 = "linuxcnc-2.9";
constexpr std::string_view kModel210 = "linuxcnc-2.10";
constexpr double kDefaultJerk_mm_s3 = 1e9;  // of [TRAJ] in 2.10
constexpr double kPercent = 100;
constexpr double kNanosecond_s = 1e-9;

/// A planner parameter that is built in with this value.
struct FixedValue {
    std::string_view section;
    std::string_view key;
    double value;
};
constexpr std::array kFixedValues{
    FixedValue{"TRAJ", "ARC_BLEND_ENABLE", 1},       FixedValue{"TRAJ", "ARC_BLEND_FALLBACK_ENABLE", 0},
    FixedValue{"TRAJ", "ARC_BLEND_GAP_CYCLES", 4},   FixedValue{"TRAJ", "ARC_BLEND_RAMP_FREQ", 100},
    FixedValue{"TRAJ", "ARC_BLEND_KINK_RATIO", 0.1}, FixedValue{"TRAJ", "SCURVE_PEAK_SCALE", 1},
};

class Importer {
  public:
    Importer(IniFile ini, const std::filesystem::path& path, const os::Files& files)
        : ini_(std::move(ini)), folder_(path.parent_path()), files_(files) {}

    Result<ImportResult> release() {
        return read_units(ini_)
            .and_then([&](const IniUnits& units) {
                units_ = units;
                return read_axes(ini_, units_, result_.warnings);
            })
            .and_then([&](std::vector<machine::Axis> axes) {
                result_.machine.axes = std::move(axes);
                return import_remainder();
            })
            .map([&] {
                leave_out();
                return std::move(result_);
            });
    }

  private:
    Result<void> import_remainder() {
        read_name();
        import_units();
        for (const auto step : {&Importer::import_path_limits, &Importer::import_planner,
                                &Importer::import_parameter_file, &Importer::import_tool_table}) {
            if (Result<void> done = (this->*step)(); !done) return done;
        }
        return {};
    }

    void read_name() {
        result_.machine.name = ini_.text("EMC", "MACHINE").value_or("LinuxCNC");
        ini_.find("EMC", "VERSION");  // version of the file's format
        // Three slides have an inverse in any case; the file does not give the positions of rotary axes.
        const auto linear = [](const machine::Axis& axis) { return axis.kind == machine::AxisKind::linear; };
        const bool slides = result_.machine.axes.size() == 3 && letters() == "XYZ" &&
                            std::all_of(result_.machine.axes.begin(), result_.machine.axes.end(), linear);
        result_.machine.inverse = slides ? machine::InverseKind::gantry : machine::InverseKind::none;
    }

    std::string letters() const {
        std::string letters;
        for (const machine::Axis& axis : result_.machine.axes) letters += axis.letter;
        return letters;
    }

    // RS274NGC_STARTUP_CODE runs before each program; only its units are known here.
    void import_units() {
        result_.machine.program.dialect = "linuxcnc";
        if (units_.linear_mm == kMmPerInch) result_.machine.program.units = machine::ProgramUnits::inch;
        const auto startup_code = ini_.text("RS274NGC", "RS274NGC_STARTUP_CODE");
        if (!startup_code) return;
        const std::string code = text::upper(*startup_code);
        if (code.find("G20") != std::string::npos)
            result_.machine.program.units = machine::ProgramUnits::inch;
        if (code.find("G21") != std::string::npos) result_.machine.program.units = machine::ProgramUnits::mm;
        result_.warnings.push_back(fmt::format(
            "[RS274NGC] RS274NGC_STARTUP_CODE = {} is not run before programs; only its units are imported",
            *startup_code));
    }

    // Reads a number of [TRAJ] by the first of two names; the second is the name in older versions.
    Result<std::optional<double>> path_limit(std::string_view key, std::string_view old_key) {
        auto value = ini_.number("TRAJ", key);
        if (value && !value->has_value()) return ini_.number("TRAJ", old_key);
        return value;
    }

    Result<void> import_path_limits() {
        machine::PathLimits& path = result_.machine.path;
        const auto speed = path_limit("MAX_LINEAR_VELOCITY", "MAX_VELOCITY");
        if (!speed) return tl::unexpected(speed.error());
        if (*speed) path.max_feed_mm_s = path.max_rapid_mm_s = **speed * units_.linear_mm;
        const auto acceleration = path_limit("MAX_LINEAR_ACCELERATION", "MAX_ACCELERATION");
        if (!acceleration) return tl::unexpected(acceleration.error());
        if (!*acceleration) return {};
        path.max_acceleration_mm_s2 = **acceleration * units_.linear_mm;
        for (const machine::Axis& axis : result_.machine.axes) {
            if (axis.kind == machine::AxisKind::rotary ||
                axis.max_acceleration <= path.max_acceleration_mm_s2)
                continue;
            result_.warnings.push_back(
                fmt::format("[TRAJ] MAX_LINEAR_ACCELERATION, less than that of axis {}, is imported for feed "
                            "moves, not for rapid moves",
                            axis.letter));
            break;
        }
        return {};
    }

    // The values are shares of 1.
    Result<void> read_overrides(rrs::OverrideRules& overrides) {
        for (const auto& [key, percent] : {std::pair{"MAX_FEED_OVERRIDE", &overrides.feed_max_percent},
                                           {"MIN_SPINDLE_OVERRIDE", &overrides.spindle_min_percent},
                                           {"MAX_SPINDLE_OVERRIDE", &overrides.spindle_max_percent}}) {
            const auto share = ini_.number("DISPLAY", key);
            if (!share) return tl::unexpected(share.error());
            if (*share && **share > 0) *percent = **share * kPercent;
        }
        overrides.planned_feed_percent = overrides.feed_max_percent;
        return {};
    }

    // PLANNER_TYPE is a key of 2.10.
    Result<void> import_release(rrs::ControllerRules& rules) {
        const auto planner = ini_.number("TRAJ", "PLANNER_TYPE");
        if (!planner) return tl::unexpected(planner.error());
        rules = machine::built_in_controller(*planner ? kModel210 : kModel29).value();
        if (!*planner) return {};
        const auto clearance = ini_.number("RS274NGC", "G83_PECK_CLEARANCE");
        if (!clearance) return tl::unexpected(clearance.error());
        if (*clearance && **clearance >= 0) rules.drilling.peck_clearance_mm = **clearance * units_.linear_mm;
        if (**planner != 1) return {};
        rules.ramps.limit_jerk = true;
        return import_jerk();
    }

    Result<void> import_jerk() {
        const auto jerk = ini_.number("TRAJ", "MAX_LINEAR_JERK");
        if (!jerk) return tl::unexpected(jerk.error());
        const bool given = *jerk && **jerk > 0;
        result_.machine.path.max_jerk_mm_s3 = given ? **jerk * units_.linear_mm : kDefaultJerk_mm_s3;
        std::string straight;
        for (const machine::Axis& axis : result_.machine.axes) {
            if (std::isinf(axis.max_jerk)) straight += straight.empty() ? "" : ", ";
            if (std::isinf(axis.max_jerk)) straight += axis.letter;
        }
        if (straight.empty()) return {};
        result_.warnings.push_back(
            fmt::format("[TRAJ] PLANNER_TYPE = 1 does not use S-curves for moves of {}, whose sections have "
                        "no MAX_JERK, as in LinuxCNC",
                        straight));
        return {};
    }

    Result<void> import_planner() {
        rrs::ControllerRules& rules = result_.machine.controller;
        if (Result<void> done = import_release(rules); !done) return done;
        const auto period_ns = ini_.number("EMCMOT", "SERVO_PERIOD");
        if (!period_ns) return tl::unexpected(period_ns.error());
        if (*period_ns) rules.position_loop.servo_period_s = **period_ns * kNanosecond_s;
        const auto depth = ini_.number("TRAJ", "ARC_BLEND_OPTIMIZATION_DEPTH");
        if (!depth) return tl::unexpected(depth.error());
        constexpr double kMaxBlocks =
            1e6;  // above the max of a machine file, and within the range of an integer
        if (*depth && **depth >= 1)
            rules.blocks.look_ahead = static_cast<std::size_t>(std::min(**depth, kMaxBlocks));
        if (auto is_used = read_overrides(rules.overrides); !is_used) return is_used;
        for (const FixedValue& fixed : kFixedValues) {
            const auto value = ini_.number(fixed.section, fixed.key);
            if (!value) return tl::unexpected(value.error());
            if (!*value || **value == fixed.value) continue;
            result_.warnings.push_back(
                fmt::format("[{}] {} = {} is not imported: the planner here is that of LinuxCNC with {}",
                            fixed.section, fixed.key, **value, fixed.value));
        }
        return {};
    }

    // Returns the text of a file that the INI file names; nothing if it names none, or the file does not
    // exist.
    std::optional<std::pair<std::string, std::string>> named_file(std::string_view section,
                                                                  std::string_view key) {
        const auto name = ini_.text(section, key);
        if (!name || name->empty()) return std::nullopt;
        const std::filesystem::path path = folder_ / *name;
        auto text = files_.read_text(path);
        if (text) return std::pair(path.string(), *std::move(text));
        result_.warnings.push_back(
            fmt::format("[{}] {} = {} is not imported: {}", section, key, *name, text.error().message));
        return std::nullopt;
    }

    Result<void> import_parameter_file() {
        const auto file = named_file("RS274NGC", "PARAMETER_FILE");
        return file ? import_table_file(*file, import_parameters) : Result<void>();
    }

    Result<void> import_tool_table() {
        const auto file = named_file("EMCIO", "TOOL_TABLE");
        return file ? import_table_file(*file, import_tools) : Result<void>();
    }

    Result<void> import_table_file(const std::pair<std::string, std::string>& file,
                                   Result<void> (*import_table)(std::string_view, std::string_view, double,
                                                                std::string_view, machine::MachineData&,
                                                                ImportNotes&)) {
        ImportNotes notes;
        Result<void> done =
            import_table(file.second, file.first, units_.linear_mm, letters(), result_.data, notes);
        result_.has_data = true;
        for (const std::string& name : notes.left_out)
            result_.left_out.push_back(
                fmt::format("{}: {}", std::filesystem::path(file.first).filename().string(), name));
        return done;
    }

    // Lists the entries that were not queried, by sections.
    void leave_out() {
        std::vector<std::pair<std::string, std::string>> sections;
        for (const IniEntry& entry : ini_.entries()) {
            if (entry.is_used) continue;
            auto found = std::find_if(sections.begin(), sections.end(),
                                      [&](const auto& one) { return one.first == entry.section; });
            if (found == sections.end()) found = sections.insert(sections.end(), {entry.section, ""});
            if ((", " + found->second + ",").find(", " + entry.key + ",") != std::string::npos) continue;
            found->second += (found->second.empty() ? "" : ", ") + entry.key;
        }
        for (const auto& [section, keys] : sections)
            result_.left_out.push_back(fmt::format("[{}] {}", section, keys));
    }

    IniFile ini_;
    std::filesystem::path folder_;
    const os::Files& files_;
    IniUnits units_;
    ImportResult result_;
};

}  // namespace

Result<ImportResult> import_linuxcnc(std::string_view text, const std::filesystem::path& path,
                                     const os::Files& files) {
    return IniFile::read(text, path, files).and_then([&](IniFile ini) {
        return Importer(std::move(ini), path, files).release();
    });
}

}  // namespace gsim::import
