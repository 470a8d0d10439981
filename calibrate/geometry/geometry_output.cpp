#include "calibrate/geometry/geometry_output.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "base/text/json.h"
#include "calibrate/text/svg_header.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate {

namespace {

using Json = nlohmann::ordered_json;

/// Ratio of errors after the fit to noise above which other errors are present.
constexpr double kMaxResidualNoise = 1.5;

/// Values in users' units: micrometres, seconds of arc, parts per million.
struct DisplayUnit {
    double factor = 1;
    std::string_view unit;
};

DisplayUnit display_unit(DeviationUnit unit) {
    switch (unit) {
        case DeviationUnit::mm: return {kMicrometresPerMm, "um"};
        case DeviationUnit::deg: return {kArcsecPerDeg, "arcsec"};
        case DeviationUnit::ppm: break;
    }
    return {1, "ppm"};
}

std::string value_with_uncertainty(const FittedDeviation& found) {
    const DisplayUnit display = display_unit(found.deviation.unit);
    return fmt::format("{:+.2f} {} +- {:.2f}", display.factor * found.value, display.unit,
                       display.factor * found.standard_deviation);
}

std::string summary_line(const GeometryFit& fit) {
    const TcpErrorSummary before = summarize_errors(fit.before), after = summarize_errors(fit.after);
    std::string text = fmt::format(
        "{} TCP positions: error {:.1f} um before (root mean square; max {:.1f}), {:.2f} um after ({:.2f})",
        fit.before.size(), before.rms_um, before.max_um, after.rms_um, after.max_um);
    if (before.rms_arcsec > 0)
        text += fmt::format("; orientation error {:.1f} arcsec before, {:.2f} after", before.rms_arcsec,
                            after.rms_arcsec);
    return text;
}

std::vector<std::size_t> indices_by_error(const GeometryFit& fit) {
    std::vector<std::size_t> order(fit.after.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return fit.after[a].mm.squaredNorm() > fit.after[b].mm.squaredNorm();
    });
    return order;
}

double length_um(const TcpError& error) {
    return kMicrometresPerMm * error.mm.norm();
}

Json numbers(const Eigen::VectorXd& values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(value);
    return list;
}

Json errors_json(const TcpErrorSummary& summary) {
    return {{"rms_um", summary.rms_um},
            {"greatest_um", summary.max_um},
            {"rms_arcsec", summary.rms_arcsec},
            {"greatest_arcsec", summary.max_arcsec}};
}

}  // namespace

Result<std::string> geometry_text(const GeometryFit& fit) {
    std::string text = fmt::format("# Geometry by gsim-calibrate. {}.\n", summary_line(fit));
    for (const FittedDeviation& found : fit.found) {
        const bool in_file = found.deviation.kind != Deviation::Kind::scale &&
                             found.deviation.kind != Deviation::Kind::instrument;
        text += fmt::format("# {}: {} (one standard deviation){}\n", found.deviation.name,
                            value_with_uncertainty(found),
                            in_file ? "" : ", which a machine file cannot contain");
    }
    text += "\n" + machine::print_machine(fit.geometry.machine);
    if (const auto read = machine::read_machine(text, "the fitted machine"); !read)
        return tl::unexpected(read.error());
    return text;
}

std::string geometry_table(const GeometryFit& fit, std::span<const Squareness> squareness) {
    std::string text = fmt::format("{:<22} {:>24}\n", "found", "(one standard deviation)");
    for (const FittedDeviation& found : fit.found)
        text += fmt::format("  {:<20} {}\n", found.deviation.name, value_with_uncertainty(found));
    for (const Squareness& pair : squareness)
        text += fmt::format("  {:<20} {:+.2f} um/m +- {:.2f}\n",
                            fmt::format("square {} {}", pair.first, pair.second), pair.value_um_m,
                            pair.standard_deviation_um_m);
    if (!fit.fixed.empty()) text += "\nnot distinguishable from others, and unchanged from the file\n";
    for (const FixedDeviation& fixed : fit.fixed)
        text += fmt::format("  {:<20} {}\n", fixed.name, fixed.reason);
    text += fmt::format("\n{:<6} {:>12} {:>12}\n", "TCP", "before um", "after um");
    for (const std::size_t i : indices_by_error(fit))
        text +=
            fmt::format("{:<6} {:>12.2f} {:>12.2f}{}\n", i + 1, length_um(fit.before[i]),
                        length_um(fit.after[i]), fit.outliers[i] ? "  an outlier, with a low weight" : "");
    text += fmt::format("\n{}\nnoise {}: {:.2f} um per coordinate", summary_line(fit),
                        fit.noise_is_estimated ? "found" : "as given", kMicrometresPerMm * fit.noise.mm);
    if (!fit.noise_is_estimated)
        text += fmt::format("; the residual is {:.2f} times the noise", fit.residual_noise_ratio);
    if (fit.residual_noise_ratio > kMaxResidualNoise)
        text +=
            "\nthe residual exceeds the noise: the machine has deviations that are not fitted, or the TCP "
            "positions are less accurate than specified";
    return text + "\n";
}

std::string geometry_json(const GeometryFit& fit, std::span<const Squareness> squareness) {
    Json json;
    json["before"] = errors_json(summarize_errors(fit.before));
    json["after"] = errors_json(summarize_errors(fit.after));
    json["noise_um"] = kMicrometresPerMm * fit.noise.mm;
    json["noise_arcsec"] = kArcsecPerDeg * fit.noise.deg;
    json["noise_is_found"] = fit.noise_is_estimated;
    json["residual_noise_ratio"] = fit.residual_noise_ratio;
    Json& found = json["found"] = Json::array();
    for (const FittedDeviation& one : fit.found)
        found.push_back({{"name", one.deviation.name},
                         {"value", one.value},
                         {"standard_deviation", one.standard_deviation}});
    Json& fixed = json["fixed"] = Json::array();
    for (const FixedDeviation& one : fit.fixed) fixed.push_back({{"name", one.name}, {"reason", one.reason}});
    Json& square = json["squareness"] = Json::array();
    for (const Squareness& one : squareness)
        square.push_back({{"axes", std::string{one.first, one.second}},
                          {"value_um_m", one.value_um_m},
                          {"standard_deviation_um_m", one.standard_deviation_um_m}});
    Json& rows = json["covariance"] = Json::array();
    for (Eigen::Index i = 0; i < fit.covariance.rows(); ++i) rows.push_back(numbers(fit.covariance.row(i)));
    json["singular_values"] = numbers(fit.singular_values);
    Json& tcps = json["tcps"] = Json::array();
    for (std::size_t i = 0; i < fit.after.size(); ++i) {
        tcps.push_back({{"before_mm", numbers(fit.before[i].mm)},
                        {"after_mm", numbers(fit.after[i].mm)},
                        {"after_deg", numbers(fit.after[i].deg)},
                        {"outlier", static_cast<bool>(fit.outliers[i])}});
    }
    return json.dump(2) + "\n";
}

std::string tcps_svg(const GeometryFit& fit) {
    constexpr double kRow = 14, kLeft = 60, kBarWidth = 260, kGap = 40, kTop = 34;
    const double max_before = std::max(summarize_errors(fit.before).max_um, 1e-3);
    const double max_after = std::max(summarize_errors(fit.after).max_um, 1e-3);
    const double width = kLeft + 2 * kBarWidth + kGap + 20;
    const double height = kTop + kRow * static_cast<double>(fit.after.size()) + 10;
    std::string svg = svg_header(width, height);
    const double right = kLeft + kBarWidth + kGap;
    svg += fmt::format("<text x=\"{:.0f}\" y=\"16\">before, um (max {:.1f})</text>\n", kLeft, max_before);
    svg += fmt::format("<text x=\"{:.0f}\" y=\"16\">after, um (max {:.2f})</text>\n", right, max_after);
    double y = kTop;
    for (const std::size_t i : indices_by_error(fit)) {
        svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"end\">TCP {}</text>\n", kLeft - 8,
                           y + 10, i + 1);
        const auto bar = [&](double x, double length, const char* colour) {
            svg +=
                fmt::format("<rect x=\"{:.1f}\" y=\"{:.0f}\" width=\"{:.1f}\" height=\"10\" fill=\"{}\"/>\n",
                            x, y + 1, std::max(length, 0.5), colour);
        };
        bar(kLeft, length_um(fit.before[i]) / max_before * kBarWidth, "#d55e00");
        bar(right, length_um(fit.after[i]) / max_after * kBarWidth, fit.outliers[i] ? "#cc79a7" : "#0072b2");
        y += kRow;
    }
    return svg + "</svg>\n";
}

}  // namespace gsim::calibrate
