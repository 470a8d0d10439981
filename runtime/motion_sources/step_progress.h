#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gsim::simulation {

/// Check that the steps of a module make progress. A foreign planner may respond without end; each form of
/// that ends here.
class StepProgress {
  public:
    /// Permits more time without motion, because a dwell was requested.
    void add_dwell(double dwell_s) { requested_dwell_s_ += dwell_s; }
    /// Counts a step. Returns an error, which continues a message that begins with the module's name, after a
    /// million steps without time, or after ten minutes without motion in addition to the requested dwells.
    std::optional<std::string> on_step(bool moved, double elapsed_s);

  private:
    double idle_s_ = 0;  ///< Since something moved last.
    double requested_dwell_s_ = 0;
    std::uint64_t zero_time_steps_ = 0;  ///< Consecutive steps without time.
};

}  // namespace gsim::simulation
