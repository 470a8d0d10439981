#include "calibrate/servo/servo_fit.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <ceres/ceres.h>
#include <fmt/format.h>

#include "motion/dynamics/servo_loop.h"

namespace gsim::calibrate {

namespace {

using machine::Servo;

constexpr double kMinGain_1_s = 1, kMaxGain_1_s = 1e5;
constexpr double kMinError = 1e-7;        // mm or deg, root mean square
constexpr double kResolution = 2e-5;      // mm or deg, root mean square: limit of any encoder and any clock
constexpr double kMinCriterionGain = 10;  // of the criterion: strong evidence (Kass, Raftery, 1995)
constexpr int kMaxServoSteps = 60;

struct FitParameter {
    const char* name;
    double Servo::*value;
    double first, min, max;
    double step;  ///< For derivatives.
};
/// The gain is the first one, and always present.
const std::array kFitParameters{
    FitParameter{"position_gain_1_s", &Servo::position_gain_1_s, 30, kMinGain_1_s, kMaxGain_1_s, 1e-4},
    FitParameter{"velocity_lag_s", &Servo::velocity_lag_s, 0.002, 1e-5, 1, 1e-7},
    FitParameter{"velocity_feed_forward", &Servo::velocity_feed_forward, 0.5, 0, 1, 1e-6},
    FitParameter{"command_delay_s", &Servo::command_delay_s, 0.001, 0, 1, 1e-7},
    FitParameter{"acceleration_feed_forward", &Servo::acceleration_feed_forward, 0.5, 0, 1, 1e-6}};

/// Set points at an instant, linear between samples.
class SetPoints {
  public:
    explicit SetPoints(const AxisRecord& record) : record_(record) {}

    /// Instants must be requested in ascending order.
    double at(double t_s) {
        const auto& t = record_.t_s;
        if (t_s <= t.front()) return record_.set_points.front();
        while (next_ + 1 < t.size() && t[next_] < t_s) ++next_;
        const double share = std::min((t_s - t[next_ - 1]) / (t[next_] - t[next_ - 1]), 1.0);
        return record_.set_points[next_ - 1] +
               share * (record_.set_points[next_] - record_.set_points[next_ - 1]);
    }

  private:
    const AxisRecord& record_;
    std::size_t next_ = 1;
};

double rms(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

std::vector<double> following_errors(const AxisRecord& record) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < record.positions.size(); ++i)
        errors.push_back(record.set_points[i] - record.positions[i]);
    return errors;
}

/// Computes v = gain e, in the mean of squares.
double initial_gain_1_s(const AxisRecord& record) {
    double squares = 0, products = 0;
    for (std::size_t i = 1; i < record.t_s.size(); ++i) {
        const double speed =
            (record.set_points[i] - record.set_points[i - 1]) / (record.t_s[i] - record.t_s[i - 1]);
        squares += speed * speed;
        products += speed * (record.set_points[i] - record.positions[i]);
    }
    const double gain = squares / products;
    return gain > 0 ? std::clamp(gain, kMinGain_1_s, kMaxGain_1_s) : kFitParameters.front().first;
}

/// Model to fit: some of the keys.
struct Model {
    Servo servo;
    std::vector<std::size_t> open;  // indices of keys
};

struct SolvedModel {
    Model model;
    double squares = 0;  // of what is left
};

/// Positions minus recorded ones, by the open parameters.
class Residuals final : public ceres::CostFunction {
  public:
    Residuals(const AxisRecord& record, const Model& model) : record_(record), model_(model) {
        set_num_residuals(static_cast<int>(record.t_s.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(model.open.size()));
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        const auto count = static_cast<Eigen::Index>(record_.t_s.size());
        const auto open = static_cast<Eigen::Index>(model_.open.size());
        const Eigen::VectorXd at = residuals_at(parameters[0], -1);
        Eigen::Map<Eigen::VectorXd>(residuals, count) = at;
        if (jacobians == nullptr || jacobians[0] == nullptr) return true;
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> slopes(
            jacobians[0], count, open);
        for (Eigen::Index k = 0; k < open; ++k) {
            const FitParameter& key = kFitParameters[model_.open[static_cast<std::size_t>(k)]];
            const double value = parameters[0][k];
            const double step =
                (value + difference_step(key, value) > key.max ? -1 : 1) * difference_step(key, value);
            slopes.col(k) = (residuals_at(parameters[0], k, step) - at) / step;
        }
        return true;
    }

  private:
    static double difference_step(const FitParameter& key, double value) {
        return key.step * std::max(1.0, std::abs(value));
    }

    Eigen::VectorXd residuals_at(const double* values, Eigen::Index shifted, double step = 0) const {
        Servo servo = model_.servo;
        for (std::size_t k = 0; k < model_.open.size(); ++k) {
            const bool is_shifted = static_cast<Eigen::Index>(k) == shifted;
            servo.*kFitParameters[model_.open[k]].value = values[k] + (is_shifted ? step : 0);
        }
        const std::vector<double> positions = simulate_following(servo, record_);
        Eigen::VectorXd residuals_at(static_cast<Eigen::Index>(positions.size()));
        for (std::size_t i = 0; i < positions.size(); ++i)
            residuals_at[static_cast<Eigen::Index>(i)] = positions[i] - record_.positions[i];
        return residuals_at;
    }

    const AxisRecord& record_;
    const Model& model_;
};

ceres::Problem::Options non_owning_options() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
}

SolvedModel solve(const AxisRecord& record, Model model) {
    std::vector<double> values;
    for (const std::size_t key : model.open) values.push_back(model.servo.*kFitParameters[key].value);
    Residuals residuals(record, model);
    ceres::Problem problem(non_owning_options());
    problem.AddResidualBlock(&residuals, nullptr, values.data());
    for (std::size_t k = 0; k < values.size(); ++k) {
        problem.SetParameterLowerBound(values.data(), static_cast<int>(k), kFitParameters[model.open[k]].min);
        problem.SetParameterUpperBound(values.data(), static_cast<int>(k), kFitParameters[model.open[k]].max);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = kMaxServoSteps;
    options.function_tolerance = 1e-10;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    for (std::size_t k = 0; k < values.size(); ++k)
        model.servo.*kFitParameters[model.open[k]].value = values[k];
    return {std::move(model), 2 * summary.final_cost};
}

/// Returns Schwarz's criterion for a model with equal errors in all samples.
double criterion(const SolvedModel& solved, double samples) {
    return samples * std::log(std::max(solved.squares / samples, kResolution * kResolution)) +
           static_cast<double>(solved.model.open.size()) * std::log(samples);
}

/// Returns the best model with one more parameter; empty if no parameter is worth it.
std::optional<SolvedModel> add_parameter(const SolvedModel& solved, const AxisRecord& record) {
    const auto samples = static_cast<double>(record.t_s.size());
    std::optional<SolvedModel> best;
    for (std::size_t key = 1; key < kFitParameters.size(); ++key) {
        const auto& open = solved.model.open;
        if (std::find(open.begin(), open.end(), key) != open.end()) continue;
        Model model = solved.model;
        model.open.push_back(key);
        model.servo.*kFitParameters[key].value = kFitParameters[key].first;
        SolvedModel found = solve(record, std::move(model));
        if (!best || found.squares < best->squares) best = std::move(found);
    }
    if (!best || criterion(*best, samples) > criterion(solved, samples) - kMinCriterionGain)
        return std::nullopt;
    return best;
}

/// Fits all parameters, starting with a gain and a feed-forward that together give the recorded error.
SolvedModel fit_full_model(const AxisRecord& record, double share) {
    Model model{{.position_gain_1_s = std::max((1 - share) * initial_gain_1_s(record), kMinGain_1_s),
                 .velocity_feed_forward = share},
                {}};
    for (std::size_t key = 0; key < kFitParameters.size(); ++key) {
        model.open.push_back(key);
        double& value = model.servo.*kFitParameters[key].value;
        if (value == 0) value = kFitParameters[key].first;
    }
    return solve(record, std::move(model));
}

/// Parameters can replace each other to a large extent, so that single steps may miss the optimum. Fits of
/// all parameters are therefore tried, too.
SolvedModel fit_best_model(const AxisRecord& record) {
    const auto samples = static_cast<double>(record.t_s.size());
    SolvedModel best = solve(record, {{.position_gain_1_s = initial_gain_1_s(record)}, {0}});
    while (auto better = add_parameter(best, record)) best = *std::move(better);
    for (const double share : {0.5, 0.9}) {
        SolvedModel solved = fit_full_model(record, share);
        if (criterion(solved, samples) < criterion(best, samples) - kMinCriterionGain)
            best = std::move(solved);
    }
    return best;
}

std::vector<FittedServoParameter> fitted_parameters(const SolvedModel& solved, const AxisRecord& record) {
    const Model& model = solved.model;
    const auto open = static_cast<Eigen::Index>(model.open.size());
    const auto samples = static_cast<Eigen::Index>(record.t_s.size());
    std::vector<double> values;
    for (const std::size_t key : model.open) values.push_back(model.servo.*kFitParameters[key].value);
    Eigen::VectorXd residuals(samples);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> slopes(samples, open);
    const double* parameters = values.data();
    double* jacobian = slopes.data();
    Residuals(record, model).Evaluate(&parameters, residuals.data(), &jacobian);
    const double variance = solved.squares / static_cast<double>(samples - open);
    const Eigen::MatrixXd covariance = variance * (slopes.transpose() * slopes).fullPivLu().inverse();
    std::vector<FittedServoParameter> fitted;
    for (std::size_t k = 0; k < model.open.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        fitted.push_back(
            {kFitParameters[model.open[k]].name, values[k], std::sqrt(std::max(covariance(at, at), 0.0))});
    }
    return fitted;
}

}  // namespace

std::vector<double> simulate_following(const Servo& servo, const AxisRecord& record) {
    const dynamics::ServoLoop loop{servo.position_gain_1_s, servo.velocity_feed_forward,
                                   servo.acceleration_feed_forward, servo.velocity_lag_s, 0};
    SetPoints set_points(record);
    double previous_set_point = set_points.at(record.t_s.front() - servo.command_delay_s);
    dynamics::ServoError error{previous_set_point - record.positions.front(), 0};
    double previous_speed = 0;
    std::vector<double> positions{record.positions.front()};
    for (std::size_t i = 1; i < record.t_s.size(); ++i) {
        const double step_s = record.t_s[i] - record.t_s[i - 1];
        const double set_point = set_points.at(record.t_s[i] - servo.command_delay_s);
        const double speed = (set_point - previous_set_point) / step_s;
        error.rate += (1 - servo.acceleration_feed_forward) * (speed - previous_speed);
        error = dynamics::ServoStep(loop, {speed, 0, 0, 0}, error).at(step_s);
        positions.push_back(set_point - error.value);
        previous_set_point = set_point;
        previous_speed = speed;
    }
    return positions;
}

Result<ServoFit> fit_servo(const AxisRecord& record) {
    const auto [min, max] = std::minmax_element(record.set_points.begin(), record.set_points.end());
    if (!(*max - *min > kMinError)) return Unexpected("it does not move");
    const double error_rms = rms(following_errors(record));
    if (error_rms < kMinError) return Unexpected("it has no following error that can be fitted");
    const SolvedModel solved = fit_best_model(record);
    ServoFit fit{record.letter, solved.model.servo, fitted_parameters(solved, record), error_rms, 0};
    fit.residual_rms = std::sqrt(solved.squares / static_cast<double>(record.t_s.size()));
    return fit;
}

}  // namespace gsim::calibrate
