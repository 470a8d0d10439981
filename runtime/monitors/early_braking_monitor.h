#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/outputs/run_output.h"

namespace gsim::simulation {

/// Monitor for blocks with a crawl at their end, because the controller's ramps in time steps had braked
/// before (motion::SteppedRamps), and for the time it takes.
class EarlyBrakingMonitor : public RunOutput {
  public:
    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;

    /// Returns a message for the report, if the machine crawled. `files` are the names that source locations
    /// index.
    std::optional<std::string> warning(const std::vector<std::string>& files) const;

  private:
    std::uint64_t count_ = 0;
    double crawl_time_s_ = 0;
    double longest_s_ = 0;
    double longest_mm_ = 0;
    SourceLocation longest_location_;
};

}  // namespace gsim::simulation
