#pragma once

#include <optional>
#include <vector>

#include "collision/pairs/link_motion.h"
#include "geometry/distance/shape.h"

namespace gsim::cell {

/// Distance below which two bodies are in contact.
inline constexpr double kContactTolerance_mm = 1e-6;

/// Shape that is fixed to a link of the machine or, for link 0, to the world. The shape must outlive this.
struct Body {
    const Shape* shape;
    int link;
    Eigen::Isometry3d pose_in_link;

    Eigen::Isometry3d pose_in_world(const LinkFrames& links) const {
        return links[static_cast<std::size_t>(link)] * pose_in_link;
    }
    BoundingSphere ball(const LinkFrames& links) const {
        return {pose_in_world(links) * shape->middle_mm(), shape->radius_mm()};
    }
};

/// Bounds of the distance between two bodies.
struct DistanceBounds {
    double lower_mm;                                     ///< No nearer than this.
    double upper_mm;                                     ///< As near at some time, or not looked at.
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< On the second body, in the world.
};

/// First instant of a contact.
struct Touch {
    double t_s;  ///< Since the start of the motion.
    Eigen::Vector3d point_mm;
    /// Direction from the second body to the first, in the second one's frame; nullopt if they were already
    /// in contact.
    std::optional<Eigen::Vector3d> normal;
};

/// Two bodies; the first is taken to move, the second to be at standstill.
struct BodyPair {
    Body first;
    Body second;
    std::vector<int> between;  ///< The joints between their links: joints_between().

    /// Returns bounds of the paths of the first body's points, as seen from the second.
    MotionBound bound(const MotionPart& part) const {
        return part.chain.bound(first.ball(part.from), between);
    }
    /// Returns the distance at one instant.
    DistanceBounds distance_at(const LinkFrames& links, double cutoff_mm) const;
    /// Returns a lower bound of the distance at one instant, from the boxes of the bodies, seen along the
    /// axes of either.
    double box_separation_mm(const LinkFrames& links) const;
    /// Returns the distance in a part of a motion, as well as one check can give it. The second body is
    /// checked against the hull of the first one's poses at both ends, extended by the deviation from the
    /// straight path.
    DistanceBounds distance_in(const MotionPart& part, double cutoff_mm) const;
    /// Returns true if they still overlap after the first is moved out by `offset_mm` and 1e-5 mm more.
    bool overlaps(const LinkFrames& links, const Eigen::Vector3d& normal, double offset_mm = 0) const;
    /// Returns true if they do so at some time between two of a motion; at the first they touch. Most bodies
    /// that go deeper do so soon, so early checks are closer to each other.
    bool penetration_increases(const LinkMotion& motion, double from_s, double to_s,
                               const Eigen::Vector3d& normal, double offset_mm = 0) const;
    /// Returns true if they are in contact at one instant.
    bool are_in_contact(const LinkFrames& links) const {
        return distance_at(links, 2 * kContactTolerance_mm).upper_mm <= kContactTolerance_mm;
    }

    /// Returns the smallest distance in a part of a motion, to 1e-4 mm; one that is not below `cutoff_mm` is
    /// returned as that value.
    DistanceBounds nearest(const LinkMotion& motion, const MotionPart& part, double cutoff_mm) const;
    /// Returns the first time at which they are that near in a part of a motion, to 1e-3 mm, or 1e-6 s if
    /// they pass fast; nullopt if they never are.
    std::optional<double> first_within_s(const LinkMotion& motion, const MotionPart& part,
                                         double distance_mm) const;
    /// Returns their first contact in a part of a motion, to 1e-9 s.
    std::optional<Touch> first_touch(const LinkMotion& motion, const MotionPart& part) const;
};

}  // namespace gsim::cell
