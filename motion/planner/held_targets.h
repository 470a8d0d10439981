#pragma once

#include <algorithm>
#include <deque>
#include <optional>

#include "controller/services/types.h"

namespace gsim::motion {

/// Targets that have been put, but of which a motion model has yet to put out the motion that reaches them.
class HeldTargets {
  public:
    /// False where the last one has the same id, with which it counts as one.
    bool put(rrs::TargetId id) {
        if (!ids_.empty() && ids_.back() == id) return false;
        ids_.push_back(id);
        return true;
    }
    /// The last one that was put is none.
    void take_back() { ids_.pop_back(); }
    bool has(rrs::TargetId id) const { return std::find(ids_.begin(), ids_.end(), id) != ids_.end(); }
    /// The oldest one.
    std::optional<rrs::TargetId> first() const {
        return ids_.empty() ? std::nullopt : std::optional(ids_.front());
    }
    /// The motion that reaches `id` is known. `passed` is called with each target before it: the model made
    /// no motion of its own for those.
    template <typename Passed>
    void reached(rrs::TargetId id, const Passed& passed) {
        if (!has(id)) return;
        for (; ids_.front() != id; ids_.pop_front()) passed(ids_.front());
        ids_.pop_front();
    }
    /// Nothing is held any more. `passed` as in reached().
    template <typename Passed>
    void all_reached(const Passed& passed) {
        for (; !ids_.empty(); ids_.pop_front()) passed(ids_.front());
    }
    void clear() { ids_.clear(); }

  private:
    std::deque<rrs::TargetId> ids_;
};

}  // namespace gsim::motion
