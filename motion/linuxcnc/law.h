#pragma once

#include <array>
#include <cstddef>

#include "motion/profile/time_law.h"

namespace gsim::motion::linuxcnc {

/// Time law under construction: consecutive parts of constant acceleration or jerk, from 0 on.
class Law {
  public:
    double duration_s() const { return duration_s_; }
    double length() const { return length_; }
    double top_speed() const { return top_speed_; }
    double end_speed() const;
    double end_acceleration() const;

    /// Adds a part. Parts without duration are left out.
    void add(double duration_s, double speed, double acceleration, double jerk = 0);
    void standstill(double duration_s) { add(duration_s, 0, 0); }
    /// Appends the motion of `other`.
    void append(const Law& other);

    /// Returns the distance at a time, or the time at a distance, within the law.
    double at(double t_s) const;
    double time_at(double length) const;
    /// Returns the speed at a time within the law.
    double speed_at(double t_s) const;
    /// Returns the law from one time to another, counted from 0 again.
    Law part(double from_s, double to_s) const;
    /// Returns the law with its lengths multiplied by `scale`.
    TimeLaw scaled(double scale) const;
    /// Returns the law scaled so that it covers `length`.
    Law over(double length) const;
    /// Returns a law over the same distance that stops `earlier_s` earlier.
    Law shortened(double earlier_s) const;

  private:
    std::array<LawSection, TimeLaw::kMaxSections> sections_;  // only the first count_ hold values
    std::size_t count_ = 0;
    double duration_s_ = 0;
    double length_ = 0;
    double top_speed_ = 0;
};

}  // namespace gsim::motion::linuxcnc
