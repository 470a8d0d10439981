#include "collision/pairs/segment_motion.h"

#include <algorithm>

#include "collision/pairs/joint_travel.h"

namespace gsim::cell {

MotionPart SegmentMotion::part(double from_s, const LinkFrames& from, double to_s,
                               const LinkFrames& to) const {
    std::vector<JointAxis> axes = joint_axes(kinematics_, segment_.position_at(from_s));
    const bool is_drifting = std::any_of(moving_links_.begin(), moving_links_.end(),
                                         [](const MovingLink& link) { return link.uniform_motion.moves(); });
    std::vector<LinkTravel> link_travels;
    link_travels.reserve(moving_links_.size());
    for (std::size_t i = 0; i < moving_links_.size(); ++i) {
        const MovingLink& link = moving_links_[i];
        const std::size_t number = from.size() - moving_links_.size() + i;
        const double rate = link.uniform_motion.angular_velocity_rad_s.norm();
        const Eigen::Vector3d axis = rate > 0
                                         ? Eigen::Vector3d(link.uniform_motion.angular_velocity_rad_s / rate)
                                         : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
        const rrs::CartPos frame = from[static_cast<std::size_t>(link.parent)] * link.mount;
        link_travels.push_back({(to_s - from_s) * link.uniform_motion.velocity_mm_s.norm(),
                                (to_s - from_s) * rate, from[number].translation(), frame.linear() * axis});
    }
    return {from_s, to_s, from, to,
            ChainMotion(std::move(axes), joint_travel(segment_, from_s, to_s, is_drifting),
                        std::move(link_travels))};
}

LinkFrames SegmentMotion::links_at(double t_s) const {
    LinkFrames links = link_frames(kinematics_, segment_.position_at(t_s));
    links.reserve(links.size() + moving_links_.size());
    for (const MovingLink& link : moving_links_) {
        links.push_back(links[static_cast<std::size_t>(link.parent)] * link.mount *
                        link.uniform_motion.at(segment_.start_s + t_s));
    }
    return links;
}

}  // namespace gsim::cell
