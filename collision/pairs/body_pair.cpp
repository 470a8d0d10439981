#include "collision/pairs/body_pair.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace gsim::cell {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kDistanceTolerance_mm = 1e-4;
constexpr double kTimeTolerance_s = 1e-9;
constexpr double kSeparation_mm = 1e-5;
constexpr int kMaxOverlapChecks = 24;
constexpr int kMaxMotionParts = 20'000;  // of one search; at the limit the result is what is known by then

/// Box along the axes of a frame.
struct AxisAlignedBox {
    Vector3d middle;
    Vector3d half;
};

AxisAlignedBox bounding_box(const Shape& shape, const Isometry3d& pose) {
    return {pose * shape.middle_mm(), pose.linear().cwiseAbs() * shape.half_mm()};
}

double distance_mm(const AxisAlignedBox& a, const AxisAlignedBox& b) {
    return ((a.middle - b.middle).cwiseAbs() - a.half - b.half).cwiseMax(0).norm();
}

AxisAlignedBox merged_box(const AxisAlignedBox& a, const AxisAlignedBox& b) {
    const Vector3d low = (a.middle - a.half).cwiseMin(b.middle - b.half);
    const Vector3d high = (a.middle + a.half).cwiseMax(b.middle + b.half);
    return {(low + high) / 2, (high - low) / 2};
}

/// Part of the motion that waits for a closer check.
struct PendingPart {
    double lower_mm;
    MotionPart part;

    bool operator<(const PendingPart& other) const { return lower_mm > other.lower_mm; }  // nearest first
};

}  // namespace

DistanceBounds BodyPair::distance_at(const LinkFrames& links, double cutoff_mm) const {
    const Isometry3d fixed = second.pose_in_world(links);
    const Isometry3d pose = fixed.inverse() * first.pose_in_world(links);
    const Gap gap = shape_distance(*first.shape, pose, *second.shape, cutoff_mm);
    return {gap.lower_mm, gap.upper_mm, fixed * gap.on_second};
}

double BodyPair::box_separation_mm(const LinkFrames& links) const {
    const Isometry3d pose = second.pose_in_world(links).inverse() * first.pose_in_world(links);
    const auto separation_mm = [](const Shape& moving, const Isometry3d& at, const Shape& fixed) {
        return distance_mm(bounding_box(moving, at), bounding_box(fixed, Isometry3d::Identity()));
    };
    return std::max(separation_mm(*first.shape, pose, *second.shape),
                    separation_mm(*second.shape, pose.inverse(), *first.shape));
}

DistanceBounds BodyPair::distance_in(const MotionPart& part, double cutoff_mm) const {
    const Isometry3d fixed = second.pose_in_world(part.from);
    const Isometry3d from = fixed.inverse() * first.pose_in_world(part.from);
    const Isometry3d to = second.pose_in_world(part.to).inverse() * first.pose_in_world(part.to);
    const double deviation_mm = bound(part).deviation_mm;
    const double lower_bound_mm =
        distance_mm(merged_box(bounding_box(*first.shape, from), bounding_box(*first.shape, to)),
                    bounding_box(*second.shape, Isometry3d::Identity())) -
        deviation_mm;
    if (lower_bound_mm >= cutoff_mm) return {lower_bound_mm, lower_bound_mm};
    const Gap gap = shape_distance(*first.shape, from, to, *second.shape, cutoff_mm + deviation_mm);
    // On a straight path without rotation, the hull is exactly the volume that the body passes.
    const double upper_mm = deviation_mm > 0 ? cutoff_mm : gap.upper_mm;
    return {std::max(0.0, gap.lower_mm - deviation_mm), upper_mm, fixed * gap.on_second};
}

bool BodyPair::overlaps(const LinkFrames& links, const Vector3d& normal, double offset_mm) const {
    Isometry3d pose = second.pose_in_world(links).inverse() * first.pose_in_world(links);
    pose.pretranslate((offset_mm + kSeparation_mm) * normal);
    return shape_distance(*first.shape, pose, *second.shape, kContactTolerance_mm).upper_mm <
           kContactTolerance_mm;
}

bool BodyPair::penetration_increases(const LinkMotion& motion, double from_s, double to_s,
                                     const Vector3d& normal, double offset_mm) const {
    double sample_offset_s = to_s - from_s;
    for (int evaluation = 0; evaluation < kMaxOverlapChecks; ++evaluation, sample_offset_s /= 2) {
        if (overlaps(motion.links_at(from_s + sample_offset_s), normal, offset_mm)) return true;
    }
    return false;
}

DistanceBounds BodyPair::nearest(const LinkMotion& motion, const MotionPart& part, double cutoff_mm) const {
    const auto nearer = [](const DistanceBounds& a, const DistanceBounds& b) {
        return a.upper_mm <= b.upper_mm ? a : b;
    };
    DistanceBounds evaluation = distance_in(part, cutoff_mm);
    if (evaluation.lower_mm >= cutoff_mm ||
        evaluation.upper_mm - evaluation.lower_mm <= kDistanceTolerance_mm)
        return evaluation;
    DistanceBounds best{cutoff_mm, cutoff_mm};
    best = nearer(distance_at(part.from, cutoff_mm), best);
    best = nearer(distance_at(part.to, best.upper_mm), best);
    std::priority_queue<PendingPart> waiting;
    waiting.push({evaluation.lower_mm, part});
    for (int parts = 0; !waiting.empty() && parts < kMaxMotionParts; ++parts) {
        const PendingPart next = waiting.top();
        best.lower_mm = std::min(best.upper_mm, next.lower_mm);
        if (best.upper_mm - next.lower_mm <= kDistanceTolerance_mm ||
            next.part.to_s - next.part.from_s <= kTimeTolerance_s)
            return best;
        waiting.pop();
        const LinkFrames middle = motion.links_at(next.part.middle_s());
        best = nearer(distance_at(middle, best.upper_mm), best);
        for (MotionPart& half :
             std::array{motion.first_half(next.part, middle), motion.second_half(next.part, middle)}) {
            const double lower_mm = std::max(next.lower_mm, distance_in(half, best.upper_mm).lower_mm);
            if (lower_mm < best.upper_mm) waiting.push({lower_mm, std::move(half)});
        }
    }
    if (waiting.empty()) best.lower_mm = best.upper_mm;
    return best;
}

// As first_touch().
std::optional<double> BodyPair::first_within_s(const LinkMotion& motion, const MotionPart& part,
                                               double distance_mm) const {
    constexpr double kTouchTolerance_mm = 1e-3;
    constexpr double kMinDuration_s = 1e-6;
    const double cutoff_mm = distance_mm + 2 * kTouchTolerance_mm;
    std::vector<MotionPart> waiting{part};
    for (int parts = 0; !waiting.empty() && parts < kMaxMotionParts; ++parts) {
        const MotionPart next = std::move(waiting.back());
        waiting.pop_back();
        if (distance_in(next, cutoff_mm).lower_mm > distance_mm + kTouchTolerance_mm) continue;
        if (distance_at(next.from, cutoff_mm).upper_mm <= distance_mm + kTouchTolerance_mm)
            return next.from_s;
        if (next.to_s - next.from_s <= kMinDuration_s) return next.to_s;
        const LinkFrames middle = motion.links_at(next.middle_s());
        waiting.push_back(motion.second_half(next, middle));
        waiting.push_back(motion.first_half(next, middle));
    }
    return std::nullopt;
}

// Halves the earliest part that may hold a contact until it is used up; later parts wait.
std::optional<Touch> BodyPair::first_touch(const LinkMotion& motion, const MotionPart& part) const {
    constexpr double kNormalRange_mm = 1;  // how far off a normal is still worth to be known
    std::vector<MotionPart> waiting{part};
    Touch touch{0, Vector3d::Zero(), std::nullopt};
    for (int parts = 0; !waiting.empty() && parts < kMaxMotionParts; ++parts) {
        const MotionPart next = std::move(waiting.back());
        waiting.pop_back();
        if (distance_in(next, 2 * kContactTolerance_mm).lower_mm > kContactTolerance_mm) continue;
        const Isometry3d fixed = second.pose_in_world(next.from);
        const Isometry3d pose = fixed.inverse() * first.pose_in_world(next.from);
        const Gap gap = shape_distance(*first.shape, pose, *second.shape, kNormalRange_mm);
        touch.t_s = next.from_s;
        if (gap.upper_mm < kNormalRange_mm) {
            touch.point_mm = fixed * gap.on_second;
            const Vector3d displacement = gap.on_first - gap.on_second;
            if (displacement.norm() > kContactTolerance_mm) touch.normal = displacement.normalized();
        }
        if (gap.upper_mm <= kContactTolerance_mm) return touch;
        if (next.to_s - next.from_s <= kTimeTolerance_s) return touch;
        const LinkFrames middle = motion.links_at(next.middle_s());
        waiting.push_back(motion.second_half(next, middle));
        waiting.push_back(motion.first_half(next, middle));
    }
    return std::nullopt;
}

}  // namespace gsim::cell
