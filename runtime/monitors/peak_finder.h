#pragma once

#include <algorithm>

namespace gsim::simulation {

/// Search for the largest value of a function of time from samples in their order. If a sample is no less
/// than its neighbours and a larger value may lie in between, the range is searched by golden section. This
/// finds a maximum with a corner as well as a smooth one.
class PeakFinder {
  public:
    /// Calls `value_of(t_s)` only between the last three samples. Returns true for a new largest value.
    template <typename Function>
    bool add(double t_s, double value, const Function& value_of) {
        const bool grew = note(t_s, value);
        const bool is_high = count_ >= 2 && last_ >= before_ && last_ > value;
        const bool may_hide = is_high && 2 * last_ - std::min(before_, value) > greatest_ * (1 + kWorth);
        bool found = false;
        if (may_hide) found = search(before_s_, t_s, value_of);
        before_s_ = last_s_;
        before_ = last_;
        last_s_ = t_s;
        last_ = value;
        if (count_ < 2) ++count_;
        return grew || found;
    }
    /// Marks missing samples: the search skips the range between those before and after.
    void pause() { count_ = 0; }
    bool is_paused() const { return count_ == 0; }
    double greatest() const { return greatest_; }
    double greatest_s() const { return greatest_s_; }

  private:
    /// Min relative gain of a search: on a circle all samples are peaks, by rounding.
    static constexpr double kWorth = 1e-7;
    /// Tolerance for equal peaks, by rounding: the first one counts.
    static constexpr double kTie = 1e-10;

    bool note(double t_s, double value) {
        if (!(value > greatest_ * (1 + kTie))) return false;
        greatest_ = value;
        greatest_s_ = t_s;
        return true;
    }

    template <typename Function>
    bool search(double from_s, double to_s, const Function& value_of) {
        constexpr double kGolden = 0.6180339887498949;
        constexpr int kParts = 40;
        bool found = false;
        double a_s = to_s - kGolden * (to_s - from_s), b_s = from_s + kGolden * (to_s - from_s);
        double at_a = value_of(a_s), at_b = value_of(b_s);
        for (int i = 0; i < kParts; ++i) {
            found = note(a_s, at_a) || found;
            found = note(b_s, at_b) || found;
            if (at_a > at_b) {
                to_s = b_s;
                b_s = a_s;
                at_b = at_a;
                at_a = value_of(a_s = to_s - kGolden * (to_s - from_s));
            } else {
                from_s = a_s;
                a_s = b_s;
                at_a = at_b;
                at_b = value_of(b_s = from_s + kGolden * (to_s - from_s));
            }
        }
        return found;
    }

    double greatest_ = 0;
    double greatest_s_ = 0;
    double before_ = 0, before_s_ = 0;  // the last sample but one
    double last_ = 0, last_s_ = 0;
    int count_ = 0;
};

}  // namespace gsim::simulation
