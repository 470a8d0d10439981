#pragma once

#include <span>
#include <vector>

namespace gsim::motion {

/// Motion of a joint past an end of its range (mm or rad).
struct Overtravel {
    int joint = 0;
    double value = 0;  ///< Farthest value reached.
    double limit = 0;  ///< The end of its range.

    double excess() const { return value < limit ? limit - value : value - limit; }
};

/// Setting for targets past the joint ranges: they are rejected, which is the rule, or planned all the same.
/// Targets that are planned all the same are noted here.
class OvertravelLog {
  public:
    /// Plans and notes such targets from now on; earlier notes are dropped.
    void allow_overtravel() {
        accepts_excursions_ = true;
        overtravels_.clear();
    }
    /// Rejects such targets again.
    void forbid_overtravel() { accepts_excursions_ = false; }
    bool accepts_excursions() const { return accepts_excursions_; }

    /// Keeps one entry for each end of a joint's range: the farthest.
    void note(const Overtravel& overtravel);
    std::span<const Overtravel> overtravels() const { return overtravels_; }

  private:
    bool accepts_excursions_ = false;
    std::vector<Overtravel> overtravels_;
};

/// Guard that lets targets past the joint ranges pass during its lifetime.
class OvertravelPermit {
  public:
    /// Null has no effect.
    explicit OvertravelPermit(OvertravelLog* notes) : notes_(notes) {
        if (notes_ != nullptr) notes_->allow_overtravel();
    }
    ~OvertravelPermit() {
        if (notes_ != nullptr) notes_->forbid_overtravel();
    }
    OvertravelPermit(const OvertravelPermit&) = delete;
    OvertravelPermit& operator=(const OvertravelPermit&) = delete;

  private:
    OvertravelLog* notes_;
};

}  // namespace gsim::motion
