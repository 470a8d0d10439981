#include "motion/profile/stepped_ramps.h"

#include <algorithm>
#include <cmath>

namespace gsim::motion {

namespace {

constexpr double kMinute_s = 60;
constexpr float kMinSpeed_mm_min = 1e-3F;  // lowest speed that is driven

/// Returns the part that covers `distance_mm` in `time_min` from `speed_mm_min` on with one acceleration, or
/// evenly if that would run back.
LawSection constant_acceleration_section(double distance_mm, double time_min, double speed_mm_min) {
    const double time_s = time_min * kMinute_s;
    const double mean_mm_s = distance_mm / time_s;
    const double start_mm_s =
        speed_mm_min / kMinute_s <= 2 * mean_mm_s ? speed_mm_min / kMinute_s : mean_mm_s;
    return {time_s, 0, start_mm_s, 2 * (mean_mm_s - start_mm_s) / time_s, 0};
}

}  // namespace

float SteppedRamps::mean_acceleration(float speed_mm_min, float acceleration_mm_min2, float jerk_mm_min3) {
    const float jerk_min = acceleration_mm_min2 / jerk_mm_min3;
    const float jerk_speed = 0.5F * jerk_mm_min3 * jerk_min * jerk_min;
    if (0.5F * speed_mm_min > jerk_speed) {
        return speed_mm_min / (2.0F * (jerk_min + (0.5F * speed_mm_min - jerk_speed) / acceleration_mm_min2));
    }
    const double half_min = std::sqrt(static_cast<double>(speed_mm_min / jerk_mm_min3));
    return static_cast<float>(static_cast<double>(speed_mm_min) / (2.0 * half_min));
}

double SteppedRamps::mean_acceleration_s(double speed, double acceleration, double jerk) {
    const double mean = mean_acceleration(static_cast<float>(speed * kMinute_s),
                                          static_cast<float>(acceleration * kMinute_s * kMinute_s),
                                          static_cast<float>(jerk * kMinute_s * kMinute_s * kMinute_s));
    return mean / (kMinute_s * kMinute_s);
}

/// Plans the start and end of the ramps by the mean acceleration.
void SteppedRamps::plan(const SteppedBlock& block) {
    const float length_per_squared_speed = 0.5F / block.mean_acceleration_mm_min2;
    const float entry = block.entry_mm_min * block.entry_mm_min;
    const float exit = block.exit_mm_min * block.exit_mm_min;
    const float cruise = block.speed_mm_min * block.speed_mm_min;
    const float meeting_mm = 0.5F * (block.length_mm + length_per_squared_speed * (entry - exit));
    remaining_mm_ = block.length_mm;
    speed_mm_min_ = block.entry_mm_min;
    phase_ = Phase::up;
    up_until_mm_ = block.length_mm;
    stops_short_ = false;
    if (!(meeting_mm > 0)) {
        up_until_mm_ = 0;
        top_mm_min_ = block.exit_mm_min;
        return;
    }
    if (meeting_mm >= block.length_mm) {
        phase_ = Phase::down;
        return;
    }
    down_from_mm_ = length_per_squared_speed * (cruise - exit);
    if (down_from_mm_ >= meeting_mm) {
        up_until_mm_ = down_from_mm_ = meeting_mm;
        top_mm_min_ = std::sqrt(2.0F * block.mean_acceleration_mm_min2 * meeting_mm + exit);
        return;
    }
    top_mm_min_ = block.speed_mm_min;
    if (entry == cruise) {
        phase_ = Phase::cruise;
        return;
    }
    up_until_mm_ -= length_per_squared_speed * std::abs(cruise - entry);
    if (entry > cruise) phase_ = up_until_mm_ > down_from_mm_ ? Phase::slow_down : Phase::down;
}

void SteppedRamps::drive(const SteppedBlock& block,
                         const std::function<void(const SteppedSection&)>& on_part) {
    plan(block);
    while (remaining_mm_ > 0) advance_step(block, on_part);
}

/// Runs one step of time, or less at the end of the block.
void SteppedRamps::advance_step(const SteppedBlock& block,
                                const std::function<void(const SteppedSection&)>& on_part) {
    const float step_from_mm = remaining_mm_;
    float done_min = 0;
    float time_min = step_min_;
    do {
        const float from_mm = remaining_mm_;
        const float from_mm_min = speed_mm_min_;
        const Phase phase = phase_;
        switch (phase_) {
            case Phase::slow_down: time_min = slow_down(block, time_min, step_from_mm); break;
            case Phase::up: time_min = ramp_up(block, time_min, step_from_mm); break;
            case Phase::cruise: time_min = cruise(time_min); break;
            case Phase::down: time_min = ramp_down(block, time_min); break;
        }
        if (from_mm == remaining_mm_ && from_mm_min == speed_mm_min_ && phase == phase_)
            return finish_at_constant_speed(block, on_part);
        if (time_min > 0 && from_mm > remaining_mm_) {
            const bool creeps = stops_short_ && time_min > step_min_;
            on_part({constant_acceleration_section(
                         static_cast<double>(from_mm) - static_cast<double>(remaining_mm_),
                         static_cast<double>(time_min), static_cast<double>(from_mm_min)),
                     creeps});
        }
        done_min += time_min;
        time_min = step_min_ - done_min;
    } while (time_min > 0 && remaining_mm_ > 0);
}

void SteppedRamps::change_acceleration(const SteppedBlock& block, float time_min, bool increases) {
    const float change = block.jerk_mm_min3 * time_min;
    acceleration_ = increases ? std::min(acceleration_ + change, block.acceleration_mm_min2)
                              : std::max(acceleration_ - change, change);
}

/// The remainder is too long for a step of time to change it in 32 bits, so it is run in one part.
void SteppedRamps::finish_at_constant_speed(const SteppedBlock& block,
                                            const std::function<void(const SteppedSection&)>& on_part) {
    const float speed = std::max({speed_mm_min_, block.exit_mm_min, kMinSpeed_mm_min});
    on_part({constant_acceleration_section(static_cast<double>(remaining_mm_),
                                           static_cast<double>(remaining_mm_ / speed),
                                           static_cast<double>(speed)),
             false});
    remaining_mm_ = 0;
}

float SteppedRamps::slow_down(const SteppedBlock& block, float time_min, float step_from_mm) {
    const float loss = block.mean_acceleration_mm_min2 * time_min;
    if (speed_mm_min_ - top_mm_min_ > loss) {
        remaining_mm_ -= time_min * (speed_mm_min_ - 0.5F * loss);
        speed_mm_min_ -= loss;
        return time_min;
    }
    remaining_mm_ = std::min(remaining_mm_, up_until_mm_);
    const float last_min = 2.0F * (step_from_mm - remaining_mm_) / (speed_mm_min_ + top_mm_min_);
    phase_ = Phase::cruise;
    speed_mm_min_ = top_mm_min_;
    return last_min;
}

float SteppedRamps::ramp_up(const SteppedBlock& block, float time_min, float step_from_mm) {
    const float ramp_down_min = acceleration_ / block.jerk_mm_min3;
    const float ramp_down_mm = ramp_down_min * (speed_mm_min_ + (0.5F * acceleration_ * ramp_down_min) +
                                                (block.jerk_mm_min3 * ramp_down_min * ramp_down_min) / 6.0F);
    change_acceleration(block, time_min, remaining_mm_ - up_until_mm_ > ramp_down_mm);
    const float gain = acceleration_ * time_min;
    remaining_mm_ -= time_min * (speed_mm_min_ + 0.5F * gain);
    if (remaining_mm_ >= up_until_mm_) {
        speed_mm_min_ += gain;
        return time_min;
    }
    remaining_mm_ = up_until_mm_;
    const float last_min = 2.0F * (step_from_mm - remaining_mm_) / (speed_mm_min_ + top_mm_min_);
    phase_ = remaining_mm_ == down_from_mm_ ? Phase::down : Phase::cruise;
    speed_mm_min_ = top_mm_min_;
    acceleration_ = 0;
    return last_min;
}

float SteppedRamps::cruise(float time_min) {
    const float remaining = remaining_mm_ - top_mm_min_ * time_min;
    if (remaining >= down_from_mm_) {
        remaining_mm_ = remaining;
        return time_min;
    }
    const float last_min = (remaining_mm_ - down_from_mm_) / top_mm_min_;
    remaining_mm_ = down_from_mm_;
    phase_ = Phase::down;
    return last_min;
}

float SteppedRamps::ramp_down(const SteppedBlock& block, float time_min) {
    const float ramp_down_min = acceleration_ / block.jerk_mm_min3;
    const float ramp_down_mm_min =
        block.exit_mm_min + ramp_down_min * (acceleration_ - (0.5F * block.jerk_mm_min3 * ramp_down_min));
    change_acceleration(block, time_min, speed_mm_min_ > ramp_down_mm_min);
    const float loss = acceleration_ * time_min;
    if (speed_mm_min_ > loss) {
        const float remaining = remaining_mm_ - time_min * (speed_mm_min_ - 0.5F * loss);
        if (remaining > 0) {
            remaining_mm_ = remaining;
            speed_mm_min_ -= loss;
            return time_min;
        }
    }
    const float last_min =
        2.0F * remaining_mm_ / std::max(speed_mm_min_ + block.exit_mm_min, kMinSpeed_mm_min);
    remaining_mm_ = 0;
    speed_mm_min_ = block.exit_mm_min;
    stops_short_ = true;
    return last_min;
}

}  // namespace gsim::motion
