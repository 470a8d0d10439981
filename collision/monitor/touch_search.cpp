#include "collision/monitor/touch_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/cell/placed_kinematics.h"
#include "collision/pairs/segment_motion.h"

namespace gsim::cell {

namespace {

constexpr double kProbePointDiameter_mm = 1e-6;  // the diameter of a point
constexpr double kCheckStep_mm = 0.01;
constexpr double kCheckStep_rad = 1e-4;  // rad, if all motion is rotation
constexpr double kMaxChecks = 100'000;
constexpr double kContactTolerance_s = 1e-9;

/// Returns the number of parts into which a segment is cut, so that no body's path in one is longer than a
/// check step.
double check_count(const motion::Segment& segment) {
    const double rotation_rad = (segment.end - segment.start).cwiseAbs().maxCoeff();
    return std::clamp(std::ceil(std::max(segment.length_mm / kCheckStep_mm, rotation_rad / kCheckStep_rad)),
                      1.0, kMaxChecks);
}

}  // namespace

bool is_probe(const Cell& cell, std::size_t item) {
    if (cell.items[item].role == Role::jet) return false;
    const std::size_t tool = *cell.frames.find("tool");
    std::size_t frame = cell.items[item].frame;
    while (!cell.frames.is_machine_frame(frame)) frame = cell.frames.parent(frame);
    return frame == tool;
}

Result<TouchSearch> TouchSearch::make(const Cell& cell, const machine::Machine& machine,
                                      const Eigen::Vector3d& tcp_mm) {
    if (!cell.moving_frames.empty()) {
        return Unexpected(
            "a probe cannot detect the bodies of a cell with frames that move independently (on conveyors, "
            "or moved by a program); on_probe of a script, or --probe, defines the contact");
    }
    TouchSearch search(placed_kinematics(machine::make_kinematics(machine), cell.frames));
    bool has_body = false;
    for (std::size_t item = 0; item < cell.items.size(); ++item) has_body = has_body || is_probe(cell, item);
    if (!has_body) {
        search.add_probe_point_pairs(cell, tcp_mm);
        return search;
    }
    for (CandidatePair& pair : candidate_pairs(cell, *search.kinematics_)) {
        if (!pair.includes_jet && is_probe(cell, pair.items.first) != is_probe(cell, pair.items.second))
            search.pairs_.push_back(std::move(pair.bodies));
    }
    return search;
}

void TouchSearch::add_probe_point_pairs(const Cell& cell, const Eigen::Vector3d& tcp_mm) {
    probe_point_ = std::make_shared<const Shape>(Shape::sphere(kProbePointDiameter_mm));
    const std::size_t tool = *cell.frames.find("tool");
    const Body probe_point_body{probe_point_.get(), cell.frames.link(tool),
                                cell.frames.pose_in_link(tool) * Eigen::Translation3d(tcp_mm)};
    const std::vector<int> carrying_joints = joints_to(*kinematics_, probe_point_body.link);
    for (std::size_t item = 0; item < cell.items.size(); ++item) {
        if (cell.items[item].role == Role::jet) continue;
        const Body body = make_body(cell, item);
        if (std::find(carrying_joints.begin(), carrying_joints.end(), body.link - 1) != carrying_joints.end())
            continue;
        std::vector<int> between = joints_between(*kinematics_, probe_point_body.link, body.link);
        if (!between.empty()) pairs_.push_back({probe_point_body, body, std::move(between)});
    }
}

bool TouchSearch::touches(const rrs::JointPos& joints) const {
    const LinkFrames links = link_frames(*kinematics_, joints);
    return std::any_of(pairs_.begin(), pairs_.end(),
                       [&](const BodyPair& pair) { return pair.are_in_contact(links); });
}

std::optional<double> TouchSearch::first_touch_s(const motion::Segment& segment) const {
    const SegmentMotion motion(*kinematics_, segment);
    MotionPart part = motion.full_motion();
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
    const double sample_count = check_count(segment);
    double contact_s = 0;
    double clear_time_s = 0;
    for (double sample = 1; sample <= sample_count; ++sample) {
        clear_time_s = segment.duration_s * (sample / sample_count);
        if (!touches(segment.position_at(clear_time_s))) break;
        contact_s = clear_time_s;
    }
    if (contact_s >= segment.duration_s) return std::nullopt;
    while (clear_time_s - contact_s > kContactTolerance_s) {
        const double middle_s = contact_s + (clear_time_s - contact_s) / 2;
        (touches(segment.position_at(middle_s)) ? contact_s : clear_time_s) = middle_s;
    }
    return clear_time_s;
}

}  // namespace gsim::cell
