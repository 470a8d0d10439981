#include "collision/cell/frame_trajectory.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace gsim::cell {

rrs::CartPos UniformMotion::at(double time_s) const {
    const double elapsed_s = time_s - from_s;
    rrs::CartPos now = pose;
    now.translation() += elapsed_s * velocity_mm_s;
    if (const double rate = angular_velocity_rad_s.norm(); rate > 0)
        now.linear() = Eigen::AngleAxisd(rate * elapsed_s, angular_velocity_rad_s / rate) * pose.linear();
    return now;
}

UniformMotion uniform_motion_between(const rrs::CartPos& from, const rrs::CartPos& to, double from_s,
                                     double to_s) {
    const double duration_s = to_s - from_s;
    UniformMotion uniform_motion{.from_s = from_s, .pose = from};
    if (!(duration_s > 0)) return uniform_motion;
    uniform_motion.velocity_mm_s = (to.translation() - from.translation()) / duration_s;
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.linear() * from.linear().transpose()));
    uniform_motion.angular_velocity_rad_s = turn.angle() / duration_s * turn.axis();
    return uniform_motion;
}

void FrameTrajectory::add(const UniformMotion& uniform_motion) {
    while (motions_.size() > 1 && motions_.back().from_s >= uniform_motion.from_s) motions_.pop_back();
    if (motions_.back().from_s >= uniform_motion.from_s) motions_.clear();
    motions_.push_back(uniform_motion);
}

const UniformMotion& FrameTrajectory::uniform_motion_at(double time_s) const {
    const auto next = std::upper_bound(
        motions_.begin(), motions_.end(), time_s,
        [](double t, const UniformMotion& uniform_motion) { return t < uniform_motion.from_s; });
    return next == motions_.begin() ? motions_.front() : *(next - 1);
}

std::optional<double> FrameTrajectory::next_change_s(double time_s) const {
    const auto next = std::upper_bound(
        motions_.begin(), motions_.end(), time_s,
        [](double t, const UniformMotion& uniform_motion) { return t < uniform_motion.from_s; });
    if (next == motions_.end()) return std::nullopt;
    return next->from_s;
}

void FrameTrajectory::discard_before(double time_s) {
    while (motions_.size() > 1 && motions_[1].from_s <= time_s) motions_.pop_front();
}

bool UniformMotion::moves() const {
    return !velocity_mm_s.isZero(0) || !angular_velocity_rad_s.isZero(0);
}

rrs::CartPos FrameTrajectory::at(double time_s) const {
    return uniform_motion_at(time_s).at(time_s);
}

}  // namespace gsim::cell
