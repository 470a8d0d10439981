#include "motion/linuxcnc/profile.h"

#include <algorithm>
#include <cmath>

#include "motion/profile/law_cut.h"
#include "motion/profile/ramp.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kShortfallRounding = 1e-9;  // a shortfall that is rounding

// Unit of speed in mm/s for one period of acceleration, and unit of length in mm for one period of that
// speed. The acceleration is 1 in these units, and a period takes 1.
struct Units {
    double time;
    double speed;
    double length;
    double acceleration;
};

Units units_of(const Stretch& section, double period_s) {
    const double speed = section.acceleration * period_s;
    return {period_s, speed, speed * period_s, section.acceleration};
}

// Returns the speed at the end of the next period from which the remaining distance suffices to brake.
double max_braking_speed(double speed, double distance) {
    return std::sqrt(std::max(0.0, 2 * distance - speed + 0.25)) - 0.5;
}

// Builder of a law, period by period, in Units.
class PeriodProfileBuilder {
  public:
    PeriodProfileBuilder(double distance, const Units& units) : remaining_(distance), units_(units) {}

    double speed() const { return speed_; }
    double distance() const { return remaining_; }

    void ramp_up(double periods) {
        add(periods, 1);
        remaining_ -= periods * periods / 2;
        speed_ = periods;
    }
    void ramp_to(double speed) {
        add(1, speed - speed_);
        remaining_ -= (speed_ + speed) / 2;
        speed_ = speed;
    }
    void cruise(double periods) {
        add(periods, 0);
        remaining_ -= periods * speed_;
    }
    // Returns the number of periods of full braking, which end within a period.
    double brake_to_stop() {
        const double from = max_braking_speed(speed_, remaining_);
        if (from < 0) return stop_within_period();
        ramp_to(from);
        add(from, -1);
        add_standstill(std::ceil(from - kPeriodTolerance) - from);
        return from;
    }
    const Law& law() const { return law_; }

  private:
    void add(double periods, double acceleration) {
        law_.add(periods * units_.time, speed_ * units_.speed, acceleration * units_.acceleration);
    }
    void add_standstill(double periods) { law_.standstill(periods * units_.time); }
    double stop_within_period() {
        const double periods = speed_ > 0 ? std::clamp(2 * remaining_ / speed_, 0.0, 1.0) : 0;
        if (periods > 0) add(periods, -speed_ / periods);
        add_standstill(1 - periods);
        return 0;
    }

    Law law_;
    double speed_ = 0;
    double remaining_;
    Units units_;
};

Profile whole_period_profile(const Stretch& section, double period_s) {
    const Units units = units_of(section, period_s);
    const double top = section.top_speed / units.speed;
    PeriodProfileBuilder builder(section.length / units.length, units);
    builder.ramp_up(std::min(std::floor(std::sqrt(builder.distance()) + kPeriodTolerance),
                             std::floor(top + kPeriodTolerance)));
    if (max_braking_speed(builder.speed(), builder.distance()) >= top) {
        if (top > builder.speed() + kPeriodTolerance) builder.ramp_to(top);
        builder.cruise(
            std::max(0.0, std::floor((builder.distance() - top * top / 2) / top + kPeriodTolerance)));
    }
    const double braking_periods = builder.brake_to_stop();
    return {builder.law(), braking_periods * period_s, 0};
}

double reached(double start_speed, double signed_acceleration, double length) {
    return std::sqrt(std::max(0.0, start_speed * start_speed + 2 * signed_acceleration * length));
}

LawLimits limits_of(const Stretch& section) {
    return {section.top_speed, section.acceleration, section.acceleration, section.jerk};
}

Law make_law(const TimeLaw& time_law) {
    Law law;
    for (const LawSection& section : time_law.sections())
        law.add(section.duration_s, section.v0, section.a0, section.jerk);
    return law;
}

// True if a ramp from one speed to the other exists with acceleration 0 at both ends.
bool has_curve(const Stretch& section, double start_speed, double end_speed) {
    return std::isfinite(section.jerk) &&
           ramp_length(start_speed, end_speed, section.acceleration, section.jerk) <=
               section.length * (1 + kShortfallRounding);
}

Profile curve(const Stretch& section, double start_speed, double end_speed) {
    const TimeLaw law = TimeLaw::between(section.length, start_speed, end_speed, limits_of(section));
    const double peak = std::min(law.peak_speed(), std::max(section.top_speed, end_speed));
    return {make_law(law), ramp_s(peak, end_speed, section.acceleration, section.jerk), end_speed};
}

}  // namespace

double peak_speed(double length, double acceleration, double jerk) {
    return ramp_end_speed(length / 2, 0, acceleration, jerk);
}

Profile rest_to_rest(const Stretch& section, const Clock& clock) {
    return clock.counts ? whole_period_profile(section, clock.period_s) : from_speed_to_speed(section, 0, 0);
}

Profile ramp(double length, double start_speed, double end_speed) {
    Profile profile;
    const double duration_s = 2 * length / (start_speed + end_speed);
    profile.law.add(duration_s, start_speed, (end_speed - start_speed) / duration_s);
    profile.braking_time_s = end_speed < start_speed ? duration_s : 0;
    profile.end_speed = end_speed;
    return profile;
}

Profile append_profile(const Law& before, const Profile& profile) {
    Profile full_profile = profile;
    full_profile.law = before;
    full_profile.law.append(profile.law);
    return full_profile;
}

Law acceleration_ramp_down(double speed, double acceleration, double jerk) {
    Law law;
    law.add(std::abs(acceleration) / jerk, speed, acceleration, acceleration > 0 ? -jerk : jerk);
    return law;
}

Profile braking(const Stretch& section, double start_speed, double end_speed) {
    const TimeLaw law = braking_law(section.length, start_speed, end_speed, limits_of(section));
    return {make_law(law), law.duration_s(), law.end_speed()};
}

double time_below_speed_s(const Profile& profile, double speed) {
    constexpr int kSteps = 50;
    const double end_s = profile.law.duration_s();
    double fast = end_s - profile.braking_time_s, slow = end_s;
    for (int i = 0; i < kSteps; ++i) {
        const double middle = (fast + slow) / 2;
        (profile.law.speed_at(middle) < speed ? slow : fast) = middle;
    }
    return end_s - slow;
}

Profile from_speed_to_speed(const Stretch& section, double start_speed, double end_speed) {
    if (has_curve(section, start_speed, end_speed)) return curve(section, start_speed, end_speed);
    const double a = section.acceleration;
    const double fastest = reached(start_speed, a, section.length);
    if (fastest <= end_speed) return ramp(section.length, start_speed, fastest);
    const double slowest = reached(start_speed, -a, section.length);
    if (slowest > end_speed) return ramp(section.length, start_speed, end_speed > 0 ? slowest : 0);

    Profile profile;
    double speed = start_speed, length = section.length;
    if (speed > section.top_speed) {  // asked to slow down
        profile.law.add((speed - section.top_speed) / a, speed, -a);
        length -= (speed * speed - section.top_speed * section.top_speed) / (2 * a);
        speed = section.top_speed;
    }
    const double peak = std::sqrt((speed * speed + end_speed * end_speed) / 2 + a * std::max(0.0, length));
    const double top = std::clamp(peak, std::max(speed, end_speed), std::max(speed, section.top_speed));
    profile.law.add((top - speed) / a, speed, a);
    if (top < peak) profile.law.add((peak * peak - top * top) / (a * top), top, 0);
    profile.law.add((top - end_speed) / a, top, -a);
    profile.braking_time_s = (top - end_speed) / a;
    profile.end_speed = end_speed;
    return profile;
}

}  // namespace gsim::motion::linuxcnc
