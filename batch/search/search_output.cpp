#include "batch/search/search_output.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/text/format.h"
#include "base/text/json.h"
#include "base/text/xml_text.h"
#include "batch/search/metrics.h"
#include "batch/work/run_commands.h"

namespace gsim::batch {

namespace {

using nlohmann::ordered_json;

constexpr double kTrialsWidth_px = 640, kTrialsHeight_px = 220, kLeft_px = 60, kFoot_px = 24;

/// Combines a metric of several runs into one value: distances and times add up; for the others the worst
/// value counts.
std::optional<double> combined_metric(const Trial& trial, std::string_view metric) {
    std::optional<double> all;
    for (const RunMetrics& run : trial.runs) {
        const auto& value = run.metrics.at(std::string(metric));
        if (!value) continue;
        if (!all) {
            all = value;
        } else if (metric == "clearance_mm") {
            all = std::min(*all, *value);
        } else if (metric == "deviation_mm" || metric == "joint_speed_share") {
            all = std::max(*all, *value);
        } else {
            *all += *value;
        }
    }
    return all;
}

std::string format_value(std::optional<double> value) {
    return value ? fmt::format("{:.6g}", *value) : "-";
}

/// Returns a row of a table with start and best in adjacent columns.
std::string row(std::string_view title, std::optional<double> start, std::optional<double> best) {
    return fmt::format("  {:<36}{:>14}{:>14}\n", title, format_value(start), format_value(best));
}

/// Returns the text with "+ " and "x " as in settings_json().
std::string value_text(const SettingValue& setting) {
    if (!setting.value.is_number()) return setting.value.dump();
    const char* use = setting.use == SettingUse::factor ? "x " : setting.use == SettingUse::shift ? "+ " : "";
    return fmt::format("{}{:.6g}", use, setting.value.get<double>());
}

bool is_shown(std::string_view metric) {
    return metric != "cycle_time_max_s" && metric != "lower_bound_s" && metric != "blocks" &&
           metric != "warnings";
}

std::string failure_text(const Trial& trial) {
    for (const RunMetrics& run : trial.runs) {
        if (!run.is_clean())
            return fmt::format("{}: {}", run.program, run.message.empty() ? run.status : run.message);
    }
    return "it exceeds a limit of the search, or has more findings than the start";
}

std::string improvement_text(const SearchState& state) {
    if (!state.best.score.is_feasible())
        return fmt::format("no variant is without errors; the closest one fails: {}\n",
                           failure_text(state.best));
    if (state.best_number == 0) return "no variant is better than the start\n";
    if (!state.start.score.is_feasible())
        return fmt::format("the start fails: {}\n", failure_text(state.start));
    const double start = state.start.score.value.value_or(0), best = state.best.score.value.value_or(0);
    return fmt::format("the objective is reduced by {:.6g} ({:.2f} %)\n", start - best,
                       100 * (start - best) / std::max(std::abs(start), 1e-300));
}

std::string command_line(const Job& job) {
    const ViewCommand command = run_command(run_inputs(job));
    if (command.left_out.empty()) return shell_line(command.words);
    return fmt::format("{}   # without {}, for which it has no option", shell_line(command.words),
                       text::joined(command.left_out, ", "));
}

std::string verification_text(const std::optional<VerificationRun>& verification_run) {
    if (!verification_run) return {};
    std::string text = "verified by separate runs";
    if (verification_run->best.lower_bound_s)
        text += fmt::format("; the min time of this path with any controller is {:.6g} s",
                            *verification_run->best.lower_bound_s);
    if (verification_run->start.lower_bound_s)
        text += fmt::format(" (the start's: {:.6g} s)", *verification_run->start.lower_bound_s);
    text += '\n';
    for (const Job& job : verification_run->files) text += "  " + command_line(job) + '\n';
    return text;
}

ordered_json json_or_null(std::optional<double> value) {
    return value ? ordered_json(*value) : ordered_json();
}

ordered_json as_json(const Trial& trial) {
    ordered_json text{{"settings", settings_json(trial.settings)},
                      {"value", json_or_null(trial.score.value)},
                      {"violation", trial.score.violation},
                      {"runs", ordered_json::array()}};
    for (const RunMetrics& run : trial.runs) {
        ordered_json& one = text["runs"].emplace_back(
            ordered_json{{"program", run.program}, {"status", run.status}, {"cause", run.cause}});
        if (!run.message.empty()) one["message"] = run.message;
        for (const auto& [metric, value] : run.metrics) one[metric] = json_or_null(value);
    }
    return text;
}

ordered_json bound_json(const VerificationRun::BoundedObjective& bounded) {
    return {{"value", json_or_null(bounded.value)}, {"lower_bound_s", json_or_null(bounded.lower_bound_s)}};
}

struct TrialPoint {
    double number, value;
    bool feasible;
};

Result<std::vector<TrialPoint>> read_trial_points(Database& results, std::int64_t search) {
    auto rows = results.prepare(
        "SELECT DISTINCT number, value, violation FROM search_run WHERE search = ? AND value IS NOT NULL "
        "ORDER BY number");
    if (!rows) return tl::unexpected(rows.error());
    rows->bind(1, search);
    std::vector<TrialPoint> trial_points;
    while (true) {
        const auto row = rows->step();
        if (!row) return tl::unexpected(row.error());
        if (!*row) return trial_points;
        trial_points.push_back(
            {static_cast<double>(rows->integer(0)), rows->number(1), rows->number(2) == 0});
    }
}

/// Draws trials over their number, allowed ones filled; the line is the best one so far.
std::string picture(const std::vector<TrialPoint>& trial_points) {
    std::vector<double> values;
    for (const TrialPoint& dot : trial_points) {
        if (dot.feasible) values.push_back(dot.value);
    }
    if (values.empty()) return "<p>No variant is without errors.</p>";
    std::sort(values.begin(), values.end());
    // Much worse values are drawn at the upper edge, because the picture shows how the best ones converge.
    const double min = values.front();
    const double max = std::max(values[values.size() * 9 / 10],
                                trial_points.front().feasible ? trial_points.front().value : min);
    const double span = std::max(max - min, 1e-12);
    const double count = std::max(trial_points.back().number, 1.0);
    const auto x = [&](double number) {
        return kLeft_px + number / count * (kTrialsWidth_px - kLeft_px - 10);
    };
    const auto y = [&](double value) {
        const double share = std::clamp((value - min) / span, -0.05, 1.05);
        return 12 + (1 - share) * (kTrialsHeight_px - kFoot_px - 24);
    };
    std::string svg =
        fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\"><title>Variants of the search</title>",
                    kTrialsWidth_px, kTrialsHeight_px);
    std::string line;
    double best = INFINITY;
    for (const TrialPoint& dot : trial_points) {
        svg += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>",
                           dot.feasible ? "allowed" : "refused", x(dot.number), y(dot.value));
        if (!dot.feasible || dot.value >= best) continue;
        if (std::isfinite(best)) line += fmt::format(" {:.1f},{:.1f}", x(dot.number), y(best));
        best = dot.value;
        line += fmt::format(" {:.1f},{:.1f}", x(dot.number), y(best));
    }
    line += fmt::format(" {:.1f},{:.1f}", x(count), y(best));
    return svg + fmt::format(
                     "<polyline points=\"{}\"/><text x=\"{}\" y=\"{:.1f}\">{:.6g}</text><text x=\"{}\" "
                     "y=\"{:.1f}\">{:.6g}</text><text x=\"{}\" y=\"{}\">{} variants</text></svg>",
                     line, kLeft_px - 4, y(max) + 4, max, kLeft_px - 4, y(min) + 4, min, kTrialsWidth_px - 4,
                     kTrialsHeight_px - 6, trial_points.size());
}

constexpr const char* kSearchPage = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>gsim-optimise</title><style>
:root {{ color-scheme: light dark; }} body {{ font: 15px/1.5 system-ui, sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; }}
pre {{ overflow-x: auto; }} svg {{ width: 100%; max-width: 640px; }} text {{ font-size: 10px; text-anchor: end; fill: currentColor; }}
.allowed {{ fill: #4a7ab5; }} .refused {{ fill: none; stroke: #b5524a; stroke-opacity: 0.5; }} polyline {{ fill: none; stroke: #4a7ab5; }}
</style></head><body><h1>Search by {}</h1>
{}<p>Each dot is a variant, filled if it has no errors; the line is the best one so far.</p>
<pre>{}</pre></body></html>
)";

}  // namespace

std::string to_text(const SearchPlan& search, const SearchState& state,
                    const std::optional<VerificationRun>& verification_run) {
    std::string text = fmt::format("{} variants tried, {} without errors\n", state.trials, state.feasible);
    text += fmt::format("  {:<36}{:>14}{:>14}\n", "", "start", "best");
    text += row("objective", state.start.score.value, state.best.score.value);
    for (const std::string_view metric : kMetrics) {
        const auto start = combined_metric(state.start, metric), best = combined_metric(state.best, metric);
        if (is_shown(metric) && (start.value_or(0) != 0 || best.value_or(0) != 0))
            text += row(metric, start, best);
    }
    for (const SettingValue& setting : state.best.settings)
        text += fmt::format("  {:<50}{:>14}\n", setting.key, value_text(setting));
    if (!state.complete) text += fmt::format("interrupted; {} variants were planned\n", search.variants + 1);
    return text + improvement_text(state) + verification_text(verification_run);
}

std::string to_json(const SearchPlan& search, const SearchState& state,
                    const std::optional<VerificationRun>& verification_run) {
    ordered_json text{{"plan", search.plan.name},      {"search", state.search},
                      {"complete", state.complete},    {"variants", state.trials},
                      {"allowed", state.feasible},     {"best_number", state.best_number},
                      {"start", as_json(state.start)}, {"best", as_json(state.best)}};
    if (verification_run) {
        text["verification"] = {{"start", bound_json(verification_run->start)},
                                {"best", bound_json(verification_run->best)}};
        for (const Job& job : verification_run->files)
            text["verification"]["commands"].push_back(command_line(job));
    }
    return text.dump(1, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

Result<std::string> to_html(const SearchPlan& search, const SearchState& state,
                            const std::optional<VerificationRun>& verification_run, Database& results) {
    return read_trial_points(results, state.search).map([&](const std::vector<TrialPoint>& trial_points) {
        return fmt::format(fmt::runtime(kSearchPage), text::xml_text(search.plan.name), picture(trial_points),
                           text::xml_text(to_text(search, state, verification_run)));
    });
}

}  // namespace gsim::batch
