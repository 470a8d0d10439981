#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "cam/linking/path_search.h"
#include "collision/monitor/collision_checker.h"
#include "motion/planner/planner_setup.h"

namespace gsim::linking {

/// Position of a program's origin, by axis letter, mm or deg: a work offset.
using Origin = std::map<char, double>;

/// Returns the machine coordinates of the axes minus those of a program with that origin.
AxisValues axis_shift(const Origin& origin, const machine::Machine& machine);

/// Rapids of a machine between the bodies of its cell. Axis values are machine coordinates.
class RapidPlanner {
  public:
    /// The arguments must outlive this object; `setup` is the machine for its planner. Without
    /// `allows_rotation` the tool keeps its orientation on searched paths.
    RapidPlanner(const path::MachineSpace& machine, const motion::PlannerSetup& setup,
                 const cell::CollisionChecker& bodies, Origin origin, bool allows_rotation)
        : machine_(&machine),
          setup_(&setup),
          bodies_(&bodies),
          origin_(std::move(origin)),
          allows_rotation_(allows_rotation) {}

    const path::MachineSpace& machine() const { return *machine_; }
    const cell::Cell& cell() const { return bodies_->cell(); }

    /// Returns a move that is straight in the axes, at constant speed.
    motion::Segment straight_segment(const AxisValues& from, const AxisValues& to) const;
    /// Returns a rapid from standstill to standstill as the controller makes it: axes in proportion, or each
    /// axis independently.
    motion::Segment rapid(const AxisValues& from, const AxisValues& to) const;
    std::optional<cell::Obstacle> obstacle(const AxisValues& from, const AxisValues& to,
                                           double clearance_mm) const;
    std::optional<cell::Obstacle> obstacle_at(const AxisValues& axes, double clearance_mm) const;
    const Origin& origin() const { return origin_; }
    /// Returns axis values in program coordinates.
    AxisValues in_program(const AxisValues& axes) const {
        return axes - axis_shift(origin_, machine_->machine());
    }
    /// Returns the position of the TCP in program coordinates.
    Eigen::Vector3d tcp_mm(const AxisValues& axes) const { return machine_->tcp(in_program(axes)); }
    /// Returns "(1, 2, 3): 'nozzle' touches 'clamp'": the position of the TCP, and the contact.
    std::string collision_text(const AxisValues& axes, const cell::ItemPair& items) const;

    /// Returns a path between the positions that keeps this clearance to all bodies: straight, or up, over
    /// and down as low as possible, or as search_path() finds it. Both positions must have this clearance.
    std::optional<AxisPath> find(const AxisValues& from, const AxisValues& to, double clearance_mm) const;

  private:
    SearchSpace space(const AxisValues& from, const AxisValues& to, double clearance_mm) const;
    std::optional<AxisPath> lifted(const SearchSpace& space, const AxisValues& from,
                                   const AxisValues& to) const;

    const path::MachineSpace* machine_;
    const motion::PlannerSetup* setup_;
    const cell::CollisionChecker* bodies_;
    Origin origin_;
    bool allows_rotation_;
};

}  // namespace gsim::linking
