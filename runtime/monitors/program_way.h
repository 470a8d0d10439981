#pragma once

#include <array>
#include <deque>
#include <optional>

#include "motion/path/way_sink.h"
#include "runtime/monitors/part_tip.h"
#include "runtime/monitors/set_point_way.h"

namespace gsim::simulation {

/// Programmed path of the TCP on the part, about the current moves: before a controller rounds its corners or
/// omits points of it.
class ProgramWay : public motion::WaySink {
  public:
    /// Sets `position_joints`, which carry X, Y and Z of arcs (-1: none).
    explicit ProgramWay(const std::array<int, 3>& position_joints) : position_joints_(position_joints) {}

    void programmed(const motion::PathMove& move) override;
    void take_back() override { told_.pop_back(); }
    void forget() override;

    /// Returns true if the controller reports its paths: all others drive them as programmed.
    bool is_told() const { return is_told_; }
    /// Begins a segment of this move, at this time, with a tool at the TCP `tip`. Returns false if its path
    /// was not reported, or turns round and round; what follows then begins again.
    bool drive(rrs::TargetId id, double start_s, const PartTip& tip);
    /// Forgets what was driven before.
    void forget_before(double t_s);
    /// Forgets the complete past: what follows begins again.
    void lose();
    /// Returns the distance of a point from the path, up to the end of the move after the driven one; nullopt
    /// if no path is known.
    std::optional<double> distance_mm(const Eigen::Vector3d& point_mm);

  private:
    struct Driven {
        double start_s;
        rrs::TargetId id;
    };

    void add(const motion::PathMove& move, const PartTip& tip);

    std::array<int, 3> position_joints_;
    std::deque<motion::PathMove> told_;  // that are not driven yet
    bool first_added_ = false;           // the first of them is part of the path
    std::deque<Driven> driven_;          // the last moves; empty: no path is known
    bool is_told_ = false;
    bool begun_ = false;
    SetPointWay way_;  // its times are ids of moves
};

}  // namespace gsim::simulation
