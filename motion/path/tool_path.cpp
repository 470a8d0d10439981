#include "motion/path/tool_path.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "motion/path/axis_space.h"
#include "motion/path/joint_changes.h"

namespace gsim::motion {

namespace {

constexpr double kMinLength_mm = 1e-9;
constexpr double kInverseTolerance_mm = 1e-6;
constexpr double kInverseTolerance_rad = 1e-7;
constexpr double kMinDeterminant = 1e-9;  // of the directions of the slides

Eigen::Vector3d tcp_at(const PlannerSetup& setup, const rrs::JointPos& joints,
                       const Eigen::Vector3d& tcp_mm) {
    return setup.kinematics->forward(joints) * tcp_mm;
}

class SlideCompensatedPath final : public ToolPath {
  public:
    SlideCompensatedPath(const PlannerSetup& setup, TcpPath tcp_path, const Eigen::Vector3d& tcp_mm,
                         const rrs::JointPos& start, const rrs::JointPos& end)
        : ToolPath(std::move(tcp_path), tcp_mm, JointChanges(setup, start, end).norm(JointRole::rotary)),
          setup_(setup),
          start_(start),
          end_(end) {}

    rrs::CartPos tool_pose(const rrs::JointPos& joints) const override {
        return setup_.kinematics->forward(joints);
    }

    tl::expected<rrs::JointPos, std::string> joints_at(double share, const rrs::JointPos&) const override {
        if (share <= 0) return start_;
        if (share >= 1) return end_;
        const rrs::JointPos linear_joints = start_ + share * (end_ - start_);
        auto joints = solve_slides(setup_, linear_joints, tcp_mm(), tcp_path().at(share));
        if (joints) return *std::move(joints);
        return tl::unexpected(std::string("The position of the rotary axes makes two linear axes parallel."));
    }

  private:
    const PlannerSetup& setup_;
    rrs::JointPos start_;
    rrs::JointPos end_;
};

class PosePath final : public ToolPath {
  public:
    PosePath(const PlannerSetup& setup, TcpPath tcp_path, const rrs::CartPos& tool, const rrs::CartPos& start,
             const rrs::CartPos& end, GroupPath group_joints)
        : ToolPath(std::move(tcp_path), tool.translation(),
                   Eigen::Quaterniond(start.linear()).angularDistance(Eigen::Quaterniond(end.linear())),
                   std::move(group_joints)),
          setup_(setup),
          tool_to_tcp_(tool.inverse()),
          start_(start.linear()),
          end_(end.linear()) {}

    rrs::CartPos tool_pose(const rrs::JointPos& joints) const override {
        return setup_.kinematics->forward(group_joints().with_synchronous_joints(joints));
    }

    tl::expected<rrs::JointPos, std::string> joints_at(double share,
                                                       const rrs::JointPos& near) const override {
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = start_.slerp(share, end_).normalized().toRotationMatrix();
        pose.translation() = tcp_path().at(share);
        return setup_.kinematics
            ->inverse(pose * tool_to_tcp_,
                      group_joints().with_synchronous_joints(group_joints().set_coordinated(share, near)))
            .map([&](const rrs::JointPos& joints) { return group_joints().set_coordinated(share, joints); });
    }

  private:
    const PlannerSetup& setup_;
    rrs::CartPos tool_to_tcp_;  ///< The tool centre point in the frame of the tool.
    Eigen::Quaterniond start_;
    Eigen::Quaterniond end_;
};

}  // namespace

GroupPath::GroupPath(const PlannerSetup& setup, const rrs::JointPos& start,
                     std::vector<GroupJoint> group_joints)
    : group_joints_(std::move(group_joints)), start_(start) {
    for (const GroupJoint& one : group_joints_) {
        double& tcp_path = setup.role(one.joint) == JointRole::rotary ? turn_rad_ : slide_distance_mm_;
        tcp_path = std::hypot(tcp_path, one.value - start[one.joint]);
    }
}

rrs::JointPos GroupPath::set_coordinated(double share, const rrs::JointPos& joints) const {
    rrs::JointPos placed = joints;
    for (const GroupJoint& one : group_joints_) {
        const double from = start_[one.joint];
        placed[one.joint] = share >= 1 ? one.value : from + share * (one.value - from);
    }
    return placed;
}

rrs::JointPos GroupPath::with_synchronous_joints(const rrs::JointPos& joints) const {
    rrs::JointPos placed = joints;
    for (const GroupJoint& one : group_joints_) {
        if (!one.coordinated) placed[one.joint] = one.value;
    }
    return placed;
}

bool ToolPath::moves_tcp() const {
    return tcp_path_.length_mm() > (is_between_poses_ ? kInverseTolerance_mm : 0);
}

bool ToolPath::turns_tool() const {
    return turn_rad_ > (is_between_poses_ ? kInverseTolerance_rad : 0);
}

JointRole ToolPath::role() const {
    if (moves_tcp()) return JointRole::position;
    const bool moves_slides =
        !turns_tool() && group_joints_.turn_rad() == 0 && group_joints_.slide_distance_mm() > 0;
    return moves_slides ? JointRole::secondary : JointRole::rotary;
}

double ToolPath::length() const {
    if (moves_tcp()) return tcp_path_.length_mm();
    if (turns_tool()) return turn_rad_;
    return group_joints_.turn_rad() > 0 ? group_joints_.turn_rad() : group_joints_.slide_distance_mm();
}

double TcpPath::length_mm() const {
    if (kind == SegmentKind::circular) return arc.length_mm();
    const double length = (to - from).norm();
    return length > kMinLength_mm ? length : 0;
}

Eigen::Vector3d TcpPath::at(double share) const {
    if (share <= 0) return from;
    if (share >= 1) return to;
    if (kind == SegmentKind::circular) return arc.at(arc.phi_at(share * arc.length_mm()));
    return from + share * (to - from);
}

std::unique_ptr<ToolPath> make_slide_compensated_path(const PlannerSetup& setup, TcpPath tcp_path,
                                                      const Eigen::Vector3d& tcp_mm,
                                                      const rrs::JointPos& start, const rrs::JointPos& end) {
    return std::make_unique<SlideCompensatedPath>(setup, std::move(tcp_path), tcp_mm, start, end);
}

std::unique_ptr<ToolPath> make_pose_path(const PlannerSetup& setup, TcpPath tcp_path,
                                         const rrs::CartPos& tool, const rrs::JointPos& start,
                                         const rrs::CartPos& end, GroupPath group_joints) {
    const rrs::CartPos from = setup.kinematics->forward(group_joints.with_synchronous_joints(start)) * tool;
    return std::make_unique<PosePath>(setup, std::move(tcp_path), tool, from, end, std::move(group_joints));
}

// The controlled point is a linear function of the slides while the other joints keep their values.
std::optional<rrs::JointPos> solve_slides(const PlannerSetup& setup, const rrs::JointPos& joints,
                                          const Eigen::Vector3d& tcp_mm, const Eigen::Vector3d& point_mm) {
    const Eigen::Vector3d tcp = tcp_at(setup, joints, tcp_mm);
    Eigen::Matrix3d directions;
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0) return std::nullopt;
        rrs::JointPos moved = joints;
        moved[joint] += 1;
        directions.col(axis) = tcp_at(setup, moved, tcp_mm) - tcp;
    }
    if (!(std::abs(directions.determinant()) > kMinDeterminant)) return std::nullopt;
    rrs::JointPos placed = joints;
    write_position(setup.position_joints,
                   read_position(setup, joints) + directions.inverse() * (point_mm - tcp), placed);
    return placed;
}

}  // namespace gsim::motion
