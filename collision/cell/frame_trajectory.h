#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "controller/services/types.h"

namespace gsim::cell {

/// Independent motion of a frame from a time on: its origin moves straight and evenly, and the frame turns
/// evenly about an axis through its origin. All values are in the frame in which it moves.
struct UniformMotion {
    double from_s = 0;
    rrs::CartPos pose = rrs::CartPos::Identity();  ///< At from_s.
    Eigen::Vector3d velocity_mm_s = Eigen::Vector3d::Zero();
    Eigen::Vector3d angular_velocity_rad_s = Eigen::Vector3d::Zero();  ///< Along the axis of the turn.

    rrs::CartPos at(double time_s) const;
    bool moves() const;
};

/// Returns the motion from one pose to another in that time, by the shorter rotation.
UniformMotion uniform_motion_between(const rrs::CartPos& from, const rrs::CartPos& to, double from_s,
                                     double to_s);

/// Motion of an independent frame over a run: a sequence of drifts. It may jump from one to the next.
class FrameTrajectory {
  public:
    explicit FrameTrajectory(const rrs::CartPos& pose) : motions_{UniformMotion{.pose = pose}} {}

    /// Adds a drift, which holds from drift.from_s on; others from there on are dropped.
    void add(const UniformMotion& uniform_motion);
    const UniformMotion& uniform_motion_at(double time_s) const;
    rrs::CartPos at(double time_s) const;
    /// Returns the first change after a time.
    std::optional<double> next_change_s(double time_s) const;
    /// Drops what was before that time, which will not be queried again.
    void discard_before(double time_s);

  private:
    std::deque<UniformMotion> motions_;  ///< In the order of time, one at least.
};

/// Frame of a FrameTree that moves independently in the frame to which it is attached.
struct MovingFrame {
    std::size_t frame;
    bool conveyor;  ///< Moved by a conveyor, not by the program.
    FrameTrajectory trajectory;
};

/// Link that drifts in another one, in a part of a run without a change.
struct MovingLink {
    int parent;          ///< Number of the other link.
    rrs::CartPos mount;  ///< In that link the frame in which it drifts.
    UniformMotion uniform_motion;
};

}  // namespace gsim::cell
