#include "collision/monitor/collision_checker.h"

#include <utility>

#include "collision/cell/placed_kinematics.h"
#include "collision/pairs/segment_motion.h"

namespace gsim::cell {

namespace {

// Motion of the bodies in a part below which it is not halved any more.
constexpr double kMinLength_mm = 1e-3;

// The middle is checked first: a collision is somewhere, and seldom at the very start.
std::optional<Obstacle> find_obstacle(const CandidatePair& pair, const LinkMotion& motion,
                                      const MotionPart& part, double clearance_mm) {
    const BodyPair& bodies = pair.bodies;
    const auto at = [&](const DistanceBounds& distance_bounds, double t_s) {
        return Obstacle{pair.items, distance_bounds.upper_mm, t_s, distance_bounds.point_mm};
    };
    std::vector<MotionPart> waiting{part};
    while (!waiting.empty()) {
        const MotionPart next = std::move(waiting.back());
        waiting.pop_back();
        if (bodies.distance_in(next, clearance_mm).lower_mm >= clearance_mm) continue;
        const LinkFrames middle = motion.links_at(next.middle_s());
        const DistanceBounds distance_bounds = bodies.distance_at(middle, clearance_mm);
        if (distance_bounds.upper_mm < clearance_mm || bodies.bound(next).travel_mm < kMinLength_mm)
            return at(distance_bounds, next.middle_s());
        waiting.push_back(motion.second_half(next, middle));
        waiting.push_back(motion.first_half(next, middle));
    }
    return std::nullopt;
}

}  // namespace

CollisionChecker::CollisionChecker(const Cell& cell, std::shared_ptr<const kinematics::Kinematics> kinematics)
    : cell_(&cell), kinematics_(std::move(kinematics)) {
    for (CandidatePair& pair : candidate_pairs(cell, *kinematics_)) {
        if (!pair.includes_jet) pairs_.push_back(std::move(pair));
    }
}

Result<CollisionChecker> CollisionChecker::make(const Cell& cell, const machine::Machine& machine) {
    if (!cell.moving_frames.empty()) {
        return Unexpected(
            "a collision-free path cannot be found in a cell with frames that move independently (on "
            "conveyors, or moved by a program)");
    }
    return CollisionChecker(cell, placed_kinematics(machine::make_kinematics(machine), cell.frames));
}

std::optional<Obstacle> CollisionChecker::obstacle(const motion::Segment& segment,
                                                   double clearance_mm) const {
    const SegmentMotion motion(*kinematics_, segment);
    const MotionPart full_motion = motion.full_motion();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const std::size_t pair = (last_ + i) % pairs_.size();
        if (auto found = find_obstacle(pairs_[pair], motion, full_motion, clearance_mm)) {
            last_ = pair;
            return found;
        }
    }
    return std::nullopt;
}

std::optional<Obstacle> CollisionChecker::obstacle_at(const rrs::JointPos& joints,
                                                      double clearance_mm) const {
    const LinkFrames links = link_frames(*kinematics_, joints);
    for (const CandidatePair& pair : pairs_) {
        const DistanceBounds distance_bounds = pair.bodies.distance_at(links, clearance_mm);
        if (distance_bounds.upper_mm < clearance_mm)
            return Obstacle{pair.items, distance_bounds.upper_mm, 0, distance_bounds.point_mm};
    }
    return std::nullopt;
}

}  // namespace gsim::cell
