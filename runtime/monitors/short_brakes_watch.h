#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/outputs/run_output.h"

namespace gsim::simulation {

/// Looks for blocks at whose end the machine crawls, as the control's ramps in steps of time had braked
/// before (motion::SteppedRamps), and for what that takes.
class ShortBrakesWatch : public RunOutput {
  public:
    using RunOutput::take;
    void take(const motion::Segment& segment, const MoveInfo& info) override;

    /// A sentence for the report, if the machine crawled. `files` are the names that places index.
    std::optional<std::string> warning(const std::vector<std::string>& files) const;

  private:
    std::uint64_t count_ = 0;
    double crawled_s_ = 0;
    double longest_s_ = 0;
    double longest_mm_ = 0;
    Place longest_place_;
};

}  // namespace gsim::simulation
