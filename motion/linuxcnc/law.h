#pragma once

#include <array>
#include <cstddef>

#include "motion/profile/time_law.h"

namespace gsim::motion::linuxcnc {

/// A time law under construction: pieces of constant acceleration or jerk, one after the other, from 0 on.
class Law {
  public:
    double duration_s() const { return duration_s_; }
    double length() const { return length_; }
    double top_speed() const { return top_speed_; }
    double end_speed() const;
    double end_acceleration() const;

    /// Pieces without duration are left out.
    void add(double duration_s, double speed, double acceleration, double jerk = 0);
    void rest(double duration_s) { add(duration_s, 0, 0); }
    /// What `other` does, behind this.
    void append(const Law& other);

    /// Where it is at a time, and when it is somewhere, within the law.
    double at(double t_s) const;
    double time_at(double length) const;
    /// The speed at a time within the law.
    double speed_at(double t_s) const;
    /// The law from one time to another; counted from 0 again.
    Law part(double from_s, double to_s) const;
    /// The law with its lengths multiplied by `scale`.
    TimeLaw scaled(double scale) const;
    /// The same, so that it leads over `length`.
    Law over(double length) const;
    /// The same way, but to rest so much sooner.
    Law sooner(double by_s) const;

  private:
    std::array<LawPiece, TimeLaw::kMaxPieces> pieces_;  // only the first count_ hold values
    std::size_t count_ = 0;
    double duration_s_ = 0;
    double length_ = 0;
    double top_speed_ = 0;
};

}  // namespace gsim::motion::linuxcnc
