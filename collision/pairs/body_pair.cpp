#include "collision/pairs/body_pair.h"

#include <algorithm>
#include <queue>
#include <vector>

namespace gsim::cell {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kClearance_mm = 1e-4;
constexpr double kTime_s = 1e-9;
constexpr double kOut_mm = 1e-5;
constexpr int kOverlapLooks = 24;
constexpr int kMaxMotionParts = 20'000;  // of one search; at the limit the result is what is known by then

/// Box along the axes of a frame.
struct AxisBox {
    Vector3d middle;
    Vector3d half;
};

AxisBox box_of(const Shape& shape, const Isometry3d& pose) {
    return {pose * shape.middle_mm(), pose.linear().cwiseAbs() * shape.half_mm()};
}

double distance_mm(const AxisBox& a, const AxisBox& b) {
    return ((a.middle - b.middle).cwiseAbs() - a.half - b.half).cwiseMax(0).norm();
}

AxisBox around(const AxisBox& a, const AxisBox& b) {
    const Vector3d low = (a.middle - a.half).cwiseMin(b.middle - b.half);
    const Vector3d high = (a.middle + a.half).cwiseMax(b.middle + b.half);
    return {(low + high) / 2, (high - low) / 2};
}

/// Part of the motion that waits for a closer check.
struct Waiting {
    double lower_mm;
    MotionPart part;

    bool operator<(const Waiting& other) const { return lower_mm > other.lower_mm; }  // nearest first
};

}  // namespace

Nearness BodyPair::nearness_at(const LinkFrames& links, double enough_mm) const {
    const Isometry3d fixed = second.in_world(links);
    const Isometry3d pose = fixed.inverse() * first.in_world(links);
    const Gap gap = gap_between(*first.shape, pose, *second.shape, enough_mm);
    return {gap.lower_mm, gap.upper_mm, fixed * gap.on_second};
}

double BodyPair::boxes_apart_mm(const LinkFrames& links) const {
    const Isometry3d pose = second.in_world(links).inverse() * first.in_world(links);
    const auto apart_mm = [](const Shape& moving, const Isometry3d& at, const Shape& fixed) {
        return distance_mm(box_of(moving, at), box_of(fixed, Isometry3d::Identity()));
    };
    return std::max(apart_mm(*first.shape, pose, *second.shape),
                    apart_mm(*second.shape, pose.inverse(), *first.shape));
}

Nearness BodyPair::nearness_in(const MotionPart& part, double enough_mm) const {
    const Isometry3d fixed = second.in_world(part.from);
    const Isometry3d from = fixed.inverse() * first.in_world(part.from);
    const Isometry3d to = second.in_world(part.to).inverse() * first.in_world(part.to);
    const double bend_mm = bound(part).bend_mm;
    const double far_mm = distance_mm(around(box_of(*first.shape, from), box_of(*first.shape, to)),
                                      box_of(*second.shape, Isometry3d::Identity())) -
                          bend_mm;
    if (far_mm >= enough_mm) return {far_mm, far_mm};
    const Gap gap = gap_between(*first.shape, from, to, *second.shape, enough_mm + bend_mm);
    // On a straight path without rotation, the hull is exactly the volume that the body passes.
    const double upper_mm = bend_mm > 0 ? enough_mm : gap.upper_mm;
    return {std::max(0.0, gap.lower_mm - bend_mm), upper_mm, fixed * gap.on_second};
}

bool BodyPair::overlaps(const LinkFrames& links, const Vector3d& normal, double out_mm) const {
    Isometry3d pose = second.in_world(links).inverse() * first.in_world(links);
    pose.pretranslate((out_mm + kOut_mm) * normal);
    return gap_between(*first.shape, pose, *second.shape, kContact_mm).upper_mm < kContact_mm;
}

bool BodyPair::goes_deeper(const LinkMotion& motion, double from_s, double to_s, const Vector3d& normal,
                           double out_mm) const {
    double look_s = to_s - from_s;
    for (int look = 0; look < kOverlapLooks; ++look, look_s /= 2) {
        if (overlaps(motion.links_at(from_s + look_s), normal, out_mm)) return true;
    }
    return false;
}

Nearness BodyPair::nearest(const LinkMotion& motion, const MotionPart& part, double enough_mm) const {
    const auto nearer = [](const Nearness& a, const Nearness& b) { return a.upper_mm <= b.upper_mm ? a : b; };
    Nearness look = nearness_in(part, enough_mm);
    if (look.lower_mm >= enough_mm || look.upper_mm - look.lower_mm <= kClearance_mm) return look;
    Nearness best{enough_mm, enough_mm};
    best = nearer(nearness_at(part.from, enough_mm), best);
    best = nearer(nearness_at(part.to, best.upper_mm), best);
    std::priority_queue<Waiting> waiting;
    waiting.push({look.lower_mm, part});
    for (int parts = 0; !waiting.empty() && parts < kMaxMotionParts; ++parts) {
        const Waiting next = waiting.top();
        best.lower_mm = std::min(best.upper_mm, next.lower_mm);
        if (best.upper_mm - next.lower_mm <= kClearance_mm || next.part.to_s - next.part.from_s <= kTime_s)
            return best;
        waiting.pop();
        const LinkFrames middle = motion.links_at(next.part.middle_s());
        best = nearer(nearness_at(middle, best.upper_mm), best);
        for (MotionPart& half :
             std::array{motion.first_half(next.part, middle), motion.second_half(next.part, middle)}) {
            const double lower_mm = std::max(next.lower_mm, nearness_in(half, best.upper_mm).lower_mm);
            if (lower_mm < best.upper_mm) waiting.push({lower_mm, std::move(half)});
        }
    }
    if (waiting.empty()) best.lower_mm = best.upper_mm;
    return best;
}

// As first_touch().
std::optional<double> BodyPair::first_within_s(const LinkMotion& motion, const MotionPart& part,
                                               double distance_mm) const {
    constexpr double kSame_mm = 1e-3;
    constexpr double kShort_s = 1e-6;
    const double enough_mm = distance_mm + 2 * kSame_mm;
    std::vector<MotionPart> waiting{part};
    for (int parts = 0; !waiting.empty() && parts < kMaxMotionParts; ++parts) {
        const MotionPart next = std::move(waiting.back());
        waiting.pop_back();
        if (nearness_in(next, enough_mm).lower_mm > distance_mm + kSame_mm) continue;
        if (nearness_at(next.from, enough_mm).upper_mm <= distance_mm + kSame_mm) return next.from_s;
        if (next.to_s - next.from_s <= kShort_s) return next.to_s;
        const LinkFrames middle = motion.links_at(next.middle_s());
        waiting.push_back(motion.second_half(next, middle));
        waiting.push_back(motion.first_half(next, middle));
    }
    return std::nullopt;
}

// Halves the earliest part that may hold a contact until it is used up; later parts wait.
std::optional<Touch> BodyPair::first_touch(const LinkMotion& motion, const MotionPart& part) const {
    constexpr double kLook_mm = 1;  // how far off a normal is still worth to be known
    std::vector<MotionPart> waiting{part};
    Touch touch{0, Vector3d::Zero(), std::nullopt};
    for (int parts = 0; !waiting.empty() && parts < kMaxMotionParts; ++parts) {
        const MotionPart next = std::move(waiting.back());
        waiting.pop_back();
        if (nearness_in(next, 2 * kContact_mm).lower_mm > kContact_mm) continue;
        const Isometry3d fixed = second.in_world(next.from);
        const Isometry3d pose = fixed.inverse() * first.in_world(next.from);
        const Gap gap = gap_between(*first.shape, pose, *second.shape, kLook_mm);
        touch.t_s = next.from_s;
        if (gap.upper_mm < kLook_mm) {
            touch.point_mm = fixed * gap.on_second;
            const Vector3d way = gap.on_first - gap.on_second;
            if (way.norm() > kContact_mm) touch.normal = way.normalized();
        }
        if (gap.upper_mm <= kContact_mm) return touch;
        if (next.to_s - next.from_s <= kTime_s) return touch;
        const LinkFrames middle = motion.links_at(next.middle_s());
        waiting.push_back(motion.second_half(next, middle));
        waiting.push_back(motion.first_half(next, middle));
    }
    return std::nullopt;
}

}  // namespace gsim::cell
