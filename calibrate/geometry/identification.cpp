#include "calibrate/geometry/identification.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/dense/symmetric.h"

namespace gsim::calibrate {

namespace {

/// Limit below which a direction is not determined to better than its usual size.
constexpr double kMinSingularValue = 1;
/// Max share of a deviation's effect not explained by others if it only repeats them.
constexpr double kMaxRedundantShare = 1e-3;
constexpr double kMinShownShare = 0.05;

Eigen::MatrixXd submatrix(const Eigen::MatrixXd& square, const std::vector<Eigen::Index>& at) {
    return square(at, at);
}

/// Returns true if each direction of the deviations with these squares of slopes is determined to better than
/// its usual size.
bool is_determined(Eigen::MatrixXd square) {
    square.diagonal().array() -= kMinSingularValue * kMinSingularValue;
    return base::is_positive_definite(square);
}

/// Returns which of the chosen deviations have the effect of deviation `k`, and how much of each.
std::string fixed_reason(const Eigen::MatrixXd& gram, std::span<const Deviation> deviations,
                         const std::vector<Eigen::Index>& selected, Eigen::Index k) {
    if (gram(k, k) < kMinSingularValue) return "moves no measured TCP position";
    if (selected.empty()) return "is not determined by these TCP positions";
    const Eigen::VectorXd correlations = gram(selected, k);
    const Eigen::VectorXd share = base::solve_positive_definite(submatrix(gram, selected), correlations);
    const double unexplained = std::max(gram(k, k) - correlations.dot(share), 0.0);
    std::string combination;
    const double scale = typical_size(deviations[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < selected.size(); ++i) {
        const double part = share[static_cast<Eigen::Index>(i)];
        if (std::abs(part) < kMinShownShare) continue;
        const Deviation& other = deviations[static_cast<std::size_t>(selected[i])];
        const double each = part * typical_size(other) / scale;
        const bool first = combination.empty();
        const std::string factor =
            std::abs(std::abs(each) - 1) < 1e-3 ? "" : fmt::format("{:.3g} ", std::abs(each));
        combination += fmt::format("{}{}{}", first ? (each < 0 ? "-" : "") : (each < 0 ? " - " : " + "),
                                   factor, other.name);
    }
    if (unexplained > kMaxRedundantShare * kMaxRedundantShare * gram(k, k))
        return "is not determined well enough next to " + (combination.empty() ? "the others" : combination);
    return "is redundant: " + combination +
           (combination.find(' ', combination.find(' ') + 1) == std::string::npos ? " has the same effect"
                                                                                  : " have the same effect");
}

}  // namespace

Identification identify(const Eigen::MatrixXd& slopes, std::span<const Deviation> deviations) {
    const Eigen::Index count = slopes.cols();
    Eigen::VectorXd scale(count);
    for (Eigen::Index i = 0; i < count; ++i) scale[i] = typical_size(deviations[static_cast<std::size_t>(i)]);
    const Eigen::MatrixXd scaled = slopes * scale.asDiagonal();
    const Eigen::MatrixXd gram = scaled.transpose() * scaled;
    Identification found;
    // The singular values of the slopes are the roots of the eigenvalues of their squares. Their rounding
    // error is 1e-8 of the largest one. A machine of 1 m that is measured to 1 um has 1e5 there.
    found.singular_values = base::symmetric_eigenvalues(gram).cwiseMax(0).cwiseSqrt().reverse();
    const auto rank = static_cast<std::size_t>((found.singular_values.array() > kMinSingularValue).count());
    std::vector<Eigen::Index> selected;
    for (Eigen::Index k = 0; k < count && selected.size() < rank; ++k) {
        selected.push_back(k);
        if (!is_determined(submatrix(gram, selected))) selected.pop_back();
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto index = static_cast<std::size_t>(k);
        if (std::find(selected.begin(), selected.end(), k) != selected.end()) {
            found.selected.push_back(index);
        } else {
            found.fixed.push_back({deviations[index].name, fixed_reason(gram, deviations, selected, k)});
        }
    }
    return found;
}

}  // namespace gsim::calibrate
