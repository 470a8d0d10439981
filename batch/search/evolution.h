#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "batch/plan/random.h"

namespace gsim::batch {

/// Evolution strategy with an adapted covariance matrix (CMA-ES; Hansen, "The CMA Evolution Strategy: A
/// Tutorial", arXiv:1604.00772), for many trials at once. It uses only the order of the trials, not their
/// results: limits and errors are part of that order. Points are in a box, each coordinate from 0 to 1;
/// samples beyond are mirrored into it.
class Evolution {
  public:
    /// Begins at `mean` with steps of `step`. `population` is the number of trials at once; 0: as many as the
    /// dimensions need (4 + 3 ln n).
    Evolution(const Eigen::VectorXd& mean, double step, std::size_t population, Random random);

    std::size_t population() const { return population_; }
    /// Returns the next trials, each in the box.
    std::vector<Eigen::VectorXd> sample_population();
    /// Receives the ranking: the indices of all trials that sample_population() returned, the best one first.
    void update(std::span<const std::size_t> ranking);
    /// Returns true if the distribution has contracted so far that it yields no new results.
    bool has_converged() const;

  private:
    void adapt(const Eigen::MatrixXd& steps, const Eigen::VectorXd& weights);
    void decompose();

    std::size_t population_;
    Random random_;
    Eigen::VectorXd mean_;
    double step_;
    Eigen::MatrixXd covariance_, axes_;
    Eigen::VectorXd axis_lengths_;  ///< Lengths of the axes.
    Eigen::VectorXd path_, step_path_;
    std::vector<Eigen::VectorXd> samples_;  ///< Unmirrored, in units of the step.
    std::uint64_t generation_ = 0;
};

}  // namespace gsim::batch
