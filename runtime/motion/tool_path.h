#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/motion/arc.h"
#include "runtime/motion/plan_error.h"
#include "runtime/motion/planner_setup.h"
#include "runtime/motion/segment.h"

namespace gsim::motion {

/// A line or an arc of the tool's tip in the work frame, mm.
struct TipWay {
    SegmentKind kind = SegmentKind::linear;  ///< linear or circular
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    Arc arc = {};  ///< Of a circular way.

    double length_mm() const;
    /// After a share of the way, 0 to 1.
    Eigen::Vector3d at(double share) const;
};

/// The way of the joints in a move that leads the tip along a TipWay.
class ToolPath {
  public:
    virtual ~ToolPath() = default;

    /// The joints after a share of the way, 0 to 1; of several solutions the one close to `near`. The error
    /// is a sentence.
    virtual tl::expected<rrs::JointPos, std::string> joints_at(double share,
                                                               const rrs::JointPos& near) const = 0;
    /// What measures the way, and its length: mm of the tip, or rad where the tool turns alone. 0: there is
    /// no way.
    JointRole role() const { return way_.length_mm() > 0 ? JointRole::position : JointRole::rotary; }
    double length() const { return way_.length_mm() > 0 ? way_.length_mm() : turn_rad_; }
    /// How far the tool turns, rad.
    double turn_rad() const { return turn_rad_; }
    const TipWay& way() const { return way_; }
    /// The tip in the frame of the tool centre point.
    const Eigen::Vector3d& tip_mm() const { return tip_mm_; }

  protected:
    ToolPath(TipWay way, const Eigen::Vector3d& tip_mm, double turn_rad)
        : way_(std::move(way)), tip_mm_(tip_mm), turn_rad_(turn_rad) {}

  private:
    TipWay way_;
    Eigen::Vector3d tip_mm_;
    double turn_rad_;
};

/// All joints but the slides x, y, z go in proportion from `start` to `end`, and these bring the tip to its
/// way. `setup` must outlive the path.
std::unique_ptr<ToolPath> tip_path(const PlannerSetup& setup, TipWay way, const Eigen::Vector3d& tip_mm,
                                   const rrs::JointPos& start, const rrs::JointPos& end);

/// A frame of the tool, `tool` in that of the tool centre point, turns evenly about one axis from where it is
/// with the joints at `start` to `end`, a pose in the work frame, while its origin goes along the way.
/// `setup` must outlive the path.
std::unique_ptr<ToolPath> pose_path(const PlannerSetup& setup, TipWay way, const rrs::CartPos& tool,
                                    const rrs::JointPos& start, const rrs::CartPos& end);

/// `joints` with the values of the slides x, y, z that bring the tip to a point of the work frame; nothing
/// where two slides go the same way, or one is missing.
std::optional<rrs::JointPos> place_tip(const PlannerSetup& setup, const rrs::JointPos& joints,
                                       const Eigen::Vector3d& tip_mm, const Eigen::Vector3d& point_mm);

/// A piece of a path on which the joints go in proportion.
struct PathPiece {
    double share = 0;   ///< Of the whole way.
    rrs::JointPos end;  ///< Where it leads.
    rrs::JointPos
        bend;  ///< Second derivative of the joints by the way, without sign: per length of the path^2.
};

/// Cuts a path from `start` into pieces on which the tip leaves its way by at most tcp_tolerance_mm of the
/// controller, and the tool its orientation by 1e-4 rad, compared at the same share of the way: found by
/// halving, with looks at the quarters of each piece. RRS_NO_SOLUTION where a pose is out of reach, or the
/// joints would have to jump (a singular place on the way), RRS_JOINT_LIMIT, RRS_INVALID_PARAMETER for more
/// than 200,000 pieces. No pieces where there is no way.
tl::expected<std::vector<PathPiece>, PlanError> cut(const ToolPath& path, const PlannerSetup& setup,
                                                    const rrs::JointPos& start);

}  // namespace gsim::motion
