#include "runtime/motion_sources/step_progress.h"

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

constexpr double kMaxIdle_s = 600;
constexpr std::uint64_t kMaxZeroTimeSteps = 1'000'000;

}  // namespace

std::optional<std::string> StepProgress::on_step(bool moved, double elapsed_s) {
    idle_s_ = moved ? 0 : idle_s_ + elapsed_s;
    zero_time_steps_ = elapsed_s > 0 ? 0 : zero_time_steps_ + 1;
    if (zero_time_steps_ > kMaxZeroTimeSteps) return "responds to GetNextStep, but its time does not advance";
    if (idle_s_ > kMaxIdle_s + requested_dwell_s_)
        return fmt::format("has not moved for {:.10g} s, although targets are pending", idle_s_);
    return std::nullopt;
}

}  // namespace gsim::simulation
