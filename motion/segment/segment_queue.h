#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "motion/segment/segment.h"

namespace gsim::motion {

/// Segments in the order of time, in slots that are made once and reused: a segment is planned in its final
/// slot, without copies or allocations.
class SegmentQueue {
  public:
    explicit SegmentQueue(std::size_t capacity) : slots_(capacity) {}

    bool empty() const { return count_ == 0; }
    /// Returns how many more segments fit.
    std::size_t free_slots() const { return slots_.size() - count_; }
    const Segment& front() const { return slots_[first_]; }
    std::size_t size() const { return count_; }
    /// Returns a segment by its order, 0 at the front.
    const Segment& operator[](std::size_t index) const { return slots_[(first_ + index) % slots_.size()]; }

    /// Returns the free slot past the last segment, with its previous content; push() makes it part of the
    /// queue. The queue grows if it is full.
    Segment& next() {
        if (free_slots() == 0) grow();
        const std::size_t index = first_ + count_;
        return slots_[index < slots_.size() ? index : index - slots_.size()];
    }
    void push() { ++count_; }
    void pop() {
        first_ = first_ + 1 < slots_.size() ? first_ + 1 : 0;
        --count_;
    }
    void clear() { count_ = 0; }

  private:
    void grow() {
        std::vector<Segment> more;
        more.reserve(2 * slots_.size());
        for (std::size_t i = 0; i < count_; ++i)
            more.push_back(std::move(slots_[(first_ + i) % slots_.size()]));
        more.resize(2 * slots_.size());
        slots_ = std::move(more);
        first_ = 0;
    }

    std::vector<Segment> slots_;
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}  // namespace gsim::motion
