#include "studio/engine/series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::studio {

namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
constexpr double kShortest_s = 1e-3;  // for a run with too many instants

using Values = std::span<const float>;

/// Interpolates values between two instants, at a share of the interval.
void mix(Values from, Values to, double share, std::vector<float>& mixed) {
    for (std::size_t i = 0; i < mixed.size(); ++i)
        mixed[i] = std::lerp(from[i], to[i], static_cast<float>(share));
}

/// Merges each two steps into one.
template <typename Better>
void join(std::vector<float>& steps, std::size_t width, const Better& better) {
    const std::size_t count = steps.size() / width;
    for (std::size_t step = 0; step < count; ++step) {
        for (std::size_t i = 0; i < width; ++i) {
            float& joined = steps[step / 2 * width + i];
            const float value = steps[step * width + i];
            joined = step % 2 == 0 ? value : better(joined, value);
        }
    }
    steps.resize((count + 1) / 2 * width);
}

}  // namespace

void Series::add(double t_s, Values values) {
    if (!is_stepped() && t_s_.size() == max_instants_) convert_to_steps();
    if (is_stepped()) {
        add_segment(last_s_, last_, t_s, values);
    } else {
        t_s_.push_back(t_s);
        values_.insert(values_.end(), values.begin(), values.end());
    }
    last_s_ = t_s;
    last_.assign(values.begin(), values.end());
}

void Series::convert_to_steps() {
    step_s_ = 2 * std::max(t_s_.back(), kShortest_s) / static_cast<double>(max_steps());
    const Values all(values_);
    for (std::size_t i = 0; i < t_s_.size(); ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        add_segment(t_s_[before], all.subspan(before * width_, width_), t_s_[i],
                    all.subspan(i * width_, width_));
    }
    t_s_ = {};
    values_ = {};
}

void Series::double_step_length() {
    step_s_ *= 2;
    join(min_, width_, [](float a, float b) { return std::fmin(a, b); });
    join(max_, width_, [](float a, float b) { return std::fmax(a, b); });
}

/// Extends each step by the range of a straight line from one instant to the next. If a value is missing at
/// one end, none exist between.
void Series::add_segment(double from_s, Values from, double to_s, Values to) {
    while (step_at(to_s) >= max_steps()) double_step_length();
    const std::size_t first = step_at(from_s);
    const std::size_t last = step_at(to_s);
    extend_range(first, from);
    extend_range(last, to);
    std::vector<float> border(width_);
    for (std::size_t step = first; step < last; ++step) {
        const double step_end_s = static_cast<double>(step + 1) * step_s_;
        mix(from, to, std::clamp((step_end_s - from_s) / (to_s - from_s), 0.0, 1.0), border);
        extend_range(step, border);
        extend_range(step + 1, border);
    }
}

void Series::extend_range(std::size_t step, Values values) {
    const std::size_t at = step * width_;
    if (min_.size() < at + width_) {
        min_.resize(at + width_, kNoValue);
        max_.resize(at + width_, kNoValue);
    }
    for (std::size_t i = 0; i < width_; ++i) {
        min_[at + i] = std::fmin(min_[at + i], values[i]);
        max_[at + i] = std::fmax(max_[at + i], values[i]);
    }
}

void Series::add_columns(Message& message) const {
    message.header()["step_s"] = step_s_;
    if (is_stepped()) {
        message.add("low", min_);
        message.add("high", max_);
    } else {
        message.add("t_s", t_s_);
        message.add("values", values_);
    }
}

}  // namespace gsim::studio
