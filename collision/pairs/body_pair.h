#pragma once

#include <optional>
#include <vector>

#include "collision/pairs/link_motion.h"
#include "geometry/distance/shape.h"

namespace gsim::cell {

/// What is nearer than this is in contact.
inline constexpr double kContact_mm = 1e-6;

/// A shape that is fixed to a link of the machine, or, link 0, to the world. The shape must outlive this.
struct Body {
    const Shape* shape;
    int link;
    Eigen::Isometry3d in_link;

    Eigen::Isometry3d in_world(const LinkFrames& links) const {
        return links[static_cast<std::size_t>(link)] * in_link;
    }
    Ball ball(const LinkFrames& links) const {
        return {in_world(links) * shape->middle_mm(), shape->radius_mm()};
    }
};

/// How near two bodies come to each other.
struct Nearness {
    double lower_mm;                                     ///< No nearer than this.
    double upper_mm;                                     ///< As near at some time, or not looked at.
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< On the second body, in the world.
};

/// The first instant of a contact.
struct Touch {
    double t_s;  ///< Since the start of the motion.
    Eigen::Vector3d point_mm;
    /// From the second body to the first, in the second one's frame; none where they were in contact already.
    std::optional<Eigen::Vector3d> normal;
};

/// Two bodies, of which the first is taken to move and the second to be at rest.
struct BodyPair {
    Body first;
    Body second;
    std::vector<int> between;  ///< The joints between their links: joints_between().

    /// The ways of the first body's points, seen from the second.
    MotionBound bound(const MotionPart& part) const {
        return part.chain.bound(first.ball(part.from), between);
    }
    /// At one instant.
    Nearness nearness_at(const LinkFrames& links, double enough_mm) const;
    /// At one instant, by the boxes of the bodies, seen along the axes of either: no nearer than this.
    double boxes_apart_mm(const LinkFrames& links) const;
    /// In a part of a motion, as well as one look can tell: the second is met by the hull of the first one's
    /// places at both ends, as far as the bend reaches.
    Nearness nearness_in(const MotionPart& part, double enough_mm) const;
    /// Whether they still overlap with the first moved out by `out_mm` and 1e-5 mm more.
    bool overlaps(const LinkFrames& links, const Eigen::Vector3d& normal, double out_mm = 0) const;
    /// The same at some time between two of a motion, where they touch at the first: most that goes deeper
    /// does so soon, so that looks are the closer to each other the sooner they are.
    bool goes_deeper(const LinkMotion& motion, double from_s, double to_s, const Eigen::Vector3d& normal,
                     double out_mm = 0) const;
    /// Whether they are in contact at one instant.
    bool touch_at(const LinkFrames& links) const {
        return nearness_at(links, 2 * kContact_mm).upper_mm <= kContact_mm;
    }

    /// The least distance in a part of a motion, to 1e-4 mm; what is not below `enough_mm` is told as that.
    Nearness nearest(const LinkMotion& motion, const MotionPart& part, double enough_mm) const;
    /// When they first are as near as that in a part of a motion, to 1e-3 mm, or 1e-6 s where they pass fast;
    /// nothing where they never are.
    std::optional<double> first_within_s(const LinkMotion& motion, const MotionPart& part,
                                         double distance_mm) const;
    /// When they first touch in a part of a motion, to 1e-9 s.
    std::optional<Touch> first_touch(const LinkMotion& motion, const MotionPart& part) const;
};

}  // namespace gsim::cell
