#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "studio/engine/message.h"

namespace gsim::studio {

/// Curves over time, linear between instants, in limited memory for any length of the run. It stores the
/// instants as they come. If those are too many, it stores the minimum and maximum values within steps of
/// equal length, so that no peak is lost.
class Series {
  public:
    static constexpr std::size_t kMaxInstants = 65'536;

    /// Creates a series of so many values at each instant. `max_instants`: an even number, 4 at least.
    explicit Series(std::size_t width, std::size_t max_instants = kMaxInstants)
        : width_(width), max_instants_(max_instants) {}

    /// Adds an instant not before the last one, and not before 0. NaN: no value.
    void add(double t_s, std::span<const float> values);
    bool empty() const { return last_.empty(); }

    /// Adds the series as columns of a message (docs/studio.md).
    void add_columns(Message& message) const;

  private:
    bool is_stepped() const { return step_s_ > 0; }
    std::size_t max_steps() const { return max_instants_ / 2; }
    std::size_t step_at(double t_s) const { return static_cast<std::size_t>(t_s / step_s_); }
    void convert_to_steps();
    void double_step_length();
    void add_segment(double from_s, std::span<const float> from, double to_s, std::span<const float> to);
    void extend_range(std::size_t step, std::span<const float> values);

    std::size_t width_;
    std::size_t max_instants_;
    std::vector<double> t_s_;
    std::vector<float> values_;  ///< Instant by instant.
    double step_s_ = 0;          ///< 0: all instants are here.
    std::vector<float> min_;     ///< Step by step, the first one from 0 on.
    std::vector<float> max_;
    double last_s_ = 0;
    std::vector<float> last_;  ///< The values of the last instant.
};

}  // namespace gsim::studio
