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

/// Line or arc of the controlled point in the work frame, mm.
struct TcpPath {
    SegmentKind kind = SegmentKind::linear;  ///< linear or circular
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    Arc arc = {};  ///< Only for a circular path.

    double length_mm() const;
    /// Returns the point at a share of the path, 0 to 1.
    Eigen::Vector3d at(double share) const;
};

/// Motion of the joints that the inverse holds (`group_joints`) in a move: evenly along the tool path, each
/// from its position to its value. The path is one on the work, as the machine carries it, while a
/// coordinated one moves. The path with other (synchronous) ones is as if these were at their values already.
class GroupPath {
  public:
    GroupPath() = default;
    GroupPath(const PlannerSetup& setup, const rrs::JointPos& start, std::vector<GroupJoint> group_joints);

    /// Returns `joints` with the group joints at their positions at a share of the path, 0 to 1.
    rrs::JointPos set_coordinated(double share, const rrs::JointPos& joints) const;
    /// Returns `joints` with synchronous ones at their values: the tool is seen on its path with these.
    rrs::JointPos with_synchronous_joints(const rrs::JointPos& joints) const;
    double turn_rad() const { return turn_rad_; }                    ///< Norm of what the rotary ones turn.
    double slide_distance_mm() const { return slide_distance_mm_; }  ///< Norm of the others' paths.

  private:
    std::vector<GroupJoint> group_joints_;
    rrs::JointPos start_;
    double turn_rad_ = 0;
    double slide_distance_mm_ = 0;
};

/// Path of the joints in a move of the controlled point along a TcpPath.
class ToolPath {
  public:
    virtual ~ToolPath() = default;

    /// Returns the joints at a share of the path, 0 to 1; of several solutions the one close to `near`. The
    /// error is a message.
    virtual tl::expected<rrs::JointPos, std::string> joints_at(double share,
                                                               const rrs::JointPos& near) const = 0;
    /// Returns the TCP in the frame in which the path is given: the work frame, except with synchronous
    /// groups (GroupPath).
    virtual rrs::CartPos tool_pose(const rrs::JointPos& joints) const = 0;
    /// Returns the measure of the path, or its length: mm of the controlled point, or rad if only the tool
    /// turns. The group joints give it if neither moves. A length of 0 means that no path exists.
    JointRole role() const;
    double length() const;
    /// Returns how far the tool turns, and the group joints, rad.
    double turn_rad() const { return turn_rad_ + group_joints_.turn_rad(); }
    const TcpPath& tcp_path() const { return tcp_path_; }
    /// Returns the controlled point in the frame of the tool centre point.
    const Eigen::Vector3d& tcp_mm() const { return tcp_mm_; }

  protected:
    ToolPath(TcpPath tcp_path, const Eigen::Vector3d& tcp_mm, double turn_rad)
        : tcp_path_(std::move(tcp_path)), tcp_mm_(tcp_mm), turn_rad_(turn_rad) {}
    /// Makes a path between poses. The remaining error of an inverse counts as no distance between them.
    ToolPath(TcpPath tcp_path, const Eigen::Vector3d& tcp_mm, double turn_rad, GroupPath group_joints)
        : tcp_path_(std::move(tcp_path)),
          tcp_mm_(tcp_mm),
          turn_rad_(turn_rad),
          group_joints_(std::move(group_joints)),
          is_between_poses_(true) {}
    const GroupPath& group_joints() const { return group_joints_; }

  private:
    bool moves_tcp() const;
    bool turns_tool() const;

    TcpPath tcp_path_;
    Eigen::Vector3d tcp_mm_;
    double turn_rad_;
    GroupPath group_joints_;
    bool is_between_poses_ = false;
};

/// Returns a path on which all joints except the slides x, y, z move in proportion from `start` to `end`. The
/// slides bring the controlled point to its path. `setup` must outlive the path.
std::unique_ptr<ToolPath> make_slide_compensated_path(const PlannerSetup& setup, TcpPath tcp_path,
                                                      const Eigen::Vector3d& tcp_mm,
                                                      const rrs::JointPos& start, const rrs::JointPos& end);

/// Returns a path on which a tool frame, `tool` in that of the tool centre point, turns evenly about one
/// axis. It turns from its pose with the joints at `start` to `end`, a pose in the work frame. Its origin
/// moves along `tcp_path` meanwhile, and the joints of `group_joints` along theirs. `setup` must outlive the
/// path.
std::unique_ptr<ToolPath> make_pose_path(const PlannerSetup& setup, TcpPath tcp_path,
                                         const rrs::CartPos& tool, const rrs::JointPos& start,
                                         const rrs::CartPos& end, GroupPath group_joints = {});

/// Returns `joints` with the values of the slides x, y, z that bring the controlled point to a point of the
/// work frame. Returns nullopt if two slides move in the same direction, or one is missing.
std::optional<rrs::JointPos> solve_slides(const PlannerSetup& setup, const rrs::JointPos& joints,
                                          const Eigen::Vector3d& tcp_mm, const Eigen::Vector3d& point_mm);

/// Sub-segment of a path on which the joints move in proportion.
struct PathSubSegment {
    double share = 0;               ///< Share of the full path.
    rrs::JointPos end;              ///< Joints at its end.
    rrs::JointPos joint_curvature;  ///< Second derivative of the joints by the path, without sign: per length
                                    ///< of the path^2.
};

/// Cuts a path from `start` into sub-segments. The controlled point leaves its path by at most
/// tcp_tolerance_mm of the controller on them, and the tool its orientation by 1e-4 rad, compared at the same
/// share of the path. They are found by halving, with checks at the quarters of each. Errors: RRS_NO_SOLUTION
/// if a pose is out of reach, or the joints would have to jump (a singular position on the path),
/// RRS_JOINT_LIMIT, RRS_INVALID_PARAMETER for more than 200,000 sub-segments. Returns none if no path exists.
tl::expected<std::vector<PathSubSegment>, PlanError> cut(const ToolPath& path, const PlannerSetup& setup,
                                                         const rrs::JointPos& start);

}  // namespace gsim::motion
