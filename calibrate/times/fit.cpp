#include "calibrate/times/fit.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <ceres/ceres.h>
#include <fmt/format.h>

namespace gsim::calibrate {

namespace {

constexpr double kUnit = 0.01;     // residuals are in percent
constexpr double kRobustFrom = 2;  // of these
constexpr double kStep = 0.01;     // of a logarithm, for derivatives
constexpr double kPrior = 0.02;  // percent for a factor e off what the machine had: what runs say counts more
constexpr double kLeastShare = 1e-3;    // of the greatest singular value: less is nothing
constexpr double kMostInNothing = 0.3;  // of a parameter's direction, in what runs say nothing of
constexpr double kMostSpread = 0.5;     // of a logarithm

/// Logarithms of all times for logarithms of parameters, and how they change with these.
class Times : public ceres::EvaluationCallback {
  public:
    Times(const machine::Machine& machine, const std::vector<Parameter>& parameters,
          const Predictor& predictor)
        : machine_(machine),
          parameters_(parameters),
          predictor_(predictor),
          logs(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(parameters.size()))) {}

    void PrepareForEvaluation(bool with_slopes, bool is_new) override {
        if (is_new || log_times.size() == 0) {
            log_times = at(logs);
            slopes.resize(0, 0);
        }
        if (with_slopes && slopes.size() == 0) differentiate();
    }

    machine::Machine machine_at(const Eigen::VectorXd& at) const {
        std::vector<double> values;
        for (const double log : at) values.push_back(std::exp(log));
        return with_values(machine_, parameters_, values);
    }

    /// A run that does not come to its end with these values takes a time that nobody would choose.
    Eigen::VectorXd at(const Eigen::VectorXd& point) const {
        constexpr double kNever_s = 1e9;
        const auto times = predictor_.times_s(machine_at(point));
        Eigen::VectorXd found(static_cast<Eigen::Index>(times.size()));
        for (Eigen::Index i = 0; i < found.size(); ++i)
            found[i] = std::log(times[static_cast<std::size_t>(i)].value_or(kNever_s));
        return found;
    }

  private:
    void differentiate() {
        slopes.resize(log_times.size(), logs.size());
        for (Eigen::Index k = 0; k < logs.size(); ++k) {
            const Parameter& parameter = parameters_[static_cast<std::size_t>(k)];
            Eigen::VectorXd beside = logs;
            const double step = logs[k] + kStep > std::log(parameter.most) ? -kStep : kStep;
            beside[k] += step;
            slopes.col(k) = (at(beside) - log_times) / step;
        }
    }

    const machine::Machine& machine_;
    const std::vector<Parameter>& parameters_;
    const Predictor& predictor_;

  public:
    Eigen::VectorXd logs;  ///< Where Ceres stands.
    Eigen::VectorXd log_times;
    Eigen::MatrixXd slopes;
};

/// How far one run is off, in percent.
class OneRun : public ceres::CostFunction {
  public:
    OneRun(const Times& times, Eigen::Index run, double recorded_s)
        : times_(times), run_(run), log_recorded_(std::log(recorded_s)) {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(times.logs.size()));
    }

    bool Evaluate(double const* const* /*at*/, double* residuals, double** slopes) const override {
        residuals[0] = (times_.log_times[run_] - log_recorded_) / kUnit;
        if (slopes == nullptr || slopes[0] == nullptr) return true;
        for (Eigen::Index k = 0; k < times_.logs.size(); ++k) slopes[0][k] = times_.slopes(run_, k) / kUnit;
        return true;
    }

  private:
    const Times& times_;
    Eigen::Index run_;
    double log_recorded_;
};

/// How far parameters are from what the machine had.
class Prior : public ceres::CostFunction {
  public:
    explicit Prior(Eigen::VectorXd before) : before_(std::move(before)) {
        set_num_residuals(static_cast<int>(before_.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(before_.size()));
    }

    bool Evaluate(double const* const* at, double* residuals, double** slopes) const override {
        const Eigen::Index count = before_.size();
        for (Eigen::Index i = 0; i < count; ++i) {
            residuals[i] = kPrior * (at[0][i] - before_[i]);
            for (Eigen::Index k = 0; slopes != nullptr && slopes[0] != nullptr && k < count; ++k)
                slopes[0][i * count + k] = i == k ? kPrior : 0;
        }
        return true;
    }

  private:
    Eigen::VectorXd before_;
};

void solve(Times& times, std::span<const RecordedRun> runs, const std::vector<Parameter>& parameters,
           const std::function<void(const std::string&)>& told) {
    ceres::Problem::Options options;
    options.evaluation_callback = &times;
    ceres::Problem problem(options);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        problem.AddResidualBlock(new OneRun(times, static_cast<Eigen::Index>(i), runs[i].time_s),
                                 new ceres::HuberLoss(kRobustFrom), times.logs.data());
    }
    problem.AddResidualBlock(new Prior(times.logs), nullptr, times.logs.data());
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        problem.SetParameterLowerBound(times.logs.data(), static_cast<int>(k), std::log(parameters[k].least));
        problem.SetParameterUpperBound(times.logs.data(), static_cast<int>(k), std::log(parameters[k].most));
    }
    ceres::Solver::Options how;
    how.linear_solver_type = ceres::DENSE_QR;
    how.max_num_iterations = 15;
    how.function_tolerance = 1e-3;
    how.parameter_tolerance = 1e-4;
    how.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(how, &problem, &summary);
    if (told) told(fmt::format("{} steps, {}", summary.iterations.size(), summary.message));
}

/// Which parameters the runs tell of, and how well.
void judge(const Times& times, std::span<const RecordedRun> runs, Fit& fit) {
    const Eigen::Index count = times.logs.size();
    double squares = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double off = times.log_times[static_cast<Eigen::Index>(i)] - std::log(runs[i].time_s);
        squares += off * off;
    }
    const double freedom = std::max<double>(static_cast<double>(runs.size()) - static_cast<double>(count), 1);
    fit.noise = std::sqrt(squares / freedom);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(times.slopes, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const double least = kLeastShare * svd.singularValues()[0];
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
    Eigen::MatrixXd told = Eigen::MatrixXd::Zero(count, count);  // the projection onto what runs tell of
    for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k) {
        const double size = svd.singularValues()[k];
        if (!(size > least)) continue;
        const Eigen::VectorXd direction = svd.matrixV().col(k);
        told += direction * direction.transpose();
        covariance += direction * direction.transpose() * (fit.noise * fit.noise / (size * size));
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        FittedParameter& parameter = fit.parameters[static_cast<std::size_t>(k)];
        parameter.spread = std::sqrt(covariance(k, k));
        parameter.identified = 1 - told(k, k) < kMostInNothing && parameter.spread < kMostSpread;
        if (parameter.identified) continue;
        covariance.row(k).setZero();
        covariance.col(k).setZero();
    }
    fit.covariance = std::move(covariance);
}

}  // namespace

tl::expected<Fit, std::string> fit_times(const machine::Machine& machine, std::span<const RecordedRun> runs,
                                         const Predictor& predictor, bool each_axis,
                                         const std::function<void(const std::string&)>& told) {
    const auto first = predictor.times_s(machine);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!first[i]) return tl::unexpected(fmt::format("{}: {}", runs[i].program, first[i].error()));
    }
    const std::vector<Parameter> parameters = open_parameters(machine, each_axis);
    if (runs.empty() || parameters.empty())
        return tl::unexpected<std::string>("there is nothing to fit: no runs, or no figure that is open");
    Times times(machine, parameters, predictor);
    for (std::size_t k = 0; k < parameters.size(); ++k)
        times.logs[static_cast<Eigen::Index>(k)] = std::log(parameters[k].value(machine));
    solve(times, runs, parameters, told);
    times.PrepareForEvaluation(false, true);
    times.PrepareForEvaluation(true, false);
    Fit fit;
    fit.machine = times.machine_at(times.logs);
    for (std::size_t k = 0; k < parameters.size(); ++k)
        fit.parameters.push_back({parameters[k].name, std::exp(times.logs[static_cast<Eigen::Index>(k)])});
    for (const double log : times.log_times) fit.times_s.push_back(std::exp(log));
    judge(times, runs, fit);
    return fit;
}

}  // namespace gsim::calibrate
