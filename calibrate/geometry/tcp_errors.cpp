#include "calibrate/geometry/tcp_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace gsim::calibrate {

namespace {

/// Returns the step of differences: small enough for curvature, large enough for rounding.
double difference_step(const Deviation& deviation) {
    return 0.02 * typical_size(deviation);
}

TcpError tcp_error(const TcpCalculator& calculator, const MeasuredTcp& measured) {
    const rrs::CartPos tcp = calculator.tcp(measured.readings);
    TcpError error{.mm = tcp.translation() - measured.tcp.translation()};
    if (!measured.has_orientation) return error;
    const Eigen::Quaterniond rotation(tcp.linear() * measured.tcp.linear().transpose());
    const double half_sine = rotation.vec().norm();
    // 2 atan2(s, c) / s, which is 2 / c if s is almost 0
    const double scale_factor =
        half_sine > 1e-12 ? 2 * std::atan2(half_sine, std::abs(rotation.w())) / half_sine : 2.0;
    error.deg = (rotation.w() < 0 ? -scale_factor : scale_factor) * rotation.vec() / kRadPerDeg;
    return error;
}

}  // namespace

std::vector<TcpError> tcp_errors(const Geometry& geometry, std::span<const MeasuredTcp> tcps) {
    const TcpCalculator calculator(geometry);
    std::vector<TcpError> errors;
    errors.reserve(tcps.size());
    for (const MeasuredTcp& tcp : tcps) errors.push_back(tcp_error(calculator, tcp));
    return errors;
}

TcpErrorSummary summarize_errors(std::span<const TcpError> errors) {
    double position_sum_mm2 = 0, deg2 = 0, max_mm2 = 0, max_deg2 = 0;
    for (const TcpError& error : errors) {
        position_sum_mm2 += error.mm.squaredNorm();
        deg2 += error.deg.squaredNorm();
        max_mm2 = std::max(max_mm2, error.mm.squaredNorm());
        max_deg2 = std::max(max_deg2, error.deg.squaredNorm());
    }
    const double count = std::max<double>(static_cast<double>(errors.size()), 1);
    return {.rms_um = std::sqrt(position_sum_mm2 / count) * kMicrometresPerMm,
            .max_um = std::sqrt(max_mm2) * kMicrometresPerMm,
            .rms_arcsec = std::sqrt(deg2 / count) * kArcsecPerDeg,
            .max_arcsec = std::sqrt(max_deg2) * kArcsecPerDeg};
}

WeightedErrors::WeightedErrors(const DeviatedMachine& machine, std::span<const Deviation> deviations,
                               std::span<const MeasuredTcp> tcps, const Noise& noise)
    : machine_(machine), deviations_(deviations), tcps_(tcps), noise_(noise), first_row_{0} {
    for (const MeasuredTcp& tcp : tcps)
        first_row_.push_back(first_row_.back() + (tcp.has_orientation ? 6 : 3));
}

Eigen::VectorXd WeightedErrors::at(const Eigen::VectorXd& values) const {
    const TcpCalculator calculator(machine_.at(deviations_, values));
    Eigen::VectorXd errors(size());
    for (std::size_t i = 0; i < tcps_.size(); ++i) {
        const TcpError error = tcp_error(calculator, tcps_[i]);
        errors.segment<3>(first_row_[i]) = error.mm / tcps_[i].sigma_mm.value_or(noise_.mm);
        if (tcps_[i].has_orientation)
            errors.segment<3>(first_row_[i] + 3) = error.deg / tcps_[i].sigma_deg.value_or(noise_.deg);
    }
    return errors;
}

Eigen::MatrixXd WeightedErrors::slopes(const Eigen::VectorXd& values) const {
    Eigen::MatrixXd slopes(size(), values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const double step = difference_step(deviations_[static_cast<std::size_t>(k)]);
        Eigen::VectorXd stepped_values = values;
        stepped_values[k] += step;
        slopes.col(k) = at(stepped_values);
        stepped_values[k] = values[k] - step;
        slopes.col(k) = (slopes.col(k) - at(stepped_values)) / (2 * step);
    }
    return slopes;
}

}  // namespace gsim::calibrate
