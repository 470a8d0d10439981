#pragma once

#include <algorithm>

namespace gsim::cell {

/// Pauses between searches that find nothing: each lasts twice as many requests as the one before, up to a
/// max.
class SearchBackoff {
  public:
    explicit SearchBackoff(int max_pause) : max_pause_(max_pause) {}

    /// Returns true if the pause is over; then the next one begins.
    bool is_due() {
        if (remaining_-- > 0) return false;
        remaining_ = next_;
        next_ = std::min(2 * next_, max_pause_);
        return true;
    }
    /// Ends the pause, because a search has found something.
    void reset() {
        remaining_ = 0;
        next_ = 1;
    }

  private:
    int max_pause_;
    int remaining_ = 0;
    int next_ = 1;
};

}  // namespace gsim::cell
