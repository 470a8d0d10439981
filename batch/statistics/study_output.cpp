#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/json.h"
#include "base/text/xml_text.h"
#include "batch/statistics/study.h"

namespace gsim::batch {

namespace {

using nlohmann::ordered_json;

constexpr double kHistogramWidth_px = 640, kHistogramHeight_px = 160, kMargin_px = 40;
constexpr std::size_t kMaxPages = 200;  // studies of a page

std::string_view machine_or_none(std::string_view machine) {
    return machine.empty() ? std::string_view("built-in machine") : machine;
}

std::string format_interval(const Interval& interval) {
    const auto end = [](std::optional<double> value) {
        return value ? fmt::format("{:.6g}", *value) : std::string("?");
    };
    return fmt::format("{} to {}", end(interval.min), end(interval.max));
}

ordered_json as_json(const Interval& interval) {
    const auto end = [](std::optional<double> value) {
        return value ? ordered_json(*value) : ordered_json();
    };
    return {end(interval.min), end(interval.max)};
}

ordered_json as_json(const SampleSummary& summary) {
    ordered_json percentiles = ordered_json::array();
    for (const Percentile& each : summary.percentiles)
        percentiles.push_back(
            {{"share", each.share}, {"value", each.value}, {"interval_95", as_json(each.interval)}});
    return {{"count", summary.count},
            {"mean", summary.mean},
            {"mean_interval_95", as_json(summary.mean_interval)},
            {"deviation", summary.deviation},
            {"min", summary.min},
            {"max", summary.max},
            {"percentiles", percentiles},
            {"runs_for_1_percent", summary.runs_for_percent}};
}

ordered_json as_json(const Study& study) {
    ordered_json text{{"program", study.program},
                      {"machine", study.machine},
                      {"runs", study.runs},
                      {"failed", study.failed},
                      {"failed_share_95", as_json(study.failed_share)}};
    for (const auto& [cause, count] : study.causes) text["causes"][cause] = count;
    if (study.time.count == 0) return text;
    text["cycle_time_s"] = as_json(study.time);
    for (const Bin& bin : histogram(study.times_s))
        text["histogram_s"].push_back({bin.from, bin.to, bin.count});
    for (const Convergence& step : convergence(study.times_s))
        text["convergence"].push_back(
            {{"runs", step.count}, {"mean_s", step.mean}, {"half_width_s", step.half_width}});
    if (study.sensitivity.effects.empty()) return text;
    ordered_json& sensitivity = text["sensitivity"] = {{"method", "standardized regression"},
                                                       {"explained", study.sensitivity.explained}};
    for (const Sensitivity::SettingEffect& part : study.sensitivity.effects)
        sensitivity["settings"].push_back(
            {{"setting", part.setting}, {"slope_s", part.slope}, {"coefficient", part.coefficient}});
    return text;
}

ordered_json as_json(const Comparison& comparison) {
    ordered_json text{{"first", comparison.first},
                      {"second", comparison.second},
                      {"pairs", comparison.pairs},
                      {"faster", comparison.faster},
                      {"slower", comparison.slower},
                      {"fails_first", comparison.fails_first},
                      {"fails_second", comparison.fails_second}};
    if (comparison.difference_s.count > 0) {
        text["first_s"] = comparison.first_s;
        text["second_s"] = comparison.second_s;
        text["difference_s"] = as_json(comparison.difference_s);
    }
    return text;
}

/// Draws the bars of a histogram, with marks at the 5th, 50th and 95th percentile.
std::string picture(const Study& study) {
    const std::vector<Bin> bins = histogram(study.times_s);
    std::uint64_t max = 1;
    for (const Bin& bin : bins) max = std::max(max, bin.count);
    const double from = study.time.min, span = std::max(study.time.max - from, 1e-12);
    const auto x = [&](double value) {
        return kMargin_px + (value - from) / span * (kHistogramWidth_px - 2 * kMargin_px);
    };
    const auto y = [&](double count) {
        return kHistogramHeight_px - 30 - count / static_cast<double>(max) * (kHistogramHeight_px - 50);
    };
    std::string svg =
        fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">", kHistogramWidth_px, kHistogramHeight_px);
    for (const Bin& bin : bins)
        svg += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{:.6g} to {:.6g} s: "
            "{}</title></rect>",
            x(bin.from), y(static_cast<double>(bin.count)), std::max(x(bin.to) - x(bin.from) - 0.5, 0.5),
            kHistogramHeight_px - 30 - y(static_cast<double>(bin.count)), bin.from, bin.to, bin.count);
    for (const Percentile& each : study.time.percentiles) {
        if (each.share != 0.05 && each.share != 0.5 && each.share != 0.95) continue;
        svg += fmt::format(
            "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"12\" y2=\"{1}\"/><text x=\"{0:.1f}\" y=\"10\">{2:g} "
            "%</text>",
            x(each.value), kHistogramHeight_px - 30, 100 * each.share);
    }
    return svg +
           fmt::format("<text x=\"{}\" y=\"{}\">{:.6g} s</text><text x=\"{}\" y=\"{}\">{:.6g} s</text></svg>",
                       kMargin_px, kHistogramHeight_px - 12, study.time.min, kHistogramWidth_px - kMargin_px,
                       kHistogramHeight_px - 12, study.time.max);
}

constexpr const char* kStudyPage = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>gsim-batch</title><style>
body {{ font: 15px/1.5 system-ui, sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; color: #222; }}
pre {{ background: #f5f5f5; padding: 1em; overflow-x: auto; }}
svg {{ width: 100%; max-width: 640px; }} rect {{ fill: #4a7ab5; }} line {{ stroke: #b5524a; }} text {{ font-size: 10px; text-anchor: middle; }}
</style></head><body><h1>Many runs</h1>
{}</body></html>
)";

}  // namespace

std::string to_text(const Study& study) {
    std::string text =
        fmt::format("{} on {}\n  {} runs, {} failed: {:.4g} % ({:.4g} to {:.4g} %)\n", study.program,
                    machine_or_none(study.machine), study.runs, study.failed,
                    100 * static_cast<double>(study.failed) / static_cast<double>(study.runs),
                    100 * study.failed_share.min.value_or(0), 100 * study.failed_share.max.value_or(1));
    for (const auto& [cause, count] : study.causes) text += fmt::format("    {:>8}  {}\n", count, cause);
    if (study.time.count == 0) return text;
    text += fmt::format("  cycle time  mean {:.6g} s ({}), deviation {:.4g} s, {:.6g} to {:.6g} s\n",
                        study.time.mean, format_interval(study.time.mean_interval), study.time.deviation,
                        study.time.min, study.time.max);
    for (const Percentile& each : study.time.percentiles)
        text += fmt::format("  {:>6.4g} %     {:.6g} s ({})\n", 100 * each.share, each.value,
                            format_interval(each.interval));
    text += fmt::format("  {} runs are required for the mean within 1 %\n", study.time.runs_for_percent);
    if (study.sensitivity.effects.empty()) return text;
    text += fmt::format("  by regression, which explains {:.3g} % of the variance:\n",
                        100 * study.sensitivity.explained);
    for (const Sensitivity::SettingEffect& part : study.sensitivity.effects)
        text += fmt::format("    {:+.3f}  {}  ({:+.4g} s per unit)\n", part.coefficient, part.setting,
                            part.slope);
    return text;
}

std::string to_text(const Comparison& comparison) {
    std::string text = fmt::format(
        "{} compared with {}: {} pairs, {} faster, {} slower; only the first fails {}, only the second {}\n",
        machine_or_none(comparison.second), machine_or_none(comparison.first), comparison.pairs,
        comparison.faster, comparison.slower, comparison.fails_first, comparison.fails_second);
    if (comparison.difference_s.count == 0) return text;
    return text + fmt::format("  mean {:+.6g} s ({}), total {:.6g} s instead of {:.6g} s\n",
                              comparison.difference_s.mean,
                              format_interval(comparison.difference_s.mean_interval), comparison.second_s,
                              comparison.first_s);
}

std::string to_json(const std::vector<Study>& studies, const std::vector<Comparison>& comparisons) {
    ordered_json text{{"studies", ordered_json::array()}, {"comparisons", ordered_json::array()}};
    for (const Study& study : studies) text["studies"].push_back(as_json(study));
    for (const Comparison& comparison : comparisons) text["comparisons"].push_back(as_json(comparison));
    return text.dump(1, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::string to_html(const std::vector<Study>& studies, const std::vector<Comparison>& comparisons) {
    std::string body;
    for (const Comparison& comparison : comparisons)
        body += fmt::format("<pre>{}</pre>\n", text::xml_text(to_text(comparison)));
    for (std::size_t i = 0; i < std::min(studies.size(), kMaxPages); ++i) {
        body += fmt::format("<h2>{}</h2>\n", text::xml_text(studies[i].program));
        if (studies[i].time.count > 0) body += picture(studies[i]);
        body += fmt::format("\n<pre>{}</pre>\n", text::xml_text(to_text(studies[i])));
    }
    if (studies.size() > kMaxPages)
        body += fmt::format("<p>{} more are in the JSON.</p>\n", studies.size() - kMaxPages);
    return fmt::format(fmt::runtime(kStudyPage), body);
}

}  // namespace gsim::batch
