#include "calibrate/times/fit_output.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "base/text/json.h"
#include "base/text/xml_text.h"
#include "calibrate/text/svg_header.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate {

namespace {

using Json = nlohmann::ordered_json;

double error_percent(const Fit& fit, std::span<const RecordedRun> runs, std::size_t i) {
    return runs[i].error_percent(fit.times_s[i]);
}

std::string run_name(const RecordedRun& run) {
    return std::filesystem::path(run.program).filename().string();
}

struct ErrorSummary {
    double mean_percent = 0;
    double largest_percent = 0;
};

ErrorSummary run_errors(const Fit& fit, std::span<const RecordedRun> runs) {
    ErrorSummary errors;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double error = std::abs(error_percent(fit, runs, i));
        errors.mean_percent += error / static_cast<double>(runs.size());
        errors.largest_percent = std::max(errors.largest_percent, error);
    }
    return errors;
}

std::string value_text(const FittedParameter& parameter) {
    if (!parameter.identified)
        return fmt::format("{:.6g}, not determined by these runs alone", parameter.value);
    return fmt::format("{:.6g} +- {:.2g} % (one standard deviation)", parameter.value,
                       100 * parameter.standard_deviation);
}

std::vector<std::size_t> runs_by_error(const Fit& fit, std::span<const RecordedRun> runs) {
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(error_percent(fit, runs, a)) > std::abs(error_percent(fit, runs, b));
    });
    return order;
}

}  // namespace

machine::Calibration make_calibration(const Fit& fit) {
    constexpr double kPercentSquared = 1e4;
    machine::Calibration calibration;
    calibration.runs = static_cast<int>(fit.times_s.size());
    calibration.residual_percent = 100 * fit.noise;
    for (Eigen::Index i = 0; i < fit.covariance.rows(); ++i) {
        calibration.parameters.push_back(fit.parameters[static_cast<std::size_t>(i)].parameter_id);
        std::vector<double>& row = calibration.covariance_percent2.emplace_back();
        for (Eigen::Index k = 0; k < fit.covariance.cols(); ++k)
            row.push_back(kPercentSquared * (fit.covariance(i, k) + fit.covariance(k, i)) / 2);
    }
    return calibration;
}

std::string machine_text(const Fit& fit, std::span<const RecordedRun> runs) {
    const ErrorSummary errors = run_errors(fit, runs);
    std::string text = fmt::format(
        "# Fitted to the times of {} recorded runs by gsim-calibrate: mean error {:.2f} %, max error {:.2f} "
        "%.\n",
        runs.size(), errors.mean_percent, errors.largest_percent);
    for (const FittedParameter& parameter : fit.parameters)
        text += fmt::format("# {} = {}\n", machine::parameter_name(parameter.parameter_id),
                            value_text(parameter));
    machine::Machine calibrated = fit.machine;
    calibrated.calibration = make_calibration(fit);
    return text + "\n" + machine::print_machine(calibrated);
}

std::string fit_table(const Fit& fit, std::span<const RecordedRun> runs) {
    std::string text;
    for (const FittedParameter& parameter : fit.parameters)
        text += fmt::format("  {} = {}\n", machine::parameter_name(parameter.parameter_id),
                            value_text(parameter));
    text += fmt::format("\n{:<40} {:>12} {:>12} {:>9}\n", "run", "recorded s", "fitted s", "error %");
    for (const std::size_t i : runs_by_error(fit, runs)) {
        text += fmt::format("{:<40} {:>12.3f} {:>12.3f} {:>+9.2f}\n", run_name(runs[i]), runs[i].time_s,
                            fit.times_s[i], error_percent(fit, runs, i));
    }
    const ErrorSummary errors = run_errors(fit, runs);
    return text + fmt::format("\n{} runs, mean error {:.2f} %, max error {:.2f} %\n", runs.size(),
                              errors.mean_percent, errors.largest_percent);
}

std::string fit_json(const Fit& fit, std::span<const RecordedRun> runs,
                     const std::optional<ModelSelection>& selection) {
    Json json;
    json["noise_percent"] = 100 * fit.noise;
    Json& parameters = json["parameters"] = Json::array();
    for (const FittedParameter& parameter : fit.parameters) {
        Json& entry = parameters.emplace_back(
            Json{{"name", machine::parameter_name(parameter.parameter_id)}, {"value", parameter.value}});
        entry["identified"] = parameter.identified;
        entry["standard_deviation_percent"] =
            parameter.identified ? Json(100 * parameter.standard_deviation) : Json(nullptr);
    }
    Json& rows = json["log_covariance"] = Json::array();
    for (Eigen::Index i = 0; i < fit.covariance.rows(); ++i) {
        Json& row = rows.emplace_back(Json::array());
        for (Eigen::Index k = 0; k < fit.covariance.cols(); ++k) row.push_back(fit.covariance(i, k));
    }
    Json& all = json["runs"] = Json::array();
    for (std::size_t i = 0; i < runs.size(); ++i)
        all.push_back(
            {{"program", runs[i].program}, {"recorded_s", runs[i].time_s}, {"fitted_s", fit.times_s[i]}});
    if (!selection) return json.dump(2) + "\n";
    Json& models = json["models"] = Json::array();
    for (const Score& score : selection->scores) {
        Json& entry = models.emplace_back(Json{{"name", score.name}});
        entry["fitted_percent"] = score.error_text.empty() ? Json(score.fitted_percent) : Json(nullptr);
        entry["predicted_percent"] = score.is_predicted ? Json(score.mean_percent) : Json(nullptr);
        entry["predicted_largest_percent"] = score.is_predicted ? Json(score.largest_percent) : Json(nullptr);
        if (!score.error_text.empty()) entry["error"] = score.error_text;
    }
    json["selected"] = selection->scores[selection->best].name;
    return json.dump(2) + "\n";
}

std::string residuals_svg(const Fit& fit, std::span<const RecordedRun> runs) {
    constexpr double kRow = 16, kLeft = 260, kHalfWidth = 200, kTop = 30;
    const double max = std::max(run_errors(fit, runs).largest_percent, 0.1);
    const double middle = kLeft + kHalfWidth;
    const double height = kTop + kRow * static_cast<double>(runs.size()) + 10;
    std::string svg = svg_header(middle + kHalfWidth + 20, height);
    svg += fmt::format(
        "<text x=\"{0:.0f}\" y=\"16\" text-anchor=\"middle\">fitted - recorded, % (max "
        "{1:.2f})</text>\n<line x1=\"{0:.0f}\" y1=\"22\" x2=\"{0:.0f}\" y2=\"{2:.0f}\" stroke=\"#888\"/>\n",
        middle, max, height - 5);
    double y = kTop;
    for (const std::size_t i : runs_by_error(fit, runs)) {
        const double error = error_percent(fit, runs, i);
        const double length = std::abs(error) / max * kHalfWidth;
        svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text>\n", kLeft - 8,
                           y + 11, text::xml_text(run_name(runs[i])));
        svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.0f}\" width=\"{:.1f}\" height=\"12\" fill=\"{}\"/>\n",
                           error < 0 ? middle - length : middle, y + 1, std::max(length, 0.5),
                           error < 0 ? "#0072b2" : "#d55e00");
        y += kRow;
    }
    return svg + "</svg>\n";
}

}  // namespace gsim::calibrate
