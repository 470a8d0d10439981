#include "collision/pairs/segment_motion.h"

#include <algorithm>

#include "collision/pairs/joint_travel.h"

namespace gsim::cell {

MotionPart SegmentMotion::part(double from_s, const LinkFrames& from, double to_s,
                               const LinkFrames& to) const {
    std::vector<JointAxis> axes = joint_axes(kinematics_, segment_.position_at(from_s));
    const bool drifts = std::any_of(drifting_.begin(), drifting_.end(),
                                    [](const DriftingLink& link) { return link.drift.moves(); });
    std::vector<DriftTravel> drifted;
    drifted.reserve(drifting_.size());
    for (std::size_t i = 0; i < drifting_.size(); ++i) {
        const DriftingLink& link = drifting_[i];
        const std::size_t number = from.size() - drifting_.size() + i;
        const double rate = link.drift.spin_rad_s.norm();
        const Eigen::Vector3d axis = rate > 0 ? Eigen::Vector3d(link.drift.spin_rad_s / rate)
                                              : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
        const rrs::CartPos frame = from[static_cast<std::size_t>(link.parent)] * link.mount;
        drifted.push_back({(to_s - from_s) * link.drift.velocity_mm_s.norm(), (to_s - from_s) * rate,
                           from[number].translation(), frame.linear() * axis});
    }
    return {from_s, to_s, from, to,
            ChainMotion(std::move(axes), travel_of(segment_, from_s, to_s, drifts), std::move(drifted))};
}

LinkFrames SegmentMotion::links_at(double t_s) const {
    LinkFrames links = link_frames(kinematics_, segment_.position_at(t_s));
    links.reserve(links.size() + drifting_.size());
    for (const DriftingLink& link : drifting_) {
        links.push_back(links[static_cast<std::size_t>(link.parent)] * link.mount *
                        link.drift.at(segment_.start_s + t_s));
    }
    return links;
}

}  // namespace gsim::cell
