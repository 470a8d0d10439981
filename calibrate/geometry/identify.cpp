#include "calibrate/geometry/identify.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/dense/symmetric.h"

namespace gsim::calibrate {

namespace {

/// Limit below which a direction is not determined to better than its usual size.
constexpr double kLeastTold = 1;
/// Max share of a deviation's effect not explained by others if it only repeats them.
constexpr double kRepeats = 1e-3;
constexpr double kLeastShown = 0.05;

Eigen::MatrixXd part_of(const Eigen::MatrixXd& square, const std::vector<Eigen::Index>& at) {
    return square(at, at);
}

/// Returns true if each direction of the deviations with these squares of slopes is determined to better than
/// its usual size.
bool is_told(Eigen::MatrixXd square) {
    square.diagonal().array() -= kLeastTold * kLeastTold;
    return base::is_positive_definite(square);
}

/// Returns which of the chosen deviations have the effect of deviation `k`, and how much of each.
std::string why_held(const Eigen::MatrixXd& gram, std::span<const Deviation> deviations,
                     const std::vector<Eigen::Index>& chosen, Eigen::Index k) {
    if (gram(k, k) < kLeastTold) return "moves no tip that was measured";
    if (chosen.empty()) return "is not told by these tips";
    const Eigen::VectorXd with = gram(chosen, k);
    const Eigen::VectorXd share = base::solve_positive(part_of(gram, chosen), with);
    const double left = std::max(gram(k, k) - with.dot(share), 0.0);
    std::string same;
    const double usual = usual_size(deviations[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const double part = share[static_cast<Eigen::Index>(i)];
        if (std::abs(part) < kLeastShown) continue;
        const Deviation& other = deviations[static_cast<std::size_t>(chosen[i])];
        const double each = part * usual_size(other) / usual;
        const bool first = same.empty();
        const std::string factor =
            std::abs(std::abs(each) - 1) < 1e-3 ? "" : fmt::format("{:.3g} ", std::abs(each));
        same += fmt::format("{}{}{}", first ? (each < 0 ? "-" : "") : (each < 0 ? " - " : " + "), factor,
                            other.name);
    }
    if (left > kRepeats * kRepeats * gram(k, k))
        return "is told too little of, beside " + (same.empty() ? "the others" : same);
    return "does what " + same + (same.find(' ', same.find(' ') + 1) == std::string::npos ? " does" : " do");
}

}  // namespace

Identified identify(const Eigen::MatrixXd& slopes, std::span<const Deviation> deviations) {
    const Eigen::Index count = slopes.cols();
    Eigen::VectorXd usual(count);
    for (Eigen::Index i = 0; i < count; ++i) usual[i] = usual_size(deviations[static_cast<std::size_t>(i)]);
    const Eigen::MatrixXd scaled = slopes * usual.asDiagonal();
    const Eigen::MatrixXd gram = scaled.transpose() * scaled;
    Identified found;
    // The singular values of the slopes are the roots of the eigenvalues of their squares. Their rounding
    // error is 1e-8 of the largest one. A machine of 1 m that is measured to 1 um has 1e5 there.
    found.singular_values = base::symmetric_eigenvalues(gram).cwiseMax(0).cwiseSqrt().reverse();
    const auto rank = static_cast<std::size_t>((found.singular_values.array() > kLeastTold).count());
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index k = 0; k < count && chosen.size() < rank; ++k) {
        chosen.push_back(k);
        if (!is_told(part_of(gram, chosen))) chosen.pop_back();
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto index = static_cast<std::size_t>(k);
        if (std::find(chosen.begin(), chosen.end(), k) != chosen.end()) {
            found.chosen.push_back(index);
        } else {
            found.held.push_back({deviations[index].name, why_held(gram, deviations, chosen, k)});
        }
    }
    return found;
}

}  // namespace gsim::calibrate
