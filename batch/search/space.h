#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "batch/plan/setting.h"

namespace gsim::batch {

/// Settings as points of a box, each coordinate from 0 to 1: one for a setting. An order has one for each of
/// its items, which are sorted by their coordinates.
class SearchSpace {
  public:
    explicit SearchSpace(std::vector<Setting> settings);

    std::size_t dimensions() const { return dimensions_; }
    std::vector<SettingValue> variant(const Eigen::VectorXd& point) const;

  private:
    std::vector<Setting> settings_;
    std::size_t dimensions_ = 0;
};

}  // namespace gsim::batch
