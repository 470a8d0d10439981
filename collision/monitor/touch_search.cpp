#include "collision/monitor/touch_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/cell/placed_kinematics.h"
#include "collision/pairs/segment_motion.h"

namespace gsim::cell {

namespace {

constexpr double kTip_mm = 1e-6;  // the diameter of a point
constexpr double kLook_mm = 0.01;
constexpr double kTurnedLook = 1e-4;  // rad, if all motion is rotation
constexpr double kMostLooks = 100'000;
constexpr double kInstant_s = 1e-9;

/// Returns the number of parts into which a segment is cut, so that no body's path in one is longer than a
/// check step.
double look_count(const motion::Segment& segment) {
    const double turned_rad = (segment.end - segment.start).cwiseAbs().maxCoeff();
    return std::clamp(std::ceil(std::max(segment.length_mm / kLook_mm, turned_rad / kTurnedLook)), 1.0,
                      kMostLooks);
}

}  // namespace

bool probes(const Cell& cell, std::size_t item) {
    if (cell.items[item].role == Role::jet) return false;
    const std::size_t tool = *cell.frames.find("tool");
    std::size_t frame = cell.items[item].frame;
    while (!cell.frames.is_of_machine(frame)) frame = cell.frames.parent(frame);
    return frame == tool;
}

tl::expected<TouchSearch, std::string> TouchSearch::make(const Cell& cell, const machine::Machine& machine,
                                                         const Eigen::Vector3d& tip_mm) {
    if (!cell.carried.empty()) {
        return tl::unexpected<std::string>(
            "a probe cannot feel the bodies of a cell in which frames go by themselves (on conveyors, or led "
            "by a program); on_probe of a script, or --probe, says where it touches");
    }
    TouchSearch search(placed_kinematics(machine::make_kinematics(machine), cell.frames));
    bool has_body = false;
    for (std::size_t item = 0; item < cell.items.size(); ++item) has_body = has_body || probes(cell, item);
    if (!has_body) {
        search.add_tip_pairs(cell, tip_mm);
        return search;
    }
    for (MeetingPair& pair : meeting_pairs(cell, *search.kinematics_)) {
        if (!pair.with_jet && probes(cell, pair.items.first) != probes(cell, pair.items.second))
            search.pairs_.push_back(std::move(pair.bodies));
    }
    return search;
}

void TouchSearch::add_tip_pairs(const Cell& cell, const Eigen::Vector3d& tip_mm) {
    tip_ = std::make_shared<const Shape>(Shape::sphere(kTip_mm));
    const std::size_t tool = *cell.frames.find("tool");
    const Body tip{tip_.get(), cell.frames.link(tool),
                   cell.frames.in_link(tool) * Eigen::Translation3d(tip_mm)};
    const std::vector<int> carrying = joints_to(*kinematics_, tip.link);
    for (std::size_t item = 0; item < cell.items.size(); ++item) {
        if (cell.items[item].role == Role::jet) continue;
        const Body body = body_of(cell, item);
        if (std::find(carrying.begin(), carrying.end(), body.link - 1) != carrying.end()) continue;
        std::vector<int> between = joints_between(*kinematics_, tip.link, body.link);
        if (!between.empty()) pairs_.push_back({tip, body, std::move(between)});
    }
}

bool TouchSearch::touches(const rrs::JointPos& joints) const {
    const LinkFrames links = link_frames(*kinematics_, joints);
    return std::any_of(pairs_.begin(), pairs_.end(),
                       [&](const BodyPair& pair) { return pair.touch_at(links); });
}

std::optional<double> TouchSearch::first_touch_s(const motion::Segment& segment) const {
    const SegmentMotion motion(*kinematics_, segment);
    MotionPart part = motion.whole();
    std::optional<double> first_s;
    for (const BodyPair& pair : pairs_) {
        const auto touch = pair.first_touch(motion, part);
        if (!touch) continue;
        first_s = touch->t_s;
        part = motion.between(0, *first_s);
    }
    return first_s;
}

std::optional<double> TouchSearch::first_release_s(const motion::Segment& segment) const {
    const double looks = look_count(segment);
    double touching_s = 0;
    double free_s = 0;
    for (double look = 1; look <= looks; ++look) {
        free_s = segment.duration_s * (look / looks);
        if (!touches(segment.position_at(free_s))) break;
        touching_s = free_s;
    }
    if (touching_s >= segment.duration_s) return std::nullopt;
    while (free_s - touching_s > kInstant_s) {
        const double middle_s = touching_s + (free_s - touching_s) / 2;
        (touches(segment.position_at(middle_s)) ? touching_s : free_s) = middle_s;
    }
    return free_s;
}

}  // namespace gsim::cell
