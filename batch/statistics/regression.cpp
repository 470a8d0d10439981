#include "batch/statistics/regression.h"

#include <Eigen/Dense>
#include <cmath>

namespace gsim::batch {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd centered(const std::vector<double>& values) {
    const Eigen::Map<const VectorXd> all(values.data(), static_cast<Index>(values.size()));
    return all.array() - all.mean();
}

}  // namespace

Sensitivity regress(const std::vector<std::string>& names, const std::vector<std::vector<double>>& settings,
                    const std::vector<double>& samples) {
    Sensitivity found;
    const auto runs = static_cast<Index>(samples.size());
    const VectorXd centered_samples = centered(samples);
    std::vector<VectorXd> columns;
    std::vector<std::string> kept_names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        VectorXd column = centered(settings[i]);
        if (column.norm() <= 1e-12 * std::sqrt(static_cast<double>(runs))) continue;
        columns.push_back(std::move(column));
        kept_names.push_back(names[i]);
    }
    const auto count = static_cast<Index>(columns.size());
    if (count == 0 || runs <= count + 1 || !(centered_samples.norm() > 0)) return found;
    Eigen::MatrixXd matrix(runs, count);
    for (Index i = 0; i < count; ++i) matrix.col(i) = columns[static_cast<std::size_t>(i)].normalized();
    const VectorXd weights = matrix.colPivHouseholderQr().solve(centered_samples);
    for (Index i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        found.effects.push_back(
            {kept_names[index], weights[i] / columns[index].norm(), weights[i] / centered_samples.norm()});
    }
    found.explained =
        1 - (centered_samples - matrix * weights).squaredNorm() / centered_samples.squaredNorm();
    return found;
}

}  // namespace gsim::batch
