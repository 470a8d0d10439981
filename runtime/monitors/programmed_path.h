#pragma once

#include <array>
#include <deque>
#include <optional>

#include "motion/path/path_sink.h"
#include "runtime/monitors/set_point_path.h"
#include "runtime/monitors/workpiece_tcp.h"

namespace gsim::simulation {

/// Programmed path of the TCP on the part, about the current moves: before a controller rounds its corners or
/// omits points of it.
class ProgrammedPath : public motion::PathSink {
  public:
    /// Sets `position_joints`, which carry X, Y and Z of arcs (-1: none).
    explicit ProgrammedPath(const std::array<int, 3>& position_joints) : position_joints_(position_joints) {}

    void on_programmed_move(const motion::PathMove& move) override;
    void discard_last_move() override { reported_moves_.pop_back(); }
    void forget() override;

    /// Returns true if the controller reports its paths: all others drive them as programmed.
    bool is_reported() const { return is_reported_; }
    /// Begins a segment of this move, at this time, with a tool at the TCP `tcp`. Returns false if its path
    /// was not reported, or turns round and round; what follows then begins again.
    bool drive(rrs::TargetId id, double start_s, const WorkpieceTcp& tcp);
    /// Forgets what was driven before.
    void discard_before(double t_s);
    /// Forgets the complete past: what follows begins again.
    void mark_lost();
    /// Returns the distance of a point from the path, up to the end of the move that follows the driven one;
    /// nullopt if no path is known.
    std::optional<double> distance_mm(const Eigen::Vector3d& point_mm);

  private:
    struct ExecutedMove {
        double start_s;
        rrs::TargetId id;
    };

    void add(const motion::PathMove& move, const WorkpieceTcp& tcp);

    std::array<int, 3> position_joints_;
    std::deque<motion::PathMove> reported_moves_;  // that are not driven yet
    bool first_added_ = false;                     // the first of them is part of the path
    std::deque<ExecutedMove> executed_moves_;      // the last moves; empty: no path is known
    bool is_reported_ = false;
    bool begun_ = false;
    SetPointPath path_;  // its times are ids of moves
};

}  // namespace gsim::simulation
