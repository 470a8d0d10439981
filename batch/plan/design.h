#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "batch/plan/setting.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// Method of combining values of settings.
enum class Sampling : std::uint8_t {
    grid,             ///< Each value of one with each of all others.
    random,           ///< Each by lot.
    latin_hypercube,  ///< By lot, but each setting has one value in each of as many equal parts as there are
                      ///< runs.
    sobol,   ///< The sequence of Sobol: even in all dimensions, the first of them as good as few can be.
    listed,  ///< Those that DesignOptions has; no plan file says so.
};

/// Options for the values of settings in the variants of a batch.
struct DesignOptions {
    Sampling sampling = Sampling::grid;
    std::uint64_t runs = 0;  ///< For all but a grid.
    std::uint64_t seed = 1;
    std::vector<std::vector<SettingValue>> listed = {};
};

/// Variants of a batch: each has a value of each setting. The same options give the same variants on any
/// machine.
class Design {
  public:
    Design(std::vector<Setting> settings, const DesignOptions& options);

    std::uint64_t size() const { return size_; }
    std::vector<SettingValue> variant(std::uint64_t number) const;

  private:
    std::vector<SettingValue> grid_variant(std::uint64_t number) const;

    std::vector<Setting> settings_;
    Sampling sampling_;
    std::uint64_t size_ = 1;
    std::vector<std::vector<SettingValue>> listed_;
    std::vector<double> shares_;  ///< For all settings of the first variant, the second one, ...
};

}  // namespace gsim::batch
