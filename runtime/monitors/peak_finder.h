#pragma once

#include <algorithm>

namespace gsim::simulation {

/// Search for the largest value of a function of time from samples in their order. If a sample is no less
/// than its neighbours and a larger value may lie in between, the range is searched by golden section. This
/// finds a maximum with a corner as well as a smooth one.
class PeakFinder {
  public:
    /// Calls `function(t_s)` only between the last three samples. Returns true for a new largest value.
    template <typename Function>
    bool add(double t_s, double value, const Function& function) {
        const bool is_new_peak = note(t_s, value);
        const bool is_local_peak = count_ >= 2 && last_ >= previous_value_ && last_ > value;
        const bool may_exceed_peak = is_local_peak && 2 * last_ - std::min(previous_value_, value) >
                                                          greatest_ * (1 + kMinRelativeGain);
        bool found = false;
        if (may_exceed_peak) found = search(previous_s_, t_s, function);
        previous_s_ = last_s_;
        previous_value_ = last_;
        last_s_ = t_s;
        last_ = value;
        if (count_ < 2) ++count_;
        return is_new_peak || found;
    }
    /// Marks missing samples: the search skips the range between those before and after.
    void pause() { count_ = 0; }
    bool is_paused() const { return count_ == 0; }
    double max() const { return greatest_; }
    double greatest_s() const { return greatest_s_; }

  private:
    /// Min relative gain of a search: on a circle all samples are peaks, by rounding.
    static constexpr double kMinRelativeGain = 1e-7;
    /// Tolerance for equal peaks, by rounding: the first one counts.
    static constexpr double kTieTolerance = 1e-10;

    bool note(double t_s, double value) {
        if (!(value > greatest_ * (1 + kTieTolerance))) return false;
        greatest_ = value;
        greatest_s_ = t_s;
        return true;
    }

    template <typename Function>
    bool search(double from_s, double to_s, const Function& function) {
        constexpr double kInverseGoldenRatio = 0.6180339887498949;
        constexpr int kParts = 40;
        bool found = false;
        double a_s = to_s - kInverseGoldenRatio * (to_s - from_s),
               b_s = from_s + kInverseGoldenRatio * (to_s - from_s);
        double at_a = function(a_s), at_b = function(b_s);
        for (int i = 0; i < kParts; ++i) {
            found = note(a_s, at_a) || found;
            found = note(b_s, at_b) || found;
            if (at_a > at_b) {
                to_s = b_s;
                b_s = a_s;
                at_b = at_a;
                at_a = function(a_s = to_s - kInverseGoldenRatio * (to_s - from_s));
            } else {
                from_s = a_s;
                a_s = b_s;
                at_a = at_b;
                at_b = function(b_s = from_s + kInverseGoldenRatio * (to_s - from_s));
            }
        }
        return found;
    }

    double greatest_ = 0;
    double greatest_s_ = 0;
    double previous_value_ = 0, previous_s_ = 0;  // the last sample but one
    double last_ = 0, last_s_ = 0;
    int count_ = 0;
};

}  // namespace gsim::simulation
