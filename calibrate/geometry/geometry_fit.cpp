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
constexpr double kMiddleOf3 = 1.5382;
constexpr double kRareOf3 = 4.60;
/// Error of a TCP, 3 or 6 numbers in units of noise, beyond which it counts less than its square. With
/// ordinary noise hardly any error is beyond it.
constexpr double kHuberFrom = 4;
constexpr int kNoiseRounds = 4;

/// Errors at the current point of Ceres. Values are in units of deviations' usual sizes, so that steps are
/// comparable.
class Standing : public ceres::EvaluationCallback {
  public:
    Standing(const WeightedErrors& errors, std::span<const Deviation> deviations)
        : errors_(errors), values(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(deviations.size()))) {
        units_.resize(values.size());
        for (std::size_t i = 0; i < deviations.size(); ++i)
            units_[static_cast<Eigen::Index>(i)] = usual_size(deviations[i]);
    }

    void PrepareForEvaluation(bool with_slopes, bool /*is_new*/) override {
        if (now.size() == 0 || values != now_at_) {
            now = errors_.at(in_units());
            now_at_ = values;
        }
        if (!with_slopes || (slopes.size() != 0 && values == slopes_at_)) return;
        slopes = errors_.slopes(in_units()) * units_.asDiagonal();
        slopes_at_ = values;
    }

    /// Sets derivatives at values of 0, which have been computed before.
    void start_with(const Eigen::MatrixXd& at_zero) {
        slopes = at_zero * units_.asDiagonal();
        slopes_at_ = Eigen::VectorXd::Zero(values.size());
    }
    Eigen::VectorXd in_units() const { return values.cwiseProduct(units_); }
    const Eigen::VectorXd& units() const { return units_; }
    const WeightedErrors& errors() const { return errors_; }

  private:
    const WeightedErrors& errors_;
    Eigen::VectorXd units_;
    Eigen::VectorXd now_at_;
    Eigen::VectorXd slopes_at_;

  public:
    Eigen::VectorXd values;
    Eigen::VectorXd now;
    Eigen::MatrixXd slopes;
};

/// Error of one TCP.
class OneTip : public ceres::CostFunction {
  public:
    OneTip(const Standing& standing, Eigen::Index tip)
        : standing_(standing), first_(standing.errors().first(tip)), size_(standing.errors().size(tip)) {
        set_num_residuals(static_cast<int>(size_));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(standing.values.size()));
    }

    bool Evaluate(double const* const* /*at*/, double* errors, double** slopes) const override {
        Eigen::Map<Eigen::VectorXd>(errors, size_) = standing_.now.segment(first_, size_);
        if (slopes == nullptr || slopes[0] == nullptr) return true;
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        Eigen::Map<Rows>(slopes[0], size_, standing_.values.size()) =
            standing_.slopes.middleRows(first_, size_);
        return true;
    }

  private:
    const Standing& standing_;
    Eigen::Index first_;
    Eigen::Index size_;
};

std::string solve(Standing& standing) {
    ceres::Problem::Options options;
    options.evaluation_callback = &standing;
    ceres::Problem problem(options);
    for (Eigen::Index i = 0; i < standing.errors().count(); ++i)
        problem.AddResidualBlock(new OneTip(standing, i), new ceres::HuberLoss(kHuberFrom),
                                 standing.values.data());
    ceres::Solver::Options how;
    how.linear_solver_type = ceres::DENSE_QR;
    how.max_num_iterations = 30;
    how.function_tolerance = 1e-8;
    how.parameter_tolerance = 1e-7;
    how.gradient_tolerance = 1e-6;
    how.initial_trust_region_radius = 1e12;  // measured machines lie close: the first step is Gauss's
    how.max_trust_region_radius = 1e16;
    how.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(how, &problem, &summary);
    standing.PrepareForEvaluation(true, true);
    return fmt::format("{} steps, {}", summary.iterations.size(), summary.message);
}

/// Returns the information matrix of the errors for the values, each TCP by its weight.
Eigen::MatrixXd information(const Standing& standing) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(standing.values.size(), standing.values.size());
    for (Eigen::Index i = 0; i < standing.errors().count(); ++i) {
        const Eigen::Index first = standing.errors().first(i), size = standing.errors().size(i);
        const double length = standing.now.segment(first, size).norm();
        const double weight = length > kHuberFrom ? kHuberFrom / length : 1;
        const auto rows = standing.slopes.middleRows(first, size);
        sum.noalias() += weight * rows.transpose() * rows;
    }
    return sum;
}

/// Returns the factor that scales the noise to these lengths; `freedom` is the share of all numbers that
/// remains after the fitted values. First uses the median, which is robust to outliers, then all but
/// outliers.
double noise_factor(std::vector<double> lengths, double freedom) {
    if (lengths.empty()) return 1;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    const double most = *middle * kRareOf3 / kMiddleOf3;
    double squares = 0, count = 0;
    for (const double length : lengths) {
        if (length > most) continue;
        squares += length * length;
        count += 3;
    }
    return std::sqrt(squares / (count * freedom));
}

double length_of(const Eigen::VectorXd& errors, Eigen::Index first) {
    return errors.segment<3>(first).norm();
}

/// Returns the work frame in that of the instrument that aligns TCPs with measured ones (Umeyama).
rrs::CartPos aligned(const machine::Machine& machine, std::span<const MeasuredTip> tips) {
    const TipFinder finder(DeviatedMachine({.machine = machine, .scales = {}}).nominal());
    Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(tips.size())), to = from;
    for (std::size_t i = 0; i < tips.size(); ++i) {
        from.col(static_cast<Eigen::Index>(i)) = finder.tip(tips[i].readings).translation();
        to.col(static_cast<Eigen::Index>(i)) = tips[i].tip.translation();
    }
    return rrs::CartPos(Eigen::umeyama(from, to, false));
}

double left_over_noise(const Standing& standing) {
    double squares = 0;
    for (Eigen::Index i = 0; i < standing.errors().count(); ++i) {
        const double length =
            standing.now.segment(standing.errors().first(i), standing.errors().size(i)).norm();
        squares += length * std::min(length, kHuberFrom);
    }
    return std::sqrt(squares / static_cast<double>(standing.errors().size() - standing.values.size()));
}

std::vector<bool> outliers_of(const Standing& standing) {
    std::vector<bool> found;
    for (Eigen::Index i = 0; i < standing.errors().count(); ++i) {
        const Eigen::Index first = standing.errors().first(i);
        bool out = length_of(standing.now, first) > kRareOf3;
        if (standing.errors().size(i) == 6) out = out || length_of(standing.now, first + 3) > kRareOf3;
        found.push_back(out);
    }
    return found;
}

/// Fit of one machine to its measured TCPs.
class Task {
  public:
    Task(const machine::Machine& machine, std::span<const MeasuredTip> tips, const GeometryOptions& options)
        : options_(options),
          tips_(tips),
          deviated_(
              {.machine = machine,
               .scales = {},
               .instrument = options.choice.own_frame ? aligned(machine, tips) : rrs::CartPos::Identity()}),
          all_(all_deviations(machine, options.choice)) {
        noise_.mm = options.noise_mm.value_or(noise_.mm);
        noise_.deg = options.noise_deg.value_or(noise_.deg);
    }

    tl::expected<GeometryFit, std::string> run() {
        if (!identified()) {
            return tl::unexpected<std::string>(
                "these tips tell nothing of the machine's geometry: there are too few, or all is held");
        }
        for (const MeasuredTip& tip : tips_) {
            fit_.noise_is_found = fit_.noise_is_found || !(options_.noise_mm || tip.sigma_mm);
            turns_are_measured_ = turns_are_measured_ || tip.has_orientation;
            finds_turns_ = finds_turns_ || (tip.has_orientation && !(options_.noise_deg || tip.sigma_deg));
        }
        for (int round = 0; round < (fit_.noise_is_found || finds_turns_ ? kNoiseRounds : 1); ++round) {
            const WeightedErrors errors(deviated_, chosen_, tips_, noise_);
            Standing standing(errors, chosen_);
            if (round == 0) standing.start_with(first_slopes_);
            fit_.told = solve(standing);
            take(standing);
            look_at_noise(standing);
        }
        return fit_;
    }

  private:
    bool identified() {
        const WeightedErrors errors(deviated_, all_, tips_, noise_);
        const Eigen::MatrixXd slopes =
            errors.slopes(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all_.size())));
        Identified found = identify(slopes, all_);
        first_slopes_ = slopes(Eigen::all, found.chosen);
        for (const std::size_t i : found.chosen) chosen_.push_back(all_[i]);
        fit_.held = std::move(found.held);
        fit_.singular_values = std::move(found.singular_values);
        fit_.before = tip_errors(deviated_.nominal(), tips_);
        return !chosen_.empty() && errors.size() > static_cast<Eigen::Index>(chosen_.size());
    }

    void take(const Standing& standing) {
        const Eigen::MatrixXd inverse = base::inverse_of_positive(information(standing));
        fit_.covariance = standing.units().asDiagonal() * inverse * standing.units().asDiagonal();
        const Eigen::VectorXd values = standing.in_units();
        fit_.geometry = deviated_.at(chosen_, values);
        if (!turns_are_measured_) fit_.geometry = deviated_.with_nominal_turn(std::move(fit_.geometry));
        fit_.after = tip_errors(fit_.geometry, tips_);
        fit_.outliers = outliers_of(standing);
        fit_.noise = noise_;
        fit_.left_over_noise = left_over_noise(standing);
        fit_.found.clear();
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            fit_.found.push_back({chosen_[i], values[k], std::sqrt(fit_.covariance(k, k))});
        }
    }

    /// Takes the remaining errors as the noise of the next round, if it is not given.
    void look_at_noise(const Standing& standing) {
        std::vector<double> places, turns;
        for (std::size_t i = 0; i < tips_.size(); ++i) {
            const Eigen::Index first = standing.errors().first(static_cast<Eigen::Index>(i));
            if (!tips_[i].sigma_mm) places.push_back(length_of(standing.now, first));
            if (tips_[i].has_orientation && !tips_[i].sigma_deg)
                turns.push_back(length_of(standing.now, first + 3));
        }
        const double freedom =
            1 - static_cast<double>(standing.values.size()) / static_cast<double>(standing.errors().size());
        constexpr double kLeast_mm = 1e-6, kLeast_deg = 1e-7;
        if (fit_.noise_is_found)
            noise_.mm = std::max(noise_.mm * noise_factor(std::move(places), freedom), kLeast_mm);
        if (finds_turns_)
            noise_.deg = std::max(noise_.deg * noise_factor(std::move(turns), freedom), kLeast_deg);
    }

    const GeometryOptions& options_;
    std::span<const MeasuredTip> tips_;
    DeviatedMachine deviated_;
    std::vector<Deviation> all_;
    std::vector<Deviation> chosen_;
    Eigen::MatrixXd first_slopes_;  ///< For the chosen ones, at 0.
    Noise noise_;
    bool finds_turns_ = false;
    bool turns_are_measured_ = false;
    GeometryFit fit_;
};

}  // namespace

tl::expected<GeometryFit, std::string> fit_geometry(const machine::Machine& machine,
                                                    std::span<const MeasuredTip> tips,
                                                    const GeometryOptions& options) {
    if (tips.empty()) return tl::unexpected<std::string>("there are no measured tips");
    return Task(machine, tips, options).run();
}

}  // namespace gsim::calibrate
