#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/outputs/path_style.h"

namespace gsim::simulation {

/// Speed or acceleration (mm/s, mm/s2) at an instant of a rapid, or of another move with the process on or
/// off.
struct TimePoint {
    double t_s = 0;
    double value = 0;
    PathStyle style = PathStyle::feed;
};

/// Lowest and highest of many samples in slots of time, which grow with the length of the run. So a curve of
/// few points shows every peak.
class TimeBuckets {
  public:
    static constexpr std::size_t kMaxBuckets = 4096;

    /// Adds a sample; they come in the order of time.
    void add(const TimePoint& point);
    /// Returns at most six points for each slot, in the order of time.
    std::vector<TimePoint> points() const;
    /// Returns the current width of a slot.
    double width_s() const { return width_s_; }

  private:
    // Point with the number of its sample, because the end of a move and the start of the next share an
    // instant.
    struct NumberedPoint {
        TimePoint point;
        std::uint64_t number;
    };
    struct Extremes {
        NumberedPoint low;
        NumberedPoint high;
    };
    using Bucket = std::array<std::optional<Extremes>, 3>;  // by style

    static void merge(std::optional<Extremes>& into, const NumberedPoint& sample);
    void halve();

    double width_s_ = 1e-3;
    std::vector<Bucket> buckets_;
    std::uint64_t count_ = 0;
};

}  // namespace gsim::simulation
