#include "motion/path/tool_path.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "motion/path/axis_space.h"
#include "motion/path/joint_changes.h"

namespace gsim::motion {

namespace {

constexpr double kNoWay_mm = 1e-9;
constexpr double kInverseLeaves_mm = 1e-6;
constexpr double kInverseLeaves_rad = 1e-7;
constexpr double kLeastDeterminant = 1e-9;  // of the directions of the slides

Eigen::Vector3d tip_at(const PlannerSetup& setup, const rrs::JointPos& joints,
                       const Eigen::Vector3d& tip_mm) {
    return setup.kinematics->forward(joints) * tip_mm;
}

class TipPath final : public ToolPath {
  public:
    TipPath(const PlannerSetup& setup, TipWay way, const Eigen::Vector3d& tip_mm, const rrs::JointPos& start,
            const rrs::JointPos& end)
        : ToolPath(std::move(way), tip_mm, JointChanges(setup, start, end).norm(JointRole::rotary)),
          setup_(setup),
          start_(start),
          end_(end) {}

    rrs::CartPos seen(const rrs::JointPos& joints) const override {
        return setup_.kinematics->forward(joints);
    }

    tl::expected<rrs::JointPos, std::string> joints_at(double share, const rrs::JointPos&) const override {
        if (share <= 0) return start_;
        if (share >= 1) return end_;
        const rrs::JointPos straight = start_ + share * (end_ - start_);
        auto joints = place_tip(setup_, straight, tip_mm(), way().at(share));
        if (joints) return *std::move(joints);
        return tl::unexpected(std::string("The rotary axes stand so that two slides go the same way."));
    }

  private:
    const PlannerSetup& setup_;
    rrs::JointPos start_;
    rrs::JointPos end_;
};

class PosePath final : public ToolPath {
  public:
    PosePath(const PlannerSetup& setup, TipWay way, const rrs::CartPos& tool, const rrs::CartPos& start,
             const rrs::CartPos& end, LedWay led)
        : ToolPath(std::move(way), tool.translation(),
                   Eigen::Quaterniond(start.linear()).angularDistance(Eigen::Quaterniond(end.linear())),
                   std::move(led)),
          setup_(setup),
          from_tool_(tool.inverse()),
          start_(start.linear()),
          end_(end.linear()) {}

    rrs::CartPos seen(const rrs::JointPos& joints) const override {
        return setup_.kinematics->forward(led().as_seen(joints));
    }

    tl::expected<rrs::JointPos, std::string> joints_at(double share,
                                                       const rrs::JointPos& near) const override {
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = start_.slerp(share, end_).normalized().toRotationMatrix();
        pose.translation() = way().at(share);
        return setup_.kinematics->inverse(pose * from_tool_, led().as_seen(led().put(share, near)))
            .map([&](const rrs::JointPos& joints) { return led().put(share, joints); });
    }

  private:
    const PlannerSetup& setup_;
    rrs::CartPos from_tool_;  ///< The tool centre point in the frame of the tool.
    Eigen::Quaterniond start_;
    Eigen::Quaterniond end_;
};

}  // namespace

LedWay::LedWay(const PlannerSetup& setup, const rrs::JointPos& start, std::vector<LedJoint> led)
    : led_(std::move(led)), start_(start) {
    for (const LedJoint& one : led_) {
        double& way = setup.role(one.joint) == JointRole::rotary ? turn_rad_ : slide_mm_;
        way = std::hypot(way, one.value - start[one.joint]);
    }
}

rrs::JointPos LedWay::put(double share, const rrs::JointPos& joints) const {
    rrs::JointPos placed = joints;
    for (const LedJoint& one : led_) {
        const double from = start_[one.joint];
        placed[one.joint] = share >= 1 ? one.value : from + share * (one.value - from);
    }
    return placed;
}

rrs::JointPos LedWay::as_seen(const rrs::JointPos& joints) const {
    rrs::JointPos placed = joints;
    for (const LedJoint& one : led_) {
        if (!one.coordinated) placed[one.joint] = one.value;
    }
    return placed;
}

bool ToolPath::moves_tip() const {
    return way_.length_mm() > (of_poses_ ? kInverseLeaves_mm : 0);
}

bool ToolPath::turns_tool() const {
    return turn_rad_ > (of_poses_ ? kInverseLeaves_rad : 0);
}

JointRole ToolPath::role() const {
    if (moves_tip()) return JointRole::position;
    const bool slides = !turns_tool() && led_.turn_rad() == 0 && led_.slide_mm() > 0;
    return slides ? JointRole::secondary : JointRole::rotary;
}

double ToolPath::length() const {
    if (moves_tip()) return way_.length_mm();
    if (turns_tool()) return turn_rad_;
    return led_.turn_rad() > 0 ? led_.turn_rad() : led_.slide_mm();
}

double TipWay::length_mm() const {
    if (kind == SegmentKind::circular) return arc.length_mm();
    const double length = (to - from).norm();
    return length > kNoWay_mm ? length : 0;
}

Eigen::Vector3d TipWay::at(double share) const {
    if (share <= 0) return from;
    if (share >= 1) return to;
    if (kind == SegmentKind::circular) return arc.at(arc.phi_at(share * arc.length_mm()));
    return from + share * (to - from);
}

std::unique_ptr<ToolPath> tip_path(const PlannerSetup& setup, TipWay way, const Eigen::Vector3d& tip_mm,
                                   const rrs::JointPos& start, const rrs::JointPos& end) {
    return std::make_unique<TipPath>(setup, std::move(way), tip_mm, start, end);
}

std::unique_ptr<ToolPath> pose_path(const PlannerSetup& setup, TipWay way, const rrs::CartPos& tool,
                                    const rrs::JointPos& start, const rrs::CartPos& end, LedWay led) {
    const rrs::CartPos from = setup.kinematics->forward(led.as_seen(start)) * tool;
    return std::make_unique<PosePath>(setup, std::move(way), tool, from, end, std::move(led));
}

// The controlled point is a linear function of the slides while the other joints keep their values.
std::optional<rrs::JointPos> place_tip(const PlannerSetup& setup, const rrs::JointPos& joints,
                                       const Eigen::Vector3d& tip_mm, const Eigen::Vector3d& point_mm) {
    const Eigen::Vector3d tip = tip_at(setup, joints, tip_mm);
    Eigen::Matrix3d directions;
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0) return std::nullopt;
        rrs::JointPos moved = joints;
        moved[joint] += 1;
        directions.col(axis) = tip_at(setup, moved, tip_mm) - tip;
    }
    if (!(std::abs(directions.determinant()) > kLeastDeterminant)) return std::nullopt;
    rrs::JointPos placed = joints;
    put_position(setup.position_joints, position_of(setup, joints) + directions.inverse() * (point_mm - tip),
                 placed);
    return placed;
}

}  // namespace gsim::motion
