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
class TcpTable {
  public:
    /// Returns the number of a TCP, relative to the tool centre point of the kinematics (mm). Beyond 65,536
    /// of them, which only a script can produce, new ones count as the last.
    std::uint16_t number(const Eigen::Vector3d& tcp_mm) {
        constexpr std::size_t kMax = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
        const Key key{tcp_mm.x(), tcp_mm.y(), tcp_mm.z()};
        if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
        if (tcp_offsets_mm_.size() == kMax) return static_cast<std::uint16_t>(kMax - 1);
        const auto number = static_cast<std::uint16_t>(tcp_offsets_mm_.size());
        numbers_.emplace(key, number);
        tcp_offsets_mm_.push_back(tcp_mm);
        return number;
    }
    const std::vector<Eigen::Vector3d>& offsets_mm() const { return tcp_offsets_mm_; }

  private:
    using Key = std::array<double, 3>;

    std::map<Key, std::uint16_t> numbers_{{Key{}, std::uint16_t{0}}};
    std::vector<Eigen::Vector3d> tcp_offsets_mm_{Eigen::Vector3d::Zero()};  ///< The first one is of no tool.
};

}  // namespace gsim::simulation
