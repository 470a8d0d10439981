#include "batch/search/evolution.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gsim::batch {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMinStep = 1e-5;  // of the box
constexpr double kMaxStep = 1;

std::size_t default_population(Index dimensions) {
    return 4 + static_cast<std::size_t>(3 * std::log(static_cast<double>(dimensions)));
}

double reflected(double value) {
    const double within = std::abs(std::remainder(value, 2.0));
    return std::min(within, 1.0);
}

/// Returns the weights of the better half of the trials (equation 49 of the tutorial, the positive ones).
VectorXd recombination_weights(std::size_t population) {
    const auto parents = static_cast<Index>(population / 2);
    VectorXd weights(parents);
    for (Index i = 0; i < parents; ++i)
        weights[i] =
            std::log((static_cast<double>(population) + 1) / 2) - std::log(static_cast<double>(i + 1));
    return weights / weights.sum();
}

/// Constants of table 1 of the tutorial (of 2023).
struct EvolutionConstants {
    EvolutionConstants(double n, double effective_mass)
        : mass(effective_mass),
          step_rate((mass + 2) / (n + mass + 5)),
          step_damping(1 + 2 * std::max(0.0, std::sqrt((mass - 1) / (n + 1)) - 1) + step_rate),
          path_rate((4 + mass / n) / (n + 4 + 2 * mass / n)),
          rank_one_rate(2 / ((n + 1.3) * (n + 1.3) + mass)),
          rank_mu_rate(
              std::min(1 - rank_one_rate, 2 * (0.25 + mass - 2 + 1 / mass) / ((n + 2) * (n + 2) + mass))),
          expected_norm(std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n))) {}

    double mass;  ///< Variance effective mass of the parents.
    double step_rate, step_damping, path_rate, rank_one_rate, rank_mu_rate;
    double expected_norm;  ///< For a normally distributed vector.
};

}  // namespace

Evolution::Evolution(const VectorXd& mean, double step, std::size_t population, Random random)
    : population_(population > 0 ? std::max<std::size_t>(population, 4) : default_population(mean.size())),
      random_(random),
      mean_(mean),
      step_(step),
      covariance_(MatrixXd::Identity(mean.size(), mean.size())),
      axes_(covariance_),
      axis_lengths_(VectorXd::Ones(mean.size())),
      path_(VectorXd::Zero(mean.size())),
      step_path_(path_) {}

std::vector<VectorXd> Evolution::sample_population() {
    samples_.clear();
    std::vector<VectorXd> trials;
    for (std::size_t i = 0; i < population_; ++i) {
        VectorXd normal_samples(mean_.size());
        for (double& each : normal_samples) each = normal_random(random_);
        samples_.emplace_back(axes_ * axis_lengths_.cwiseProduct(normal_samples));
        trials.emplace_back((mean_ + step_ * samples_.back()).unaryExpr(&reflected));
    }
    return trials;
}

void Evolution::update(std::span<const std::size_t> ranking) {
    const VectorXd weights = recombination_weights(population_);
    MatrixXd steps(mean_.size(), weights.size());
    for (Index i = 0; i < weights.size(); ++i) steps.col(i) = samples_[ranking[static_cast<std::size_t>(i)]];
    ++generation_;
    adapt(steps, weights);
    decompose();
}

void Evolution::adapt(const MatrixXd& steps, const VectorXd& weights) {
    const auto n = static_cast<double>(mean_.size());
    const EvolutionConstants c(n, 1 / weights.squaredNorm());
    const VectorXd mean_step = steps * weights;
    mean_ += step_ * mean_step;
    const VectorXd whitened = axes_ * (axes_.transpose() * mean_step).cwiseQuotient(axis_lengths_);
    step_path_ =
        (1 - c.step_rate) * step_path_ + std::sqrt(c.step_rate * (2 - c.step_rate) * c.mass) * whitened;
    const double expected = std::sqrt(1 - std::pow(1 - c.step_rate, 2 * static_cast<double>(generation_)));
    const bool is_path_short = step_path_.norm() / expected < (1.4 + 2 / (n + 1)) * c.expected_norm;
    path_ = (1 - c.path_rate) * path_;
    if (is_path_short) path_ += std::sqrt(c.path_rate * (2 - c.path_rate) * c.mass) * mean_step;
    const double lost = is_path_short ? 0 : c.rank_one_rate * c.path_rate * (2 - c.path_rate);
    covariance_ = (1 - c.rank_one_rate - c.rank_mu_rate + lost) * covariance_ +
                  c.rank_one_rate * path_ * path_.transpose() +
                  c.rank_mu_rate * steps * weights.asDiagonal() * steps.transpose();
    step_ *= std::exp(c.step_rate / c.step_damping * (step_path_.norm() / c.expected_norm - 1));
    step_ = std::min(step_, kMaxStep);
}

void Evolution::decompose() {
    const MatrixXd symmetric = (covariance_ + covariance_.transpose()) / 2;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(symmetric);
    axes_ = solver.eigenvectors();
    axis_lengths_ = solver.eigenvalues().cwiseMax(1e-20).cwiseSqrt();
}

bool Evolution::has_converged() const {
    return step_ * axis_lengths_.maxCoeff() < kMinStep;
}

}  // namespace gsim::batch
