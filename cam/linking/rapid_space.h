#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "cam/linking/way_search.h"
#include "collision/monitor/clear_way.h"
#include "motion/planner/planner_setup.h"

namespace gsim::transit {

/// Where the origin of a program lies, by axis letter, mm or deg: a work offset.
using Origin = std::map<char, double>;

/// What machine coordinates of the axes are more than those of a program with that origin.
AxisValues shift_of(const Origin& origin, const machine::Machine& machine);

/// Rapids of a machine among the bodies of its cell. Axis values are machine coordinates.
class RapidSpace {
  public:
    /// What is given must outlive this; `setup` is the machine for its planner. Without `turns` the tool
    /// stays as it stands on ways that are searched.
    RapidSpace(const path::MachineSpace& machine, const motion::PlannerSetup& setup,
               const cell::ClearWay& bodies, Origin origin, bool turns)
        : machine_(&machine), setup_(&setup), bodies_(&bodies), origin_(std::move(origin)), turns_(turns) {}

    const path::MachineSpace& machine() const { return *machine_; }
    const cell::Cell& cell() const { return bodies_->cell(); }

    /// Straight in the axes, at an even pace.
    motion::Segment straight(const AxisValues& from, const AxisValues& to) const;
    /// A rapid from rest to rest as the controller makes it: in proportion, or each axis by itself.
    motion::Segment rapid(const AxisValues& from, const AxisValues& to) const;
    std::optional<cell::Obstacle> obstacle(const AxisValues& from, const AxisValues& to,
                                           double clearance_mm) const;
    std::optional<cell::Obstacle> obstacle_at(const AxisValues& axes, double clearance_mm) const;
    const Origin& origin() const { return origin_; }
    /// As programs give them.
    AxisValues in_program(const AxisValues& axes) const {
        return axes - shift_of(origin_, machine_->machine());
    }
    /// Where the tip of the tool is, as programs give it.
    Eigen::Vector3d tip_mm(const AxisValues& axes) const { return machine_->tip(in_program(axes)); }
    /// "(1, 2, 3): 'nozzle' touches 'clamp'": where the tip is, and what else.
    std::string told(const AxisValues& axes, const cell::ItemPair& items) const;

    /// A way from one place to the other that keeps so far away from all bodies: straight, or up, over and
    /// down, as low as it goes, or as search_way() finds it. Both places have to be that far away.
    std::optional<Way> find(const AxisValues& from, const AxisValues& to, double clearance_mm) const;

  private:
    WaySpace space(const AxisValues& from, const AxisValues& to, double clearance_mm) const;
    std::optional<Way> over(const WaySpace& space, const AxisValues& from, const AxisValues& to) const;

    const path::MachineSpace* machine_;
    const motion::PlannerSetup* setup_;
    const cell::ClearWay* bodies_;
    Origin origin_;
    bool turns_;
};

}  // namespace gsim::transit
