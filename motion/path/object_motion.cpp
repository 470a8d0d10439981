#include "motion/path/object_motion.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::CartPos;
using rrs::Status;

namespace {

constexpr std::size_t kMaxTargets = 64;
constexpr double kPointTolerance_mm = 1e-9;
constexpr double kOrientationTolerance = 1e-9;  // of the elements of a rotation

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

void ObjectMotion::set_position(const CartPos& pose) {
    moves_.clear();
    elapsed_s_ = 0;
    end_ = pose;
}

tl::expected<double, PlanError> ObjectMotion::add_target(const CartPos& pose) {
    if (!(speed_mm_s_ > 0))
        return make_plan_error(Status::RRS_ZERO_SPEED,
                               "The object has no speed yet; call SetObjectSpeed first.");
    if (moves_.size() == kMaxTargets) {
        return make_plan_error(
            Status::RRS_QUEUE_FULL,
            fmt::format("{} targets of the object are pending; call GetNextObjectStep before setting more.",
                        kMaxTargets));
    }
    const double length_mm = (pose.translation() - end_.translation()).norm();
    const double turn = (pose.linear() - end_.linear()).cwiseAbs().maxCoeff();
    if (length_mm < kPointTolerance_mm && turn > kOrientationTolerance) {
        return make_plan_error(
            Status::RRS_ZERO_SPEED,
            "The object would rotate without moving, but its speed is one along its path.");
    }
    moves_.push_back({end_, pose, length_mm / speed_mm_s_});
    end_ = pose;
    return moves_.back().duration_s;
}

ObjectMotion::Step ObjectMotion::step(double step_s) {
    Step step{.status = moves_.empty() ? Status::RRS_NEED_MORE_DATA : Status::RRS_SUCCESS, .pose = end_};
    double remaining_s = step_s;
    while (!moves_.empty() && elapsed_s_ + remaining_s >= moves_.front().duration_s) {
        remaining_s -= moves_.front().duration_s - elapsed_s_;
        elapsed_s_ = 0;
        moves_.pop_front();
        step.status = Status::RRS_TARGET_REACHED;
    }
    if (moves_.empty()) {
        step.elapsed_s = step_s - remaining_s;
        return step;
    }
    elapsed_s_ += remaining_s;
    step.elapsed_s = step_s;
    step.pose = pose_between(moves_.front().from, moves_.front().to, elapsed_s_ / moves_.front().duration_s);
    return step;
}

}  // namespace gsim::motion
