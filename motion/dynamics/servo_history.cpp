#include "motion/dynamics/servo_history.h"

#include <algorithm>

namespace gsim::dynamics {

namespace {

constexpr std::size_t kMinStoredSteps = 3;        // steps that are kept,
constexpr std::size_t kMaxStoredSteps = 100'000;  // and the max, whatever the delay

}  // namespace

ServoHistory::ServoHistory(const std::vector<ServoLoop>& loops) {
    delays_s_.reserve(loops.size());
    for (const ServoLoop& loop : loops) {
        delays_s_.push_back(loop.delay_s);
        longest_delay_s_ = std::max(longest_delay_s_, loop.delay_s);
    }
}

void ServoHistory::add(Step step) {
    steps_.push_back(std::move(step));
    const auto covers_delay = [this] {
        return steps_[1].start_s <= steps_[steps_.size() - kMinStoredSteps].start_s - longest_delay_s_;
    };
    while (steps_.size() > kMinStoredSteps && (covers_delay() || steps_.size() > kMaxStoredSteps)) {
        spare_ = std::move(steps_.front());
        steps_.pop_front();
    }
}

const ServoHistory::Step* ServoHistory::step_at(double t_s) const {
    if (steps_.empty()) return nullptr;
    if (t_s >= steps_.back().start_s) return &steps_.back();
    const auto above = std::upper_bound(steps_.begin(), steps_.end(), t_s,
                                        [](double at_s, const Step& step) { return at_s < step.start_s; });
    return above == steps_.begin() ? &steps_.front() : &*(above - 1);
}

rrs::JointPos ServoHistory::set_points(double t_s) const {
    const Step* step = step_at(t_s);
    if (step == nullptr) return start_;
    rrs::JointPos points(start_.size());
    const double step_offset_s = std::clamp(t_s - step->start_s, 0.0, step->duration_s);
    for (std::size_t joint = 0; joint < delays_s_.size(); ++joint)
        points[static_cast<Eigen::Index>(joint)] = step->joints[joint].set_point(step_offset_s);
    return points;
}

rrs::JointPos ServoHistory::positions(double t_s) const {
    if (steps_.empty()) return start_;
    rrs::JointPos positions(start_.size());
    for (std::size_t joint = 0; joint < delays_s_.size(); ++joint) {
        const double delayed_s = t_s - delays_s_[joint];
        const Step* step = step_at(delayed_s);
        const double step_offset_s = std::clamp(delayed_s - step->start_s, 0.0, step->duration_s);
        const JointStep& of = step->joints[joint];
        positions[static_cast<Eigen::Index>(joint)] =
            of.set_point(step_offset_s) - of.error.at(step_offset_s).value;
    }
    return positions;
}

}  // namespace gsim::dynamics
