#include "runtime/simulator/probe_signal.h"

namespace gsim::simulation {

namespace {

constexpr double kInstant_s = 1e-12;

}  // namespace

std::optional<double> MarkSignal::comes_s(const motion::Segment& segment) {
    if (!is_there(segment.position_at(segment.duration_s))) return std::nullopt;
    double before_s = 0;
    double there_s = segment.duration_s;
    while (there_s - before_s > kInstant_s) {
        const double middle_s = before_s + (there_s - before_s) / 2;
        if (middle_s <= before_s || middle_s >= there_s) break;
        (is_there(segment.position_at(middle_s)) ? there_s : before_s) = middle_s;
    }
    return there_s;
}

}  // namespace gsim::simulation
