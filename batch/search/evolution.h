#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "batch/plan/lots.h"

namespace gsim::batch {

/// The evolution strategy with an adapted covariance matrix (CMA-ES; Hansen, "The CMA Evolution Strategy: A
/// Tutorial", arXiv:1604.00772), for many trials at once. It asks for the order of the trials alone, not for
/// what they came to: limits and faults go into that order. Points are in a box, each coordinate from 0 to 1;
/// what it draws beyond is mirrored into it.
class Evolution {
  public:
    /// Begins about `mean` with steps of `step`. `population` trials at once; 0: as many as the dimensions
    /// need (4 + 3 ln n).
    Evolution(const Eigen::VectorXd& mean, double step, std::size_t population, Random random);

    std::size_t population() const { return population_; }
    /// The next trials, each in the box.
    std::vector<Eigen::VectorXd> ask();
    /// How good they were: the places of all trials that ask() gave, the best one first.
    void tell(std::span<const std::size_t> best_first);
    /// Whether it has drawn itself together so far that nothing new comes of it.
    bool is_done() const;

  private:
    void adapt(const Eigen::MatrixXd& steps, const Eigen::VectorXd& weights);
    void decompose();

    std::size_t population_;
    Random random_;
    Eigen::VectorXd mean_;
    double step_;
    Eigen::MatrixXd covariance_, axes_;
    Eigen::VectorXd lengths_;  ///< Of the axes.
    Eigen::VectorXd path_, step_path_;
    std::vector<Eigen::VectorXd> drawn_;  ///< Unmirrored, in units of the step.
    std::uint64_t generation_ = 0;
};

}  // namespace gsim::batch
