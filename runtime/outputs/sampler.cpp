#include "runtime/outputs/sampler.h"

#include <algorithm>
#include <stdexcept>

namespace gsim::simulation {

namespace {

// Difference below which instants show as equal; the later one, the start of the next segment, is reported.
constexpr double kInstantTolerance_s = 0.5e-9;

}  // namespace

Sampler::Sampler(double step_s, double max_time_s) : step_s_(step_s), max_time_s_(max_time_s) {
    if (!(step_s >= kMinStep_s)) throw std::invalid_argument("the step of a trajectory is less than 1e-6 s");
}

bool Sampler::is_due(double before_s) const {
    return accepts_samples_ && next_s() < before_s - kInstantTolerance_s && next_s() <= max_time_s_;
}

void Sampler::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    for (; is_due(segment.start_s); ++next_) accepts_samples_ = sample(next_s(), position_, 0, line_);
    line_ = info.location.line;
    segment_ = &segment;
    for (; is_due(segment.end_s()); ++next_) {
        const double t_s = time_in_segment_s_ = std::max(0.0, next_s() - segment.start_s);
        accepts_samples_ = sample(next_s(), segment.position_at(t_s), segment.path_speed_mm_s(t_s), line_);
    }
    segment_ = nullptr;
    position_ = segment.end_position();
}

void Sampler::end(double end_s) {
    static_cast<void>(sample(end_s, position_, 0, line_));
}

}  // namespace gsim::simulation
