#pragma once

#include <algorithm>
#include <deque>
#include <optional>

#include "controller/services/types.h"

namespace gsim::motion {

/// Enqueued targets for which a motion model has not yet output the motion that reaches them.
class PendingTargets {
  public:
    /// Adds a target. Returns false if the last one has the same id, with which it counts as one.
    bool enqueue(rrs::TargetId id) {
        if (!ids_.empty() && ids_.back() == id) return false;
        ids_.push_back(id);
        return true;
    }
    /// Removes the last target that was added.
    void discard_last_move() { ids_.pop_back(); }
    bool has(rrs::TargetId id) const { return std::find(ids_.begin(), ids_.end(), id) != ids_.end(); }
    /// Returns the oldest target.
    std::optional<rrs::TargetId> first() const {
        return ids_.empty() ? std::nullopt : std::optional(ids_.front());
    }
    /// Notes that the motion that reaches `id` is known. Calls `on_passed` with each target before it, for
    /// which the model made no motion.
    template <typename Passed>
    void reached(rrs::TargetId id, const Passed& on_passed) {
        if (!has(id)) return;
        for (; ids_.front() != id; ids_.pop_front()) on_passed(ids_.front());
        ids_.pop_front();
    }
    /// Removes all targets. `on_passed` as in reached().
    template <typename Passed>
    void mark_all_reached(const Passed& on_passed) {
        for (; !ids_.empty(); ids_.pop_front()) on_passed(ids_.front());
    }
    void clear() { ids_.clear(); }

  private:
    std::deque<rrs::TargetId> ids_;
};

}  // namespace gsim::motion
