#include "runtime/outputs/tip_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::simulation {

namespace {

constexpr double kSameTip_mm = 1e-9;
constexpr double kTurnStep_rad = std::numbers::pi / 4;  // max step at which turns are checked
constexpr int kLeastOfCurve = 8;

}  // namespace

double least_parts(const motion::Segment& segment, const PartTip& tip) {
    double turned_rad = tip.turned_rad(segment.start, segment.end_position());
    if (segment.kind == motion::SegmentKind::circular) turned_rad += segment.arc.sweep_rad;
    const double turning = std::min(std::ceil(turned_rad / kTurnStep_rad), kMostParts);
    if (segment.kind == motion::SegmentKind::circular) return std::max<double>(kLeastOfCurve, turning);
    const bool straight_joints = segment.kind == motion::SegmentKind::linear && !segment.beside &&
                                 segment.followers().empty() && !segment.orientation;
    return std::max<double>(straight_joints ? 1 : kLeastOfCurve, turning);
}

double distance_from_line(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from;
    const double length2 = along.squaredNorm();
    if (length2 < kSameTip_mm * kSameTip_mm) return (point - from).norm();
    const double share = std::clamp((point - from).dot(along) / length2, 0.0, 1.0);
    return (point - from - share * along).norm();
}

}  // namespace gsim::simulation
