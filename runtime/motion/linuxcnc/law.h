#pragma once

#include <array>
#include <cstddef>

#include "runtime/motion/time_law.h"

namespace gsim::motion::linuxcnc {

/// A time law under construction: pieces of constant acceleration, one after the other, from 0 on.
class Law {
  public:
    double duration_s() const { return duration_s_; }
    double length() const { return length_; }
    double top_speed() const { return top_speed_; }

    /// Pieces without duration are left out.
    void add(double duration_s, double speed, double acceleration);
    void rest(double duration_s) { add(duration_s, 0, 0); }

    /// Where it is at a time, and when it is somewhere, within the law.
    double at(double t_s) const;
    double time_at(double length) const;
    /// The speed at a time within the law.
    double speed_at(double t_s) const;
    /// The law from one time to another; counted from 0 again.
    Law part(double from_s, double to_s) const;
    /// A rest, and then this law.
    Law behind_rest(double rest_s) const;
    /// The law with its lengths multiplied by `scale`.
    TimeLaw scaled(double scale) const;

  private:
    std::array<LawPiece, TimeLaw::kMaxPieces> pieces_;  // only the first count_ hold values
    std::size_t count_ = 0;
    double duration_s_ = 0;
    double length_ = 0;
    double top_speed_ = 0;
};

}  // namespace gsim::motion::linuxcnc
