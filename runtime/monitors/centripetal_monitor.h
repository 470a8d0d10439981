#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "machine/model/machine.h"
#include "runtime/outputs/run_output.h"

namespace gsim::simulation {

/// Monitor for arcs that need more centripetal acceleration than the axes in their plane have. Some
/// controllers limit only the acceleration along the path, so a real machine would run such an arc slower, or
/// leave it.
class CentripetalMonitor : public RunOutput {
  public:
    /// `machine` must outlive this.
    explicit CentripetalMonitor(const machine::Machine& machine);

    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;

    /// Returns a message for the report, if such an arc was found. `files` are the names that source
    /// locations index.
    std::optional<std::string> warning(const std::vector<std::string>& files) const;

  private:
    double limit_in_plane_mm_s2(const motion::Segment& segment) const;

    const machine::Machine& machine_;
    double min_acceleration_mm_s2_;  // of all linear axes
    std::uint64_t count_ = 0;
    double worst_excess_ = 1;  // asked / limit
    double worst_mm_s2_ = 0;
    double worst_limit_mm_s2_ = 0;
    SourceLocation worst_location_;
};

}  // namespace gsim::simulation
