#include "calibrate/times/fit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <ceres/ceres.h>
#include <fmt/format.h>

#include "base/dense/symmetric.h"
#include "calibrate/times/wait_estimate.h"

namespace gsim::calibrate {

namespace {

constexpr double kResidualUnit = 0.01;  // residuals are in percent
constexpr double kRobustThreshold = 2;  // of these
constexpr double kStep = 0.01;          // of a logarithm, for derivatives
constexpr double kPriorWeight =
    0.02;  // percent for a factor e off what the machine had: what runs say counts more
constexpr double kMaxSpread = 0.5;    // of a logarithm
constexpr double kUnknownSpread = 1;  // the same for a parameter without information from runs: a factor e
constexpr double kMinNoise = 2e-4;    // of times: no clock and no model is better

/// Logarithms of all times for logarithms of parameters, with their derivatives.
class TimeModel : public ceres::EvaluationCallback {
  public:
    TimeModel(const machine::Machine& machine, const std::vector<Parameter>& parameters,
              const std::vector<TimedInterval>& data, const Predictor& predictor)
        : machine_(machine),
          parameters_(parameters),
          data_(data),
          predictor_(predictor),
          logs(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(parameters.size()))) {}

    /// Plans at `logs` for the first time; the error names the program that does not reach its end.
    Result<void> begin() {
        const auto times_s = predictor_.times_s(data_, machine_at(logs));
        if (!times_s) return tl::unexpected(times_s.error());
        set_times(logarithms(*times_s));
        return {};
    }

    void PrepareForEvaluation(bool with_slopes, bool /*is_new*/) override {
        if (logs != evaluated_at_) set_times(at(logs));
        if (with_slopes && slopes.size() == 0) differentiate();
    }

    machine::Machine machine_at(const Eigen::VectorXd& at) const {
        std::vector<double> values;
        for (const double log : at) values.push_back(std::exp(log));
        return with_values(machine_, parameters_, values);
    }

    /// Returns an extremely long time for runs that do not reach their ends with these values.
    Eigen::VectorXd at(const Eigen::VectorXd& point) const {
        constexpr double kUnreachable_s = 1e9;
        const auto times_s = predictor_.times_s(data_, machine_at(point));
        if (times_s) return logarithms(*times_s);
        return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data_.size()), std::log(kUnreachable_s));
    }

  private:
    static Eigen::VectorXd logarithms(const std::vector<double>& times_s) {
        constexpr double kMin_s = 1e-6;
        Eigen::VectorXd found(static_cast<Eigen::Index>(times_s.size()));
        for (Eigen::Index i = 0; i < found.size(); ++i)
            found[i] = std::log(std::max(times_s[static_cast<std::size_t>(i)], kMin_s));
        return found;
    }

    void set_times(Eigen::VectorXd times) {
        log_times = std::move(times);
        slopes.resize(0, 0);
        evaluated_at_ = logs;
    }

    void differentiate() {
        slopes.resize(log_times.size(), logs.size());
        for (Eigen::Index k = 0; k < logs.size(); ++k) {
            const Parameter& parameter = parameters_[static_cast<std::size_t>(k)];
            Eigen::VectorXd stepped_logs = logs;
            const double step = logs[k] + kStep > std::log(parameter.max) ? -kStep : kStep;
            stepped_logs[k] += step;
            slopes.col(k) = (at(stepped_logs) - log_times) / step;
        }
    }

    const machine::Machine& machine_;
    const std::vector<Parameter>& parameters_;
    const std::vector<TimedInterval>& data_;
    const Predictor& predictor_;
    Eigen::VectorXd evaluated_at_;  // to which log_times and slopes belong

  public:
    Eigen::VectorXd logs;  ///< Current point of Ceres.
    Eigen::VectorXd log_times;
    Eigen::MatrixXd slopes;
};

/// Returns the unit of one percent of a time: larger for a time that is short relative to its clock error.
double residual_unit(const TimedInterval& datum) {
    return std::hypot(kResidualUnit, datum.clock_error_s / datum.time_s);
}

/// Error of one time, in percent.
class TimeResidual : public ceres::CostFunction {
  public:
    TimeResidual(const TimeModel& times, Eigen::Index index, const TimedInterval& datum)
        : times_(times), index_(index), log_recorded_(std::log(datum.time_s)), unit_(residual_unit(datum)) {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(times.logs.size()));
    }

    bool Evaluate(double const* const* /*at*/, double* residuals, double** slopes) const override {
        residuals[0] = (times_.log_times[index_] - log_recorded_) / unit_;
        if (slopes == nullptr || slopes[0] == nullptr) return true;
        for (Eigen::Index k = 0; k < times_.logs.size(); ++k) slopes[0][k] = times_.slopes(index_, k) / unit_;
        return true;
    }

  private:
    const TimeModel& times_;
    Eigen::Index index_;
    double log_recorded_;
    double unit_;
};

/// Distance of parameters from the machine's original values.
class Prior : public ceres::CostFunction {
  public:
    explicit Prior(Eigen::VectorXd before) : initial_(std::move(before)) {
        set_num_residuals(static_cast<int>(initial_.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(initial_.size()));
    }

    bool Evaluate(double const* const* at, double* residuals, double** slopes) const override {
        const Eigen::Index count = initial_.size();
        for (Eigen::Index i = 0; i < count; ++i) {
            residuals[i] = kPriorWeight * (at[0][i] - initial_[i]);
            for (Eigen::Index k = 0; slopes != nullptr && slopes[0] != nullptr && k < count; ++k)
                slopes[0][i * count + k] = i == k ? kPriorWeight : 0;
        }
        return true;
    }

  private:
    Eigen::VectorXd initial_;
};

/// Solves, and returns the remaining cost.
double solve(TimeModel& times, const std::vector<TimedInterval>& data,
             const std::vector<Parameter>& parameters, int max_steps,
             const std::function<void(const std::string&)>& on_message) {
    ceres::Problem::Options options;
    options.evaluation_callback = &times;
    ceres::Problem problem(options);
    for (std::size_t i = 0; i < data.size(); ++i) {
        problem.AddResidualBlock(new TimeResidual(times, static_cast<Eigen::Index>(i), data[i]),
                                 new ceres::HuberLoss(kRobustThreshold), times.logs.data());
    }
    problem.AddResidualBlock(new Prior(times.logs), nullptr, times.logs.data());
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        problem.SetParameterLowerBound(times.logs.data(), static_cast<int>(k), std::log(parameters[k].min));
        problem.SetParameterUpperBound(times.logs.data(), static_cast<int>(k), std::log(parameters[k].max));
    }
    ceres::Solver::Options solver_options;
    solver_options.linear_solver_type = ceres::DENSE_QR;
    solver_options.max_num_iterations = max_steps;
    solver_options.function_tolerance = 1e-3;
    solver_options.parameter_tolerance = 1e-4;
    solver_options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver_options, &problem, &summary);
    if (on_message) on_message(fmt::format("{} steps, {}", summary.iterations.size(), summary.message));
    return summary.final_cost;
}

/// End point of a fit.
struct FitEnd {
    Eigen::VectorXd logs;
    double cost = 0;
};

/// Returns true if times grow in proportion to the parameter.
bool is_wait(const Parameter& parameter) {
    return parameter.parameter_id.of == "times" || parameter.parameter_id.key == "standstill_s" ||
           parameter.parameter_id.key == "settle_s";
}

/// Estimates start values of words' times and the other waits from the missing times, with all other
/// parameters as they are, if words take time.
void initialize_waits(TimeModel& times, const std::vector<TimedInterval>& data,
                      const std::vector<Parameter>& parameters) {
    const bool any = std::any_of(parameters.begin(), parameters.end(),
                                 [](const Parameter& each) { return each.parameter_id.of == "times"; });
    std::vector<Eigen::Index> waits;
    for (std::size_t k = 0; any && k < parameters.size(); ++k) {
        if (is_wait(parameters[k])) waits.push_back(static_cast<Eigen::Index>(k));
    }
    if (waits.empty()) return;
    times.PrepareForEvaluation(true, true);
    const Eigen::VectorXd planned_s = times.log_times.array().exp();
    Eigen::VectorXd recorded_s(planned_s.size());
    for (std::size_t i = 0; i < data.size(); ++i) recorded_s[static_cast<Eigen::Index>(i)] = data[i].time_s;
    Eigen::MatrixXd counts(planned_s.size(), static_cast<Eigen::Index>(waits.size()));
    Eigen::VectorXd missing_s = recorded_s - planned_s;
    for (Eigen::Index w = 0; w < counts.cols(); ++w) {
        const Eigen::Index k = waits[static_cast<std::size_t>(w)];
        const Eigen::VectorXd wait_total_s = times.slopes.col(k).cwiseProduct(planned_s);
        counts.col(w) = wait_total_s / std::exp(times.logs[k]);
        missing_s += wait_total_s;
    }
    const Eigen::VectorXd waits_s = estimate_waits(counts, missing_s, recorded_s);
    for (Eigen::Index w = 0; w < counts.cols(); ++w) {
        const Eigen::Index k = waits[static_cast<std::size_t>(w)];
        const Parameter& parameter = parameters[static_cast<std::size_t>(k)];
        times.logs[k] = std::log(std::clamp(waits_s[w], parameter.min, parameter.max));
    }
}

/// A high share for speed in curves leaves little for their ramps, and vice versa. Both may explain a curve's
/// time, and a fit finds the nearer solution, so it begins at several. Returns the best end first.
std::vector<FitEnd> solve_from_all_starts(TimeModel& times, const std::vector<TimedInterval>& data,
                                          const std::vector<Parameter>& parameters, const FitOptions& options,
                                          const std::function<void(const std::string&)>& on_message) {
    std::vector<FitEnd> ends;
    const auto start = [&](const Eigen::VectorXd& at) {
        times.logs = at;
        const double cost = solve(times, data, parameters, options.max_steps, on_message);
        ends.push_back({times.logs, cost});
    };
    start(Eigen::VectorXd(times.logs));
    for (std::size_t k = 0; options.multi_start && k < parameters.size(); ++k) {
        if (parameters[k].parameter_id.key != "centripetal_share" || parameters[k].max >= 1) continue;
        for (const double share : {0.3, 0.6, 0.9}) {
            Eigen::VectorXd other = ends.front().logs;
            other[static_cast<Eigen::Index>(k)] = std::log(share);
            start(other);
        }
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const FitEnd& a, const FitEnd& b) { return a.cost < b.cost; });
    times.logs = ends.front().logs;
    return ends;
}

/// Returns the standard deviation of the residuals with so many free parameters.
double deviation(double squares, std::size_t count, std::size_t parameter_count) {
    return std::sqrt(squares /
                     std::max<double>(static_cast<double>(count) - static_cast<double>(parameter_count), 1));
}

/// Returns the additional spread from other ends that explain the times as well (within two standard
/// deviations).
Eigen::MatrixXd covariance_between_ends(const std::vector<FitEnd>& ends, std::size_t times) {
    const Eigen::VectorXd& best = ends.front().logs;
    const double degrees_of_freedom =
        std::max(static_cast<double>(times) - static_cast<double>(best.size()), 1.0);
    const double max_equivalent_cost = ends.front().cost * (1 + 4 / degrees_of_freedom);
    Eigen::VectorXd max_change = Eigen::VectorXd::Zero(best.size());
    for (const FitEnd& end : ends) {
        if (end.cost <= max_equivalent_cost && (end.logs - best).norm() > max_change.norm())
            max_change = end.logs - best;
    }
    return max_change * max_change.transpose();
}

/// Judges which parameters the runs determine, and how well. The residuals are the noise of the times, and
/// without runs only the magnitude of a parameter is known.
void estimate_uncertainty(const TimeModel& times, const std::vector<TimedInterval>& data,
                          const std::vector<FitEnd>& ends, Fit& fit) {
    const Eigen::Index count = times.logs.size();
    Eigen::MatrixXd slopes = times.slopes;
    double squares = 0;
    for (std::size_t i = 0; i < data.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double weight = kResidualUnit / residual_unit(data[i]);
        const double log_error = weight * (times.log_times[row] - std::log(data[i].time_s));
        squares += log_error * log_error;
        slopes.row(row) *= weight;
    }
    const double noise =
        std::max(deviation(squares, data.size(), static_cast<std::size_t>(count)), kMinNoise);
    const Eigen::MatrixXd on_message = slopes.transpose() * slopes / (noise * noise);
    const Eigen::MatrixXd posterior_information =
        on_message + Eigen::MatrixXd::Identity(count, count) / (kUnknownSpread * kUnknownSpread);
    fit.covariance = base::positive_definite_inverse(posterior_information);
    fit.covariance += covariance_between_ends(ends, data.size());
    for (Eigen::Index k = 0; k < count; ++k) {
        FittedParameter& parameter = fit.parameters[static_cast<std::size_t>(k)];
        parameter.standard_deviation = std::sqrt(fit.covariance(k, k));
        parameter.identified = parameter.standard_deviation < kMaxSpread;
    }
}

/// Returns the residuals of the times of complete runs.
double residual_noise(const Fit& fit, std::span<const RecordedRun> runs) {
    double squares = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double log_error = std::log(fit.times_s[i] / runs[i].time_s);
        squares += log_error * log_error;
    }
    return deviation(squares, runs.size(), fit.parameters.size());
}

/// Returns open parameters; for words only those that programs contain.
std::vector<Parameter> select_parameters(const machine::Machine& machine, const FreeParameters& open,
                                         const std::vector<std::string>& words) {
    std::vector<Parameter> parameters = free_parameters(machine, open);
    std::erase_if(parameters, [&](const Parameter& each) {
        return each.parameter_id.of == "times" &&
               std::find(words.begin(), words.end(), each.parameter_id.key) == words.end();
    });
    return parameters;
}

}  // namespace

Result<Fit> fit_times(const machine::Machine& machine, std::span<const RecordedRun> runs,
                      const Predictor& predictor, const FitOptions& options,
                      const std::function<void(const std::string&)>& on_message) {
    const std::vector<TimedInterval> data = predictor.data();
    const std::vector<Parameter> parameters = select_parameters(machine, options.open, predictor.words());
    if (runs.empty() || parameters.empty())
        return Unexpected("there is nothing to fit: no runs, or no open parameter");
    TimeModel times(machine, parameters, data, predictor);
    for (std::size_t k = 0; k < parameters.size(); ++k)
        times.logs[static_cast<Eigen::Index>(k)] = std::log(parameters[k].first);
    if (const auto begun = times.begin(); !begun) return tl::unexpected(begun.error());
    initialize_waits(times, data, parameters);
    const std::vector<FitEnd> ends = solve_from_all_starts(times, data, parameters, options, on_message);
    times.PrepareForEvaluation(true, true);
    Fit fit;
    fit.machine = times.machine_at(times.logs);
    for (std::size_t k = 0; k < parameters.size(); ++k)
        fit.parameters.push_back(
            {parameters[k].parameter_id, std::exp(times.logs[static_cast<Eigen::Index>(k)])});
    fit.times_s.assign(runs.size(), 0);
    for (std::size_t i = 0; i < data.size(); ++i)  // of a run they add up to all of it
        fit.times_s[data[i].run] += std::exp(times.log_times[static_cast<Eigen::Index>(i)]);
    estimate_uncertainty(times, data, ends, fit);
    fit.noise = residual_noise(fit, runs);
    return fit;
}

}  // namespace gsim::calibrate
