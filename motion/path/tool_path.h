#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "motion/path/arc.h"
#include "motion/planner/move.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

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

/// How joints that the inverse holds go in a move: evenly along the way of the tool, each from where it
/// stands to its value. While a coordinated one moves, the way is one on the work, as the machine carries it;
/// the way beside others (synchronous) is what it would be if these stood at their values already.
class LedWay {
  public:
    LedWay() = default;
    LedWay(const PlannerSetup& setup, const rrs::JointPos& start, std::vector<LedJoint> led);

    /// `joints` with those that are led where they are after a share of the way, 0 to 1.
    rrs::JointPos put(double share, const rrs::JointPos& joints) const;
    /// `joints` with synchronous ones at their values: so the tool is seen on its way.
    rrs::JointPos as_seen(const rrs::JointPos& joints) const;
    double turn_rad() const { return turn_rad_; }  ///< Norm of what the rotary ones turn.
    double slide_mm() const { return slide_mm_; }  ///< Of the way of the others.

  private:
    std::vector<LedJoint> led_;
    rrs::JointPos start_;
    double turn_rad_ = 0;
    double slide_mm_ = 0;
};

/// The way of the joints in a move that leads the tip along a TipWay.
class ToolPath {
  public:
    virtual ~ToolPath() = default;

    /// The joints after a share of the way, 0 to 1; of several solutions the one close to `near`. The error
    /// is a sentence.
    virtual tl::expected<rrs::JointPos, std::string> joints_at(double share,
                                                               const rrs::JointPos& near) const = 0;
    /// The tool centre point in the frame in which the way is told: the work frame, but beside synchronous
    /// groups (LedWay).
    virtual rrs::CartPos seen(const rrs::JointPos& joints) const = 0;
    /// What measures the way, and its length: mm of the tip, or rad where the tool turns alone; where it does
    /// neither, of the joints that are led. 0: there is no way.
    JointRole role() const;
    double length() const;
    /// How far the tool turns, and the joints that are led, rad.
    double turn_rad() const { return turn_rad_ + led_.turn_rad(); }
    const TipWay& way() const { return way_; }
    /// The tip in the frame of the tool centre point.
    const Eigen::Vector3d& tip_mm() const { return tip_mm_; }

  protected:
    ToolPath(TipWay way, const Eigen::Vector3d& tip_mm, double turn_rad)
        : way_(std::move(way)), tip_mm_(tip_mm), turn_rad_(turn_rad) {}
    /// Of poses, between which what an inverse leaves is no way.
    ToolPath(TipWay way, const Eigen::Vector3d& tip_mm, double turn_rad, LedWay led)
        : way_(std::move(way)), tip_mm_(tip_mm), turn_rad_(turn_rad), led_(std::move(led)), of_poses_(true) {}
    const LedWay& led() const { return led_; }

  private:
    bool moves_tip() const;
    bool turns_tool() const;

    TipWay way_;
    Eigen::Vector3d tip_mm_;
    double turn_rad_;
    LedWay led_;
    bool of_poses_ = false;
};

/// All joints but the slides x, y, z go in proportion from `start` to `end`, and these bring the tip to its
/// way. `setup` must outlive the path.
std::unique_ptr<ToolPath> tip_path(const PlannerSetup& setup, TipWay way, const Eigen::Vector3d& tip_mm,
                                   const rrs::JointPos& start, const rrs::JointPos& end);

/// A frame of the tool, `tool` in that of the tool centre point, turns evenly about one axis from where it is
/// with the joints at `start` to `end`, a pose in the work frame, while its origin goes along the way and the
/// joints of `led` go theirs. `setup` must outlive the path.
std::unique_ptr<ToolPath> pose_path(const PlannerSetup& setup, TipWay way, const rrs::CartPos& tool,
                                    const rrs::JointPos& start, const rrs::CartPos& end, LedWay led = {});

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
