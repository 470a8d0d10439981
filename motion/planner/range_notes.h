#pragma once

#include <span>
#include <vector>

namespace gsim::motion {

/// Motion of a joint past an end of its range (mm or rad).
struct Excursion {
    int joint = 0;
    double value = 0;  ///< Farthest value reached.
    double limit = 0;  ///< The end of its range.

    double beyond() const { return value < limit ? limit - value : value - limit; }
};

/// Setting for targets past the joint ranges: they are rejected, which is the rule, or planned all the same.
/// Targets that are planned all the same are noted here.
class RangeNotes {
  public:
    /// Plans and notes such targets from now on; earlier notes are dropped.
    void let_pass() {
        passing_ = true;
        excursions_.clear();
    }
    /// Rejects such targets again.
    void hold() { passing_ = false; }
    bool passing() const { return passing_; }

    /// Keeps one entry for each end of a joint's range: the farthest.
    void note(const Excursion& excursion);
    std::span<const Excursion> excursions() const { return excursions_; }

  private:
    bool passing_ = false;
    std::vector<Excursion> excursions_;
};

/// Guard that lets targets past the joint ranges pass during its lifetime.
class RangePass {
  public:
    /// Null has no effect.
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
