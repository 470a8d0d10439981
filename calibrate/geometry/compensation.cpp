#include "calibrate/geometry/compensation.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsim::calibrate {

namespace {

constexpr int kSteps = 10;  // of a table; its lines lie on a straight one
constexpr int kIterations = 10;
constexpr double kTolerance_mm = 1e-9;
constexpr double kProbeStep_mm = 1;
constexpr double kMinDeterminant = 0.01;

/// Returns X, Y and Z if they are slides, else the first three.
std::vector<std::size_t> find_three_slides(const machine::Machine& machine) {
    std::vector<std::size_t> slides, named_axes;
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        if (axis.kind != machine::AxisKind::linear || axis.carries == machine::CarriedPart::none) continue;
        slides.push_back(i);
        if (axis.letter >= 'X' && axis.letter <= 'Z') named_axes.push_back(i);
    }
    if (named_axes.size() == 3) return named_axes;
    slides.resize(std::min<std::size_t>(slides.size(), 3));
    return slides;
}

/// Finds readings of slides that move the TCP to the work frame's origin; returns false if none do.
bool move_tcp_to_origin(const Geometry& geometry, const std::vector<std::size_t>& slides,
                        std::vector<double>& readings) {
    const TcpCalculator calculator(geometry);
    for (int round = 0; round < kIterations; ++round) {
        const Eigen::Vector3d tcp = calculator.tcp(readings).translation();
        if (tcp.norm() < kTolerance_mm) return true;
        Eigen::Matrix3d directions;
        for (std::size_t i = 0; i < slides.size(); ++i) {
            std::vector<double> stepped_readings = readings;
            stepped_readings[slides[i]] += kProbeStep_mm;
            directions.col(static_cast<Eigen::Index>(i)) =
                (calculator.tcp(stepped_readings).translation() - tcp) / kProbeStep_mm;
        }
        if (std::abs(directions.determinant()) < kMinDeterminant) return false;
        const Eigen::Vector3d step = directions.inverse() * tcp;
        for (std::size_t i = 0; i < slides.size(); ++i)
            readings[slides[i]] -= step[static_cast<Eigen::Index>(i)];
    }
    return false;
}

}  // namespace

std::vector<CompensationTable> compensation_tables(const GeometryFit& fit,
                                                   std::span<const MeasuredTcp> tcps) {
    std::vector<CompensationTable> tables;
    for (const FittedDeviation& found : fit.found) {
        if (found.deviation.kind != Deviation::Kind::scale) continue;
        const machine::Axis& axis = fit.geometry.machine.axes[found.deviation.axis];
        double low = axis.min, high = axis.max;
        if (!std::isfinite(high - low)) {
            const auto [min, max] = std::minmax_element(
                tcps.begin(), tcps.end(), [&](const MeasuredTcp& a, const MeasuredTcp& b) {
                    return a.readings[found.deviation.axis] < b.readings[found.deviation.axis];
                });
            low = min->readings[found.deviation.axis];
            high = max->readings[found.deviation.axis];
        }
        CompensationTable table{.letter = axis.letter, .text = {}};
        for (int i = 0; i <= kSteps; ++i) {
            const double nominal = low + (high - low) * i / kSteps;
            const double actual = nominal * fit.geometry.scales[found.deviation.axis];
            table.text += fmt::format("{0:.6f} {1:.6f} {1:.6f}\n", nominal, actual);
        }
        tables.push_back(std::move(table));
    }
    return tables;
}

Result<std::string> work_offset_line(const machine::Machine& nominal, const GeometryFit& fit) {
    const auto slides = find_three_slides(nominal);
    Geometry geometry = fit.geometry;
    geometry.instrument = rrs::CartPos::Identity();
    std::vector<double> readings;
    for (std::size_t i = 0; i < nominal.axes.size(); ++i) {
        const bool rotary = nominal.axes[i].kind == machine::AxisKind::rotary;
        readings.push_back(rotary ? geometry.machine.axes[i].zero - nominal.axes[i].zero : 0);
    }
    if (slides.size() < 3 || !move_tcp_to_origin(geometry, slides, readings))
        return Unexpected(
            "a work offset (--g10) requires three linear axes that move the TCP to the origin of the work "
            "frame");
    std::string line = "G21\nG10 L2 P1";
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const bool slide = std::find(slides.begin(), slides.end(), i) != slides.end();
        if (slide || nominal.axes[i].kind == machine::AxisKind::rotary)
            line += fmt::format(" {}{:.4f}", nominal.axes[i].letter, readings[i]);
    }
    return line + "\n";
}

}  // namespace gsim::calibrate
