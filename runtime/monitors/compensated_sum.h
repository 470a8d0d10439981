#pragma once

#include <cmath>

namespace gsim::simulation {

/// Sum with rounding errors that do not grow with the number of terms (Neumaier).
class CompensatedSum {
  public:
    void add(double term) {
        const double next = sum_ + term;
        compensation_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }
    double value() const { return sum_ + compensation_; }

  private:
    double sum_ = 0;
    double compensation_ = 0;
};

}  // namespace gsim::simulation
