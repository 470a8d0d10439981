#include "calibrate/geometry/tip_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace gsim::calibrate {

namespace {

/// Returns the step of differences: small enough for curvature, large enough for rounding.
double step_of(const Deviation& deviation) {
    return 0.02 * usual_size(deviation);
}

TipError error_of(const TipFinder& finder, const MeasuredTip& measured) {
    const rrs::CartPos tip = finder.tip(measured.readings);
    TipError error{.mm = tip.translation() - measured.tip.translation()};
    if (!measured.has_orientation) return error;
    const Eigen::Quaterniond turn(tip.linear() * measured.tip.linear().transpose());
    const double half_sine = turn.vec().norm();
    // 2 atan2(s, c) / s, which is 2 / c if s is almost 0
    const double per_vector =
        half_sine > 1e-12 ? 2 * std::atan2(half_sine, std::abs(turn.w())) / half_sine : 2.0;
    error.deg = (turn.w() < 0 ? -per_vector : per_vector) * turn.vec() / kRadPerDeg;
    return error;
}

}  // namespace

std::vector<TipError> tip_errors(const Geometry& geometry, std::span<const MeasuredTip> tips) {
    const TipFinder finder(geometry);
    std::vector<TipError> errors;
    errors.reserve(tips.size());
    for (const MeasuredTip& tip : tips) errors.push_back(error_of(finder, tip));
    return errors;
}

TipSummary summary_of(std::span<const TipError> errors) {
    double mm2 = 0, deg2 = 0, most_mm2 = 0, most_deg2 = 0;
    for (const TipError& error : errors) {
        mm2 += error.mm.squaredNorm();
        deg2 += error.deg.squaredNorm();
        most_mm2 = std::max(most_mm2, error.mm.squaredNorm());
        most_deg2 = std::max(most_deg2, error.deg.squaredNorm());
    }
    const double count = std::max<double>(static_cast<double>(errors.size()), 1);
    return {.rms_um = std::sqrt(mm2 / count) * kMicrometresPerMm,
            .greatest_um = std::sqrt(most_mm2) * kMicrometresPerMm,
            .rms_arcsec = std::sqrt(deg2 / count) * kArcsecPerDeg,
            .greatest_arcsec = std::sqrt(most_deg2) * kArcsecPerDeg};
}

WeightedErrors::WeightedErrors(const DeviatedMachine& machine, std::span<const Deviation> deviations,
                               std::span<const MeasuredTip> tips, const Noise& noise)
    : machine_(machine), deviations_(deviations), tips_(tips), noise_(noise), first_{0} {
    for (const MeasuredTip& tip : tips) first_.push_back(first_.back() + (tip.has_orientation ? 6 : 3));
}

Eigen::VectorXd WeightedErrors::at(const Eigen::VectorXd& values) const {
    const TipFinder finder(machine_.at(deviations_, values));
    Eigen::VectorXd errors(size());
    for (std::size_t i = 0; i < tips_.size(); ++i) {
        const TipError error = error_of(finder, tips_[i]);
        errors.segment<3>(first_[i]) = error.mm / tips_[i].sigma_mm.value_or(noise_.mm);
        if (tips_[i].has_orientation)
            errors.segment<3>(first_[i] + 3) = error.deg / tips_[i].sigma_deg.value_or(noise_.deg);
    }
    return errors;
}

Eigen::MatrixXd WeightedErrors::slopes(const Eigen::VectorXd& values) const {
    Eigen::MatrixXd slopes(size(), values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const double step = step_of(deviations_[static_cast<std::size_t>(k)]);
        Eigen::VectorXd beside = values;
        beside[k] += step;
        slopes.col(k) = at(beside);
        beside[k] = values[k] - step;
        slopes.col(k) = (slopes.col(k) - at(beside)) / (2 * step);
    }
    return slopes;
}

}  // namespace gsim::calibrate
