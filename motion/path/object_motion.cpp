#include "motion/path/object_motion.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::CartPos;
using rrs::Status;

namespace {

constexpr std::size_t kMostTargets = 64;
constexpr double kSamePoint_mm = 1e-9;
constexpr double kSameOrientation = 1e-9;  // of the elements of a rotation

Eigen::Quaterniond orientation(const CartPos& pose) {
    return Eigen::Quaterniond(Eigen::Matrix3d(pose.linear())).normalized();
}

}  // namespace

CartPos pose_between(const CartPos& from, const CartPos& to, double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    CartPos pose = CartPos::Identity();
    pose.linear() = orientation(from).slerp(share, orientation(to)).toRotationMatrix();
    pose.translation() = from.translation() + share * (to.translation() - from.translation());
    return pose;
}

void ObjectMotion::stand_at(const CartPos& pose) {
    ways_.clear();
    into_s_ = 0;
    end_ = pose;
}

tl::expected<double, PlanError> ObjectMotion::add_target(const CartPos& pose) {
    if (!(speed_mm_s_ > 0))
        return refused(Status::RRS_ZERO_SPEED, "The object has no speed yet; call SetObjectSpeed first.");
    if (ways_.size() == kMostTargets) {
        return refused(
            Status::RRS_QUEUE_FULL,
            fmt::format("{} targets of the object are waiting; call GetNextObjectStep before more are "
                        "put.",
                        kMostTargets));
    }
    const double length_mm = (pose.translation() - end_.translation()).norm();
    const double turn = (pose.linear() - end_.linear()).cwiseAbs().maxCoeff();
    if (length_mm < kSamePoint_mm && turn > kSameOrientation) {
        return refused(Status::RRS_ZERO_SPEED,
                       "The object would turn without going anywhere, and its speed is one along its way.");
    }
    ways_.push_back({end_, pose, length_mm / speed_mm_s_});
    end_ = pose;
    return ways_.back().duration_s;
}

ObjectMotion::Step ObjectMotion::step(double step_s) {
    Step step{.status = ways_.empty() ? Status::RRS_NEED_MORE_DATA : Status::RRS_SUCCESS, .pose = end_};
    double left_s = step_s;
    while (!ways_.empty() && into_s_ + left_s >= ways_.front().duration_s) {
        left_s -= ways_.front().duration_s - into_s_;
        into_s_ = 0;
        ways_.pop_front();
        step.status = Status::RRS_TARGET_REACHED;
    }
    if (ways_.empty()) {
        step.elapsed_s = step_s - left_s;
        return step;
    }
    into_s_ += left_s;
    step.elapsed_s = step_s;
    step.pose = pose_between(ways_.front().from, ways_.front().to, into_s_ / ways_.front().duration_s);
    return step;
}

}  // namespace gsim::motion
