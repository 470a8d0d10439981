#include "collision/monitor/clear_way.h"

#include <utility>

#include "collision/cell/placed_kinematics.h"
#include "collision/pairs/segment_motion.h"

namespace gsim::cell {

namespace {

// Motion of the bodies in a part below which it is not halved any more.
constexpr double kShortest_mm = 1e-3;

// The middle is checked first: a collision is somewhere, and seldom at the very start.
std::optional<Obstacle> obstacle_of(const MeetingPair& pair, const LinkMotion& motion, const MotionPart& part,
                                    double clearance_mm) {
    const BodyPair& bodies = pair.bodies;
    const auto at = [&](const Nearness& nearness, double t_s) {
        return Obstacle{pair.items, nearness.upper_mm, t_s, nearness.point_mm};
    };
    std::vector<MotionPart> waiting{part};
    while (!waiting.empty()) {
        const MotionPart next = std::move(waiting.back());
        waiting.pop_back();
        if (bodies.nearness_in(next, clearance_mm).lower_mm >= clearance_mm) continue;
        const LinkFrames middle = motion.links_at(next.middle_s());
        const Nearness nearness = bodies.nearness_at(middle, clearance_mm);
        if (nearness.upper_mm < clearance_mm || bodies.bound(next).way_mm < kShortest_mm)
            return at(nearness, next.middle_s());
        waiting.push_back(motion.second_half(next, middle));
        waiting.push_back(motion.first_half(next, middle));
    }
    return std::nullopt;
}

}  // namespace

ClearWay::ClearWay(const Cell& cell, std::shared_ptr<const kinematics::Kinematics> kinematics)
    : cell_(&cell), kinematics_(std::move(kinematics)) {
    for (MeetingPair& pair : meeting_pairs(cell, *kinematics_)) {
        if (!pair.with_jet) pairs_.push_back(std::move(pair));
    }
}

tl::expected<ClearWay, std::string> ClearWay::make(const Cell& cell, const machine::Machine& machine) {
    if (!cell.carried.empty()) {
        return tl::unexpected<std::string>(
            "there is no way round the bodies of a cell in which frames go by themselves (on conveyors, or "
            "led "
            "by a program)");
    }
    return ClearWay(cell, placed_kinematics(machine::make_kinematics(machine), cell.frames));
}

std::optional<Obstacle> ClearWay::obstacle(const motion::Segment& segment, double clearance_mm) const {
    const SegmentMotion motion(*kinematics_, segment);
    const MotionPart whole = motion.whole();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const std::size_t pair = (last_ + i) % pairs_.size();
        if (auto found = obstacle_of(pairs_[pair], motion, whole, clearance_mm)) {
            last_ = pair;
            return found;
        }
    }
    return std::nullopt;
}

std::optional<Obstacle> ClearWay::obstacle_at(const rrs::JointPos& joints, double clearance_mm) const {
    const LinkFrames links = link_frames(*kinematics_, joints);
    for (const MeetingPair& pair : pairs_) {
        const Nearness nearness = pair.bodies.nearness_at(links, clearance_mm);
        if (nearness.upper_mm < clearance_mm)
            return Obstacle{pair.items, nearness.upper_mm, 0, nearness.point_mm};
    }
    return std::nullopt;
}

}  // namespace gsim::cell
