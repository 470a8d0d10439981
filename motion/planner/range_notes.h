#pragma once

#include <span>
#include <vector>

namespace gsim::motion {

/// A joint is taken past an end of its range (mm or rad).
struct Excursion {
    int joint = 0;
    double value = 0;  ///< The farthest that it goes.
    double limit = 0;  ///< The end of its range.

    double beyond() const { return value < limit ? limit - value : value - limit; }
};

/// Whether targets past the ranges of joints are refused, which is the rule, or planned all the same. What is
/// planned all the same is noted here.
class RangeNotes {
  public:
    /// From now on such targets are planned, and noted; what was noted before is forgotten.
    void let_pass() {
        passing_ = true;
        excursions_.clear();
    }
    /// Such targets are refused again.
    void hold() { passing_ = false; }
    bool passing() const { return passing_; }

    /// One entry for each end of a joint's range: the farthest.
    void note(const Excursion& excursion);
    std::span<const Excursion> excursions() const { return excursions_; }

  private:
    bool passing_ = false;
    std::vector<Excursion> excursions_;
};

/// Lets targets past the ranges of joints pass for as long as it lives.
class RangePass {
  public:
    /// Null: it changes nothing.
    explicit RangePass(RangeNotes* notes) : notes_(notes) {
        if (notes_ != nullptr) notes_->let_pass();
    }
    ~RangePass() {
        if (notes_ != nullptr) notes_->hold();
    }
    RangePass(const RangePass&) = delete;
    RangePass& operator=(const RangePass&) = delete;

  private:
    RangeNotes* notes_;
};

}  // namespace gsim::motion
