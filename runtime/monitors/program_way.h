#pragma once

#include <array>
#include <deque>
#include <optional>

#include "motion/path/way_sink.h"
#include "runtime/monitors/part_tip.h"
#include "runtime/monitors/set_point_way.h"

namespace gsim::simulation {

/// The way of the tip on the part that the program asks for, about the moves under way: before a controller
/// rounds its corners or leaves points of it out.
class ProgramWay : public motion::WaySink {
  public:
    /// `position_joints` carry X, Y and Z of arcs (-1: none).
    explicit ProgramWay(const std::array<int, 3>& position_joints) : position_joints_(position_joints) {}

    void programmed(const motion::PathMove& move) override;
    void take_back() override { told_.pop_back(); }
    void forget() override;

    /// Whether the controller is one whose ways are told: all others drive them as they are programmed.
    bool is_told() const { return is_told_; }
    /// A segment of this move begins, at this time, with a tool whose tip is told. False: nobody has told its
    /// way, or it turns round and round, and what follows begins anew.
    bool drive(rrs::TargetId id, double start_s, const PartTip& tip);
    /// What was driven before is forgotten.
    void forget_before(double t_s);
    /// Forgets all that is behind: what follows begins anew.
    void lose();
    /// How far a point is from the way up to the end of the move behind the one that is driven; none where no
    /// way is known.
    std::optional<double> distance_mm(const Eigen::Vector3d& point_mm);

  private:
    struct Driven {
        double start_s;
        rrs::TargetId id;
    };

    void add(const motion::PathMove& move, const PartTip& tip);

    std::array<int, 3> position_joints_;
    std::deque<motion::PathMove> told_;  // that are not driven yet
    bool first_added_ = false;           // the first of them is part of the way
    std::deque<Driven> driven_;          // the last moves; none: no way is known
    bool is_told_ = false;
    bool begun_ = false;
    SetPointWay way_;  // its times are ids of moves
};

}  // namespace gsim::simulation
