#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "controller/services/types.h"

namespace gsim::cell {

/// How a frame goes by itself from a time on: its origin straight and evenly, and the frame turns evenly
/// about an axis through its origin. All in the frame in which it goes.
struct Drift {
    double from_s = 0;
    rrs::CartPos pose = rrs::CartPos::Identity();  ///< At from_s.
    Eigen::Vector3d velocity_mm_s = Eigen::Vector3d::Zero();
    Eigen::Vector3d spin_rad_s = Eigen::Vector3d::Zero();  ///< Along the axis of the turn.

    rrs::CartPos at(double time_s) const;
    bool moves() const;
};

/// The motion that leads from one pose to another in that time, the short way round.
Drift drift_between(const rrs::CartPos& from, const rrs::CartPos& to, double from_s, double to_s);

/// The motion of a frame that goes by itself over a run: one drift behind the other. From one to the next it
/// may jump.
class Carrier {
  public:
    explicit Carrier(const rrs::CartPos& pose) : drifts_{Drift{.pose = pose}} {}

    /// From drift.from_s on this one holds; others from there on are dropped.
    void add(const Drift& drift);
    const Drift& drift_at(double time_s) const;
    rrs::CartPos at(double time_s) const;
    /// The first change behind a time.
    std::optional<double> next_change_s(double time_s) const;
    /// What was before that time will not be asked for again.
    void forget_before(double time_s);

  private:
    std::deque<Drift> drifts_;  ///< In the order of time, one at least.
};

/// A frame of a FrameTree that goes by itself in the frame to which it is attached.
struct CarriedFrame {
    std::size_t frame;
    bool conveyor;  ///< Moved by a conveyor, not by the program.
    Carrier carrier;
};

/// A link that drifts in another one, in a part of a run without a change.
struct DriftingLink {
    int parent;          ///< Number of the other link.
    rrs::CartPos mount;  ///< In that link the frame in which it drifts.
    Drift drift;
};

}  // namespace gsim::cell
