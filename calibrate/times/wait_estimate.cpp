#include "calibrate/times/wait_estimate.h"

#include <algorithm>
#include <cmath>

namespace gsim::calibrate {

namespace {

constexpr int kReweightings = 20;
constexpr int kSweeps = 50;
constexpr double kMinResidualShare = 0.001;  // of a time: what is off by less counts as its square

/// Solves least squares by each parameter in turn, none below 0.
void solve_by_coordinates(const Eigen::MatrixXd& counts, const Eigen::VectorXd& weights,
                          Eigen::VectorXd& residuals_s, Eigen::VectorXd& waits_s) {
    for (Eigen::Index k = 0; k < waits_s.size(); ++k) {
        const Eigen::VectorXd weighted = counts.col(k).cwiseProduct(weights);
        const double curvature = weighted.dot(counts.col(k));
        if (!(curvature > 0)) continue;
        const double improved_wait_s = std::max(waits_s[k] + weighted.dot(residuals_s) / curvature, 0.0);
        residuals_s -= (improved_wait_s - waits_s[k]) * counts.col(k);
        waits_s[k] = improved_wait_s;
    }
}

}  // namespace

Eigen::VectorXd estimate_waits(const Eigen::MatrixXd& counts, const Eigen::VectorXd& missing_s,
                               const Eigen::VectorXd& times_s) {
    Eigen::VectorXd waits_s = Eigen::VectorXd::Zero(counts.cols());
    Eigen::VectorXd residuals_s = missing_s;
    Eigen::VectorXd weights = times_s.cwiseAbs2().cwiseInverse();
    for (int weighting = 0; weighting < kReweightings; ++weighting) {
        for (int i = 0; i < kSweeps; ++i) solve_by_coordinates(counts, weights, residuals_s, waits_s);
        for (Eigen::Index i = 0; i < weights.size(); ++i)
            weights[i] =
                1 / (times_s[i] * std::max(std::abs(residuals_s[i]), kMinResidualShare * times_s[i]));
    }
    return waits_s;
}

}  // namespace gsim::calibrate
