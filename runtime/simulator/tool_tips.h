#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace gsim::simulation {

/// TCPs of the tools that a run has used, each once, so that a move refers to its own by a small number.
class ToolTips {
  public:
    /// Returns the number of a TCP, relative to the tool centre point of the kinematics (mm). After 65,536 of
    /// them, which only a script can produce, new ones count as the last.
    std::uint16_t number(const Eigen::Vector3d& tip_mm) {
        constexpr std::size_t kMost = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
        const Key key{tip_mm.x(), tip_mm.y(), tip_mm.z()};
        if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
        if (tips_mm_.size() == kMost) return static_cast<std::uint16_t>(kMost - 1);
        const auto number = static_cast<std::uint16_t>(tips_mm_.size());
        numbers_.emplace(key, number);
        tips_mm_.push_back(tip_mm);
        return number;
    }
    const std::vector<Eigen::Vector3d>& list_mm() const { return tips_mm_; }

  private:
    using Key = std::array<double, 3>;

    std::map<Key, std::uint16_t> numbers_{{Key{}, std::uint16_t{0}}};
    std::vector<Eigen::Vector3d> tips_mm_{Eigen::Vector3d::Zero()};  ///< The first one is of no tool.
};

}  // namespace gsim::simulation
