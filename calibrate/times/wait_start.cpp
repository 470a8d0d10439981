#include "calibrate/times/wait_start.h"

#include <algorithm>
#include <cmath>

namespace gsim::calibrate {

namespace {

constexpr int kWeightings = 20;
constexpr int kSweeps = 50;
constexpr double kAllAlike = 0.001;  // of a time: what is off by less counts as its square

/// Solves least squares by one parameter after the other, none below 0.
void sweep(const Eigen::MatrixXd& counts, const Eigen::VectorXd& weights, Eigen::VectorXd& left_s,
           Eigen::VectorXd& waits_s) {
    for (Eigen::Index k = 0; k < waits_s.size(); ++k) {
        const Eigen::VectorXd weighted = counts.col(k).cwiseProduct(weights);
        const double curvature = weighted.dot(counts.col(k));
        if (!(curvature > 0)) continue;
        const double better_s = std::max(waits_s[k] + weighted.dot(left_s) / curvature, 0.0);
        left_s -= (better_s - waits_s[k]) * counts.col(k);
        waits_s[k] = better_s;
    }
}

}  // namespace

Eigen::VectorXd waits_from(const Eigen::MatrixXd& counts, const Eigen::VectorXd& missing_s,
                           const Eigen::VectorXd& times_s) {
    Eigen::VectorXd waits_s = Eigen::VectorXd::Zero(counts.cols());
    Eigen::VectorXd left_s = missing_s;
    Eigen::VectorXd weights = times_s.cwiseAbs2().cwiseInverse();
    for (int weighting = 0; weighting < kWeightings; ++weighting) {
        for (int i = 0; i < kSweeps; ++i) sweep(counts, weights, left_s, waits_s);
        for (Eigen::Index i = 0; i < weights.size(); ++i)
            weights[i] = 1 / (times_s[i] * std::max(std::abs(left_s[i]), kAllAlike * times_s[i]));
    }
    return waits_s;
}

}  // namespace gsim::calibrate
