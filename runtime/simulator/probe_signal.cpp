#include "runtime/simulator/probe_signal.h"

namespace gsim::simulation {

namespace {

constexpr double kTimeTolerance_s = 1e-12;

}  // namespace

std::optional<double> ThresholdSignal::activation_s(const motion::Segment& segment) {
    if (!is_active(segment.position_at(segment.duration_s))) return std::nullopt;
    double before_s = 0;
    double active_s = segment.duration_s;
    while (active_s - before_s > kTimeTolerance_s) {
        const double middle_s = before_s + (active_s - before_s) / 2;
        if (middle_s <= before_s || middle_s >= active_s) break;
        (is_active(segment.position_at(middle_s)) ? active_s : before_s) = middle_s;
    }
    return active_s;
}

}  // namespace gsim::simulation
