#include "batch/statistics/regression.h"

#include <Eigen/Dense>
#include <cmath>

namespace gsim::batch {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd centred(const std::vector<double>& values) {
    const Eigen::Map<const VectorXd> all(values.data(), static_cast<Index>(values.size()));
    return all.array() - all.mean();
}

}  // namespace

Sensitivity regress(const std::vector<std::string>& names, const std::vector<std::vector<double>>& settings,
                    const std::vector<double>& figures) {
    Sensitivity found;
    const auto runs = static_cast<Index>(figures.size());
    const VectorXd figure = centred(figures);
    std::vector<VectorXd> columns;
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < names.size(); ++i) {
        VectorXd column = centred(settings[i]);
        if (column.norm() <= 1e-12 * std::sqrt(static_cast<double>(runs))) continue;
        columns.push_back(std::move(column));
        kept.push_back(names[i]);
    }
    const auto count = static_cast<Index>(columns.size());
    if (count == 0 || runs <= count + 1 || !(figure.norm() > 0)) return found;
    Eigen::MatrixXd matrix(runs, count);
    for (Index i = 0; i < count; ++i) matrix.col(i) = columns[static_cast<std::size_t>(i)].normalized();
    const VectorXd weights = matrix.colPivHouseholderQr().solve(figure);
    for (Index i = 0; i < count; ++i) {
        const auto place = static_cast<std::size_t>(i);
        found.parts.push_back({kept[place], weights[i] / columns[place].norm(), weights[i] / figure.norm()});
    }
    found.explained = 1 - (figure - matrix * weights).squaredNorm() / figure.squaredNorm();
    return found;
}

}  // namespace gsim::batch
