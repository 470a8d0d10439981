#include "runtime/outputs/tcp_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::simulation {

namespace {

constexpr double kTcpTolerance_mm = 1e-9;
constexpr double kMaxTurnStep_rad = std::numbers::pi / 4;  // max step at which turns are checked
constexpr int kMinCurveParts = 8;

}  // namespace

double min_part_count(const motion::Segment& segment, const WorkpieceTcp& tcp) {
    double rotation_rad = tcp.rotation_rad(segment.start, segment.end_position());
    if (segment.kind == motion::SegmentKind::circular) rotation_rad += segment.arc.sweep_rad;
    const double rotation_steps = std::min(std::ceil(rotation_rad / kMaxTurnStep_rad), kMaxParts);
    if (segment.kind == motion::SegmentKind::circular)
        return std::max<double>(kMinCurveParts, rotation_steps);
    const bool is_joint_straight = segment.kind == motion::SegmentKind::linear && !segment.superimposed &&
                                   segment.followers().empty() && !segment.orientation;
    return std::max<double>(is_joint_straight ? 1 : kMinCurveParts, rotation_steps);
}

double point_line_distance(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                           const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from;
    const double length2 = along.squaredNorm();
    if (length2 < kTcpTolerance_mm * kTcpTolerance_mm) return (point - from).norm();
    const double share = std::clamp((point - from).dot(along) / length2, 0.0, 1.0);
    return (point - from - share * along).norm();
}

}  // namespace gsim::simulation
