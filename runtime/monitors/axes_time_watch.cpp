#include "runtime/monitors/axes_time_watch.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion_sources/motion_replay.h"
#include "runtime/motion_sources/time_alone.h"
#include "runtime/simulator/setup_of_machine.h"

namespace gsim::simulation {

AxesTimeWatch::AxesTimeWatch(const machine::Machine& machine)
    : nowhere_(std::make_unique<TimeAlone>()),
      times_(machine.times),
      planner_(setup_of_machine(machine), nowhere_.get()) {
    if (std::any_of(machine.axes.begin(), machine.axes.end(),
                    [](const machine::Axis& axis) { return std::isinf(axis.max_acceleration); }))
        untold("an axis has no max_acceleration");
}

void AxesTimeWatch::untold(std::string_view why) {
    if (why_not_.empty()) why_not_ = why;
}

void AxesTimeWatch::stands_at(const rrs::JointPos& joints) {
    if (const auto stands = planner_.stand_at({joints, std::nullopt}); !stands)
        untold(stands.error().message);
}

void AxesTimeWatch::asked(const MotionAsk& ask) {
    if (!why_not_.empty()) return;
    if (const auto put = ask_again(ask, times_, planner_); !put) untold(put.error().message);
}

void AxesTimeWatch::ended() {
    planner_.come_to_last_rest();
    planner_.flush();
}

std::optional<double> AxesTimeWatch::time_s() const {
    if (!why_not_.empty()) return std::nullopt;
    return planner_.time_s();
}

}  // namespace gsim::simulation
