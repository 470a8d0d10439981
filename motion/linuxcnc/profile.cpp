#include "motion/linuxcnc/profile.h"

#include <algorithm>
#include <cmath>

#include "motion/profile/law_cut.h"
#include "motion/profile/ramp.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kSameLength = 1e-9;  // a shortfall that is rounding

// Unit of speed in mm/s for one period of acceleration, and unit of length in mm for one period of that
// speed. The acceleration is 1 in these units, and a period takes 1.
struct Units {
    double time;
    double speed;
    double length;
    double acceleration;
};

Units units_of(const Stretch& stretch, double period_s) {
    const double speed = stretch.acceleration * period_s;
    return {period_s, speed, speed * period_s, stretch.acceleration};
}

// Returns the speed at the end of the next period from which the remaining distance suffices to brake.
double brake_speed(double speed, double way) {
    return std::sqrt(std::max(0.0, 2 * way - speed + 0.25)) - 0.5;
}

// Builder of a law, period by period, in Units.
class Counter {
  public:
    Counter(double way, const Units& units) : way_(way), units_(units) {}

    double speed() const { return speed_; }
    double way() const { return way_; }

    void ramp_up(double periods) {
        add(periods, 1);
        way_ -= periods * periods / 2;
        speed_ = periods;
    }
    void change_to(double speed) {
        add(1, speed - speed_);
        way_ -= (speed_ + speed) / 2;
        speed_ = speed;
    }
    void cruise(double periods) {
        add(periods, 0);
        way_ -= periods * speed_;
    }
    // Returns the number of periods of full braking, which end within a period.
    double brake() {
        const double from = brake_speed(speed_, way_);
        if (from < 0) return stop_within_period();
        change_to(from);
        add(from, -1);
        idle(std::ceil(from - kWholePeriods) - from);
        return from;
    }
    const Law& law() const { return law_; }

  private:
    void add(double periods, double acceleration) {
        law_.add(periods * units_.time, speed_ * units_.speed, acceleration * units_.acceleration);
    }
    void idle(double periods) { law_.rest(periods * units_.time); }
    double stop_within_period() {
        const double periods = speed_ > 0 ? std::clamp(2 * way_ / speed_, 0.0, 1.0) : 0;
        if (periods > 0) add(periods, -speed_ / periods);
        idle(1 - periods);
        return 0;
    }

    Law law_;
    double speed_ = 0;
    double way_;
    Units units_;
};

Profile counted(const Stretch& stretch, double period_s) {
    const Units units = units_of(stretch, period_s);
    const double top = stretch.top_speed / units.speed;
    Counter counter(stretch.length / units.length, units);
    counter.ramp_up(
        std::min(std::floor(std::sqrt(counter.way()) + kWholePeriods), std::floor(top + kWholePeriods)));
    if (brake_speed(counter.speed(), counter.way()) >= top) {
        if (top > counter.speed() + kWholePeriods) counter.change_to(top);
        counter.cruise(std::max(0.0, std::floor((counter.way() - top * top / 2) / top + kWholePeriods)));
    }
    const double braked = counter.brake();
    return {counter.law(), braked * period_s, 0};
}

double reached(double start_speed, double signed_acceleration, double length) {
    return std::sqrt(std::max(0.0, start_speed * start_speed + 2 * signed_acceleration * length));
}

LawLimits limits_of(const Stretch& stretch) {
    return {stretch.top_speed, stretch.acceleration, stretch.acceleration, stretch.jerk};
}

Law law_of(const TimeLaw& time_law) {
    Law law;
    for (const LawPiece& piece : time_law.pieces()) law.add(piece.duration_s, piece.v0, piece.a0, piece.jerk);
    return law;
}

// True if a ramp from one speed to the other exists with acceleration 0 at both ends.
bool has_curve(const Stretch& stretch, double start_speed, double end_speed) {
    return std::isfinite(stretch.jerk) && ramp_length(start_speed, end_speed, stretch.acceleration,
                                                      stretch.jerk) <= stretch.length * (1 + kSameLength);
}

Profile curve(const Stretch& stretch, double start_speed, double end_speed) {
    const TimeLaw law = TimeLaw::between(stretch.length, start_speed, end_speed, limits_of(stretch));
    const double peak = std::min(law.peak_speed(), std::max(stretch.top_speed, end_speed));
    return {law_of(law), ramp_s(peak, end_speed, stretch.acceleration, stretch.jerk), end_speed};
}

}  // namespace

double peak_speed(double length, double acceleration, double jerk) {
    return ramp_end_speed(length / 2, 0, acceleration, jerk);
}

Profile rest_to_rest(const Stretch& stretch, const Clock& clock) {
    return clock.counts ? counted(stretch, clock.period_s) : from_speed_to_speed(stretch, 0, 0);
}

Profile ramp(double length, double start_speed, double end_speed) {
    Profile profile;
    const double duration_s = 2 * length / (start_speed + end_speed);
    profile.law.add(duration_s, start_speed, (end_speed - start_speed) / duration_s);
    profile.brake_s = end_speed < start_speed ? duration_s : 0;
    profile.end_speed = end_speed;
    return profile;
}

Profile continued(const Law& before, const Profile& profile) {
    Profile whole = profile;
    whole.law = before;
    whole.law.append(profile.law);
    return whole;
}

Law easing(double speed, double acceleration, double jerk) {
    Law law;
    law.add(std::abs(acceleration) / jerk, speed, acceleration, acceleration > 0 ? -jerk : jerk);
    return law;
}

Profile braking(const Stretch& stretch, double start_speed, double end_speed) {
    const TimeLaw law = braking_law(stretch.length, start_speed, end_speed, limits_of(stretch));
    return {law_of(law), law.duration_s(), law.end_speed()};
}

double slow_s(const Profile& profile, double speed) {
    constexpr int kSteps = 50;
    const double end_s = profile.law.duration_s();
    double fast = end_s - profile.brake_s, slow = end_s;
    for (int i = 0; i < kSteps; ++i) {
        const double middle = (fast + slow) / 2;
        (profile.law.speed_at(middle) < speed ? slow : fast) = middle;
    }
    return end_s - slow;
}

Profile from_speed_to_speed(const Stretch& stretch, double start_speed, double end_speed) {
    if (has_curve(stretch, start_speed, end_speed)) return curve(stretch, start_speed, end_speed);
    const double a = stretch.acceleration;
    const double fastest = reached(start_speed, a, stretch.length);
    if (fastest <= end_speed) return ramp(stretch.length, start_speed, fastest);
    const double slowest = reached(start_speed, -a, stretch.length);
    if (slowest > end_speed) return ramp(stretch.length, start_speed, end_speed > 0 ? slowest : 0);

    Profile profile;
    double speed = start_speed, length = stretch.length;
    if (speed > stretch.top_speed) {  // asked to slow down
        profile.law.add((speed - stretch.top_speed) / a, speed, -a);
        length -= (speed * speed - stretch.top_speed * stretch.top_speed) / (2 * a);
        speed = stretch.top_speed;
    }
    const double peak = std::sqrt((speed * speed + end_speed * end_speed) / 2 + a * std::max(0.0, length));
    const double top = std::clamp(peak, std::max(speed, end_speed), std::max(speed, stretch.top_speed));
    profile.law.add((top - speed) / a, speed, a);
    if (top < peak) profile.law.add((peak * peak - top * top) / (a * top), top, 0);
    profile.law.add((top - end_speed) / a, top, -a);
    profile.brake_s = (top - end_speed) / a;
    profile.end_speed = end_speed;
    return profile;
}

}  // namespace gsim::motion::linuxcnc
