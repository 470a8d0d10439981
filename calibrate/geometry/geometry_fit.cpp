#include "calibrate/geometry/geometry_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <ceres/ceres.h>
#include <fmt/format.h>

#include "base/dense/symmetric.h"

namespace gsim::calibrate {

namespace {

/// Length of three errors, each of one standard deviation (chi distribution with 3 degrees of freedom): half
/// of them stay below the first value, all but one in 10,000 below the second.
constexpr double kMedianLength = 1.5382;
constexpr double kOutlierLength = 4.60;
/// Error of a TCP, 3 or 6 numbers in units of noise, beyond which it counts less than its square. With
/// ordinary noise hardly any error is beyond it.
constexpr double kHuberThreshold = 4;
constexpr int kNoiseIterations = 4;

/// Errors at the current point of Ceres. Values are in units of deviations' usual sizes, so that steps are
/// comparable.
class CachedErrors : public ceres::EvaluationCallback {
  public:
    CachedErrors(const WeightedErrors& errors, std::span<const Deviation> deviations)
        : errors_(errors), values(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(deviations.size()))) {
        units_.resize(values.size());
        for (std::size_t i = 0; i < deviations.size(); ++i)
            units_[static_cast<Eigen::Index>(i)] = typical_size(deviations[i]);
    }

    void PrepareForEvaluation(bool with_slopes, bool /*is_new*/) override {
        if (current_errors.size() == 0 || values != evaluated_at_) {
            current_errors = errors_.at(scaled_values());
            evaluated_at_ = values;
        }
        if (!with_slopes || (slopes.size() != 0 && values == slopes_at_)) return;
        slopes = errors_.slopes(scaled_values()) * units_.asDiagonal();
        slopes_at_ = values;
    }

    /// Sets derivatives at values of 0, which have been computed before.
    void set_initial_slopes(const Eigen::MatrixXd& at_zero) {
        slopes = at_zero * units_.asDiagonal();
        slopes_at_ = Eigen::VectorXd::Zero(values.size());
    }
    Eigen::VectorXd scaled_values() const { return values.cwiseProduct(units_); }
    const Eigen::VectorXd& units() const { return units_; }
    const WeightedErrors& errors() const { return errors_; }

  private:
    const WeightedErrors& errors_;
    Eigen::VectorXd units_;
    Eigen::VectorXd evaluated_at_;
    Eigen::VectorXd slopes_at_;

  public:
    Eigen::VectorXd values;
    Eigen::VectorXd current_errors;
    Eigen::MatrixXd slopes;
};

/// Error of one TCP.
class TcpResidual : public ceres::CostFunction {
  public:
    TcpResidual(const CachedErrors& cached_errors, Eigen::Index tcp)
        : state_(cached_errors),
          first_row_(cached_errors.errors().first(tcp)),
          size_(cached_errors.errors().size(tcp)) {
        set_num_residuals(static_cast<int>(size_));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(cached_errors.values.size()));
    }

    bool Evaluate(double const* const* /*at*/, double* errors, double** slopes) const override {
        Eigen::Map<Eigen::VectorXd>(errors, size_) = state_.current_errors.segment(first_row_, size_);
        if (slopes == nullptr || slopes[0] == nullptr) return true;
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        Eigen::Map<Rows>(slopes[0], size_, state_.values.size()) =
            state_.slopes.middleRows(first_row_, size_);
        return true;
    }

  private:
    const CachedErrors& state_;
    Eigen::Index first_row_;
    Eigen::Index size_;
};

std::string solve(CachedErrors& cached_errors) {
    ceres::Problem::Options options;
    options.evaluation_callback = &cached_errors;
    ceres::Problem problem(options);
    for (Eigen::Index i = 0; i < cached_errors.errors().count(); ++i)
        problem.AddResidualBlock(new TcpResidual(cached_errors, i), new ceres::HuberLoss(kHuberThreshold),
                                 cached_errors.values.data());
    ceres::Solver::Options solver_options;
    solver_options.linear_solver_type = ceres::DENSE_QR;
    solver_options.max_num_iterations = 30;
    solver_options.function_tolerance = 1e-8;
    solver_options.parameter_tolerance = 1e-7;
    solver_options.gradient_tolerance = 1e-6;
    solver_options.initial_trust_region_radius =
        1e12;  // measured machines lie close: the first step is Gauss's
    solver_options.max_trust_region_radius = 1e16;
    solver_options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver_options, &problem, &summary);
    cached_errors.PrepareForEvaluation(true, true);
    return fmt::format("{} steps, {}", summary.iterations.size(), summary.message);
}

/// Returns the information matrix of the errors for the values, each TCP by its weight.
Eigen::MatrixXd information_matrix(const CachedErrors& cached_errors) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(cached_errors.values.size(), cached_errors.values.size());
    for (Eigen::Index i = 0; i < cached_errors.errors().count(); ++i) {
        const Eigen::Index first = cached_errors.errors().first(i), size = cached_errors.errors().size(i);
        const double length = cached_errors.current_errors.segment(first, size).norm();
        const double weight = length > kHuberThreshold ? kHuberThreshold / length : 1;
        const auto rows = cached_errors.slopes.middleRows(first, size);
        sum.noalias() += weight * rows.transpose() * rows;
    }
    return sum;
}

/// Returns the factor that scales the noise to these lengths; `degrees_of_freedom_share` is the share of all
/// numbers that the fitted values leave. First uses the median, which is robust to outliers, then all but
/// outliers.
double noise_factor(std::vector<double> lengths, double degrees_of_freedom_share) {
    if (lengths.empty()) return 1;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    const double max = *middle * kOutlierLength / kMedianLength;
    double squares = 0, count = 0;
    for (const double length : lengths) {
        if (length > max) continue;
        squares += length * length;
        count += 3;
    }
    return std::sqrt(squares / (count * degrees_of_freedom_share));
}

double error_length(const Eigen::VectorXd& errors, Eigen::Index first) {
    return errors.segment<3>(first).norm();
}

/// Returns the work frame in that of the instrument that aligns TCPs with measured ones (Umeyama).
rrs::CartPos align_work_frame(const machine::Machine& machine, std::span<const MeasuredTcp> tcps) {
    const TcpCalculator calculator(DeviatedMachine({.machine = machine, .scales = {}}).nominal());
    Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(tcps.size())), to = from;
    for (std::size_t i = 0; i < tcps.size(); ++i) {
        from.col(static_cast<Eigen::Index>(i)) = calculator.tcp(tcps[i].readings).translation();
        to.col(static_cast<Eigen::Index>(i)) = tcps[i].tcp.translation();
    }
    return rrs::CartPos(Eigen::umeyama(from, to, false));
}

double residual_noise_ratio(const CachedErrors& cached_errors) {
    double squares = 0;
    for (Eigen::Index i = 0; i < cached_errors.errors().count(); ++i) {
        const double length = cached_errors.current_errors
                                  .segment(cached_errors.errors().first(i), cached_errors.errors().size(i))
                                  .norm();
        squares += length * std::min(length, kHuberThreshold);
    }
    return std::sqrt(squares /
                     static_cast<double>(cached_errors.errors().size() - cached_errors.values.size()));
}

std::vector<bool> find_outliers(const CachedErrors& cached_errors) {
    std::vector<bool> found;
    for (Eigen::Index i = 0; i < cached_errors.errors().count(); ++i) {
        const Eigen::Index first = cached_errors.errors().first(i);
        bool is_outlier = error_length(cached_errors.current_errors, first) > kOutlierLength;
        if (cached_errors.errors().size(i) == 6)
            is_outlier = is_outlier || error_length(cached_errors.current_errors, first + 3) > kOutlierLength;
        found.push_back(is_outlier);
    }
    return found;
}

/// Fit of one machine to its measured TCPs.
class GeometryFitter {
  public:
    GeometryFitter(const machine::Machine& machine, std::span<const MeasuredTcp> tcps,
                   const GeometryOptions& options)
        : options_(options),
          tcps_(tcps),
          deviated_({.machine = machine,
                     .scales = {},
                     .instrument = options.deviation_options.instrument_frame
                                       ? align_work_frame(machine, tcps)
                                       : rrs::CartPos::Identity()}),
          all_(all_deviations(machine, options.deviation_options)) {
        noise_.mm = options.noise_mm.value_or(noise_.mm);
        noise_.deg = options.noise_deg.value_or(noise_.deg);
    }

    Result<GeometryFit> run() {
        if (!select_deviations()) {
            return Unexpected(
                "these TCP positions do not determine the machine's geometry: there are too few, or all "
                "deviations are fixed");
        }
        for (const MeasuredTcp& tcp : tcps_) {
            fit_.noise_is_estimated = fit_.noise_is_estimated || !(options_.noise_mm || tcp.sigma_mm);
            has_orientations_ = has_orientations_ || tcp.has_orientation;
            estimates_rotation_noise_ =
                estimates_rotation_noise_ || (tcp.has_orientation && !(options_.noise_deg || tcp.sigma_deg));
        }
        for (int round = 0;
             round < (fit_.noise_is_estimated || estimates_rotation_noise_ ? kNoiseIterations : 1); ++round) {
            const WeightedErrors errors(deviated_, selected_, tcps_, noise_);
            CachedErrors cached_errors(errors, selected_);
            if (round == 0) cached_errors.set_initial_slopes(initial_slopes_);
            fit_.solver_message = solve(cached_errors);
            store_result(cached_errors);
            estimate_noise(cached_errors);
        }
        return fit_;
    }

  private:
    bool select_deviations() {
        const WeightedErrors errors(deviated_, all_, tcps_, noise_);
        const Eigen::MatrixXd slopes =
            errors.slopes(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all_.size())));
        Identification found = identify(slopes, all_);
        initial_slopes_ = slopes(Eigen::all, found.selected);
        for (const std::size_t i : found.selected) selected_.push_back(all_[i]);
        fit_.fixed = std::move(found.fixed);
        fit_.singular_values = std::move(found.singular_values);
        fit_.before = tcp_errors(deviated_.nominal(), tcps_);
        return !selected_.empty() && errors.size() > static_cast<Eigen::Index>(selected_.size());
    }

    void store_result(const CachedErrors& cached_errors) {
        const Eigen::MatrixXd inverse = base::positive_definite_inverse(information_matrix(cached_errors));
        fit_.covariance = cached_errors.units().asDiagonal() * inverse * cached_errors.units().asDiagonal();
        const Eigen::VectorXd values = cached_errors.scaled_values();
        fit_.geometry = deviated_.at(selected_, values);
        if (!has_orientations_) fit_.geometry = deviated_.with_nominal_orientation(std::move(fit_.geometry));
        fit_.after = tcp_errors(fit_.geometry, tcps_);
        fit_.outliers = find_outliers(cached_errors);
        fit_.noise = noise_;
        fit_.residual_noise_ratio = residual_noise_ratio(cached_errors);
        fit_.found.clear();
        for (std::size_t i = 0; i < selected_.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            fit_.found.push_back({selected_[i], values[k], std::sqrt(fit_.covariance(k, k))});
        }
    }

    /// Takes the remaining errors as the noise of the next round, if it is not given.
    void estimate_noise(const CachedErrors& cached_errors) {
        std::vector<double> position_errors, rotation_errors;
        for (std::size_t i = 0; i < tcps_.size(); ++i) {
            const Eigen::Index first = cached_errors.errors().first(static_cast<Eigen::Index>(i));
            if (!tcps_[i].sigma_mm)
                position_errors.push_back(error_length(cached_errors.current_errors, first));
            if (tcps_[i].has_orientation && !tcps_[i].sigma_deg)
                rotation_errors.push_back(error_length(cached_errors.current_errors, first + 3));
        }
        const double degrees_of_freedom_share = 1 - static_cast<double>(cached_errors.values.size()) /
                                                        static_cast<double>(cached_errors.errors().size());
        constexpr double kMinNoise_mm = 1e-6, kMinNoise_deg = 1e-7;
        if (fit_.noise_is_estimated)
            noise_.mm = std::max(
                noise_.mm * noise_factor(std::move(position_errors), degrees_of_freedom_share), kMinNoise_mm);
        if (estimates_rotation_noise_)
            noise_.deg =
                std::max(noise_.deg * noise_factor(std::move(rotation_errors), degrees_of_freedom_share),
                         kMinNoise_deg);
    }

    const GeometryOptions& options_;
    std::span<const MeasuredTcp> tcps_;
    DeviatedMachine deviated_;
    std::vector<Deviation> all_;
    std::vector<Deviation> selected_;
    Eigen::MatrixXd initial_slopes_;  ///< For the chosen ones, at 0.
    Noise noise_;
    bool estimates_rotation_noise_ = false;
    bool has_orientations_ = false;
    GeometryFit fit_;
};

}  // namespace

Result<GeometryFit> fit_geometry(const machine::Machine& machine, std::span<const MeasuredTcp> tcps,
                                 const GeometryOptions& options) {
    if (tcps.empty()) return Unexpected("there are no measured TCP positions");
    return GeometryFitter(machine, tcps, options).run();
}

}  // namespace gsim::calibrate
