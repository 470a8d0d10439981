#include "runtime/report/report_efforts.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/text/format.h"
#include "runtime/report/json_values.h"
#include "runtime/report/text_helpers.h"

namespace gsim::simulation {

namespace {

constexpr std::size_t kMaxDisplayedExcesses = 20;
constexpr std::size_t kMaxDisplayedPrograms = 8;

std::string effort_unit(bool rotary) {
    return rotary ? "Nm" : "N";
}

Json axis_json(const Report& report, const AxisEffort& axis) {
    const bool has_jump = axis.impulse > 0;
    return {{"axis", letter(axis.letter)},
            {"unit", effort_unit(axis.rotary)},
            {"peak", number(axis.peak)},
            {"t_s", number(axis.peak_t_s)},
            {"file", file(report, axis.peak_location)},
            {"line", line(axis.peak_location)},
            {"rms", number(axis.rms)},
            {"motor_peak", number(axis.motor_peak)},
            {"motor_continuous", number(axis.motor_continuous)},
            {"peak_power_w", number(axis.peak_power_w)},
            {"in_j", number(axis.drive_j)},
            {"back_j", number(axis.regenerated_j)},
            {"friction_j", number(axis.friction_j)},
            {"impulse", number(axis.impulse)},
            {"impulse_file", has_jump ? file(report, axis.impulse_location) : Json(nullptr)},
            {"impulse_line", has_jump ? line(axis.impulse_location) : Json(nullptr)}};
}

Json excess_json(const Report& report, const EffortExcess& excess) {
    return {{"t_s", number(excess.t_s)},
            {"file", excess.continuous ? Json(nullptr) : file(report, excess.location)},
            {"line", excess.continuous ? Json(nullptr) : line(excess.location)},
            {"axis", letter(excess.letter)},
            {"unit", effort_unit(excess.rotary)},
            {"effort", number(excess.effort)},
            {"limit", number(excess.limit)},
            {"kind", excess.continuous ? "continuous" : "peak"},
            {"acceleration_share", number(excess.acceleration_share)},
            {"message", excess_text(excess)}};
}

/// Lines of text.
class ReportLines {
  public:
    template <typename... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        text::append_format(text_, format, std::forward<Args>(args)...);
        text_.erase(text_.find_last_not_of(' ') + 1);
        text_ += '\n';
    }
    std::string release() { return std::move(text_); }

  private:
    std::string text_;
};

void add_axes(ReportLines& out, const Report& report) {
    out.add("{:<9}{:>11}{:>11}{:>12}{:>11}{:>12}{:>12}   {}", "motor", "peak", "of", "rms", "of", "in (kJ)",
            "back (kJ)", "peak at");
    const auto limit = [](double value) {
        return std::isfinite(value) ? fmt::format("{:.1f}", value) : std::string("-");
    };
    for (const AxisEffort& axis : report.drives.efforts->axes) {
        out.add("{} {:<7}{:>11.1f}{:>11}{:>12.1f}{:>11}{:>12.3f}{:>12.3f}   {}", axis.letter,
                effort_unit(axis.rotary), axis.peak, limit(axis.motor_peak), axis.rms,
                limit(axis.motor_continuous), axis.drive_j / 1000, axis.regenerated_j / 1000,
                axis.peak != 0 ? location_text(report, axis.peak_location, 18) : "");
    }
}

void add_energies(ReportLines& out, const EffortReport& efforts) {
    out.add("energy      {:.3f} kJ from the motors, {:.3f} kJ back to them, {:.3f} kJ of this is friction",
            efforts.drive_j / 1000, efforts.regenerated_j / 1000, efforts.friction_j / 1000);
    out.add("peak power  {:.1f} W of all motors together, at {:.3f} s", efforts.peak_power_w,
            efforts.peak_power_t_s);
    if (efforts.time_by_axis_accelerations_s) {
        out.add("limit       torques: with the axis accelerations the same moves take {:.3f} s",
                *efforts.time_by_axis_accelerations_s);
    }
    if (efforts.jumps > 0) {
        out.add("jumps       {} in speed, which need infinite force: they count as energy, not as force",
                efforts.jumps);
    }
    if (efforts.programs.size() < 2) return;
    for (std::size_t i = 0; i < std::min(efforts.programs.size(), kMaxDisplayedPrograms); ++i) {
        const ProgramEnergy& program = efforts.programs[i];
        const std::string name = program.program.empty() ? "the main program" : program.program;
        out.add("  {:<30}{:>12.3f} s{:>12.3f} kJ{:>12.3f} kJ back", truncated(name, 30), program.time_s,
                program.drive_j / 1000, program.regenerated_j / 1000);
    }
    if (efforts.programs.size() > kMaxDisplayedPrograms) out.add("{:>14}", "...");
}

void add_excesses(ReportLines& out, const Report& report) {
    const std::vector<EffortExcess>& list = report.drives.efforts->excesses;
    const std::size_t visible_count = std::min(list.size(), kMaxDisplayedExcesses);
    for (std::size_t i = 0; i < visible_count; ++i) {
        if (list[i].continuous) {
            out.add("motor: {}", excess_text(list[i]));
            continue;
        }
        out.add("motor: {}: {}", location_text(report, list[i].location, 30), excess_text(list[i]));
    }
    if (report.drives.efforts->excess_count > visible_count)
        out.add("and {} more", report.drives.efforts->excess_count - visible_count);
}

}  // namespace

nlohmann::ordered_json efforts_json(const Report& report) {
    const EffortReport& efforts = *report.drives.efforts;
    Json axes = Json::array();
    for (const AxisEffort& axis : efforts.axes) axes.push_back(axis_json(report, axis));
    Json programs = Json::array();
    for (const ProgramEnergy& program : efforts.programs) {
        programs.push_back({{"program", program.program.empty() ? Json(nullptr) : Json(program.program)},
                            {"time_s", number(program.time_s)},
                            {"in_j", number(program.drive_j)},
                            {"back_j", number(program.regenerated_j)}});
    }
    Json excesses = Json::array();
    for (const EffortExcess& excess : efforts.excesses) excesses.push_back(excess_json(report, excess));
    Json json = {{"axes", std::move(axes)},
                 {"in_j", number(efforts.drive_j)},
                 {"back_j", number(efforts.regenerated_j)},
                 {"friction_j", number(efforts.friction_j)},
                 {"peak_power_w", number(efforts.peak_power_w)},
                 {"peak_power_t_s", number(efforts.peak_power_t_s)},
                 {"jumps", efforts.jumps},
                 {"programs", std::move(programs)},
                 {"excesses", std::move(excesses)},
                 {"excess_count", efforts.excess_count}};
    if (efforts.time_by_axis_accelerations_s)
        json["time_by_axes_s"] = number(*efforts.time_by_axis_accelerations_s);
    return json;
}

std::string efforts_text(const Report& report) {
    ReportLines out;
    out.add("");
    add_axes(out, report);
    add_energies(out, *report.drives.efforts);
    add_excesses(out, report);
    return out.release();
}

}  // namespace gsim::simulation
