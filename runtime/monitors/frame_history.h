#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "collision/cell/cell.h"

namespace gsim::simulation {

/// Motion or standstill of a frame of a cell, from a time on.
struct FrameMotion {
    std::size_t frame;
    cell::UniformMotion uniform_motion;
};

/// Motions of the frames of a cell during a run, if they are recorded.
class FrameHistory {
  public:
    /// Max number of entries; beyond it the history is incomplete.
    static constexpr std::size_t kMaxEntries = 100'000;

    void start() { is_recording_ = true; }
    bool is_recording() const { return is_recording_; }
    void add(std::size_t frame, const cell::UniformMotion& uniform_motion) {
        if (!is_recording_) return;
        if (entries_.size() < kMaxEntries)
            entries_.push_back({frame, uniform_motion});
        else
            is_complete_ = false;
    }

    bool is_complete() const { return is_complete_; }
    /// Returns entries in the order of their reports, which is that of time for each frame. From `from_s` of
    /// an entry on earlier ones of its frame no longer hold.
    std::span<const FrameMotion> entries() const { return entries_; }

  private:
    bool is_recording_ = false;
    bool is_complete_ = true;
    std::vector<FrameMotion> entries_;
};

}  // namespace gsim::simulation
