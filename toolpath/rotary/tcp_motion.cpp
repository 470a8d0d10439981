#include "toolpath/rotary/tcp_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gsim::path {

namespace {

using Eigen::Vector3d;

constexpr int kMaxHalvings = 24;  // halvings of one motion
constexpr double kQuarter_rad = std::numbers::pi / 2;
constexpr double kQuarter_deg = 90;
constexpr int kSamples = 16;  // at which an arc of coupled axes is looked at

}  // namespace

TcpMotion::TcpMotion(const MachineSpace& space, const Vector3d& start_mm, const Vector3d& end_mm,
                     const AxisValues& start_rotary, const AxisValues& end_rotary,
                     std::optional<ArcShape> arc)
    : space_(space),
      start_(start_mm),
      end_(end_mm),
      start_rotary_(start_rotary.size() == end_rotary.size() ? start_rotary : end_rotary),
      end_rotary_(end_rotary),
      arc_(std::move(arc)) {}

Vector3d TcpMotion::tcp(double share) const {
    if (share >= 1) return end_;
    return arc_ ? arc_->at(share) : Vector3d(start_ + share * (end_ - start_));
}

AxisValues TcpMotion::at(double share) const {
    if (share >= 1) return space_.axes(end_, end_rotary_);
    return space_.axes(tcp(share), start_rotary_ + share * (end_rotary_ - start_rotary_));
}

double TcpMotion::length_mm() const {
    if (!arc_) return (end_ - start_).norm();
    return std::hypot(arc_->radius_mm() * arc_->turn_rad, arc_->rise_mm);
}

// Returns the number of parts of a stretch in which neither the arc nor an axis that moves the TCP turns more
// than a quarter.
int TcpMotion::quarter_turn_count(double from, double to) const {
    double max = arc_ ? arc_->turn_rad / kQuarter_rad : 0;
    if (space_.is_coupled() && end_rotary_.size() > 0) {
        max = std::max(max, (end_rotary_ - start_rotary_).cwiseAbs().maxCoeff() / kQuarter_deg);
    }
    return std::max(1, static_cast<int>(std::ceil(max * (to - from) - 1e-9)));
}

// Returns the deviation of the axes' path from the straight line between two of its points, checked four
// times in each quarter turn.
double TcpMotion::deviation(double from, double to) const {
    const Vector3d first = space_.linear(at(from));
    const Vector3d last = space_.linear(at(to));
    double max = 0;
    const int samples = 4 * quarter_turn_count(from, to);
    for (int i = 1; i < samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const Vector3d requested = space_.linear(at(from + share * (to - from)));
        max = std::max(max, (requested - first - share * (last - first)).norm());
    }
    return max;
}

bool TcpMotion::tilts_through_vertical() const {
    constexpr double kMinTilt_rad = 1e-3;
    constexpr double kMaxMidTiltRatio =
        0.7;  // value on the shortest path between two axes a quarter turn apart
    if (!arc_ || turn_deg() == 0) return false;
    const auto tilt_rad = [&](double share) {
        const Vector3d axis = space_.tool_axis(at(share));
        return std::atan2(axis.cross(arc_->normal).norm(), std::abs(axis.dot(arc_->normal)));
    };
    const double end_tilt_rad = std::min(tilt_rad(0), tilt_rad(1));
    return end_tilt_rad >= kMinTilt_rad && tilt_rad(0.5) <= kMaxMidTiltRatio * end_tilt_rad;
}

bool TcpMotion::is_axis_line(double tolerance_mm) const {
    if (arc_) return false;
    if (!space_.is_coupled() || turn_deg() == 0) return true;
    return deviation(0, 1) <= tolerance_mm;
}

void TcpMotion::cut(double tolerance_mm, const std::function<void(double share)>& on_part) const {
    const int parts = quarter_turn_count(0, 1);
    struct Bisector {
        const TcpMotion& motion;
        double tolerance;
        const std::function<void(double)>& on_part;

        void run(double from, double to, int depth) const {
            if (depth == kMaxHalvings || motion.deviation(from, to) <= tolerance) return on_part(to);
            run(from, (from + to) / 2, depth + 1);
            run((from + to) / 2, to, depth + 1);
        }
    };
    const Bisector bisector{*this, tolerance_mm, on_part};
    for (int i = 0; i < parts; ++i) {
        bisector.run(static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts, 0);
    }
}

std::optional<AxisArc> TcpMotion::axis_arc(double from, double to, double tolerance_mm) const {
    const AxisValues rotary = start_rotary_ + from * (end_rotary_ - start_rotary_);
    const double rise = arc_->rise_mm * (to - from);
    const Vector3d center =
        space_.linear(space_.axes(arc_->center + arc_->rise_mm * from * arc_->normal, rotary));
    const Vector3d above =
        space_.linear(space_.axes(arc_->center + (arc_->rise_mm * from + 1) * arc_->normal, rotary));
    const Vector3d normal = (above - center).normalized();
    Eigen::Index about = 0;
    normal.cwiseAbs().maxCoeff(&about);
    const double tilt = std::hypot(normal[(about + 1) % 3], normal[(about + 2) % 3]);
    if (tilt * (2 * arc_->radius_mm() + std::abs(rise)) > tolerance_mm / 2) return std::nullopt;

    AxisArc arc;
    arc.about = static_cast<int>(about);
    arc.counterclockwise = normal[about] > 0;
    const Vector3d start = space_.linear(at(from));
    Vector3d offset = center - start;
    offset[about] = 0;
    arc.center_offset_mm = {offset.x(), offset.y(), offset.z()};
    if (!space_.is_coupled() || turn_deg() == 0) return arc;

    // If turning moves the linear axes, their path is an arc by chance only.
    const Vector3d end = space_.linear(at(to));
    const double sense = arc.counterclockwise ? 1 : -1;
    const Vector3d axis = sense * Vector3d::Unit(about);
    for (int i = 1; i <= kSamples; ++i) {
        const double share = static_cast<double>(i) / kSamples;
        const Eigen::AngleAxisd turn(share * (to - from) * arc_->turn_rad, axis);
        Vector3d expected = start + offset - turn * offset;
        expected[about] = start[about] + share * (end[about] - start[about]);
        const Vector3d requested = space_.linear(at(from + share * (to - from)));
        if ((requested - expected).norm() > tolerance_mm) return std::nullopt;
    }
    return arc;
}

std::optional<AxisArc> TcpMotion::oblique_arc(double from, double to, double tolerance_mm) const {
    if (std::abs(arc_->rise_mm * (to - from)) > tolerance_mm / 2) return std::nullopt;
    if (space_.is_coupled() && turn_deg() > 0) return std::nullopt;
    const Vector3d via = space_.linear(at((from + to) / 2));
    AxisArc arc;
    arc.via_mm = {via.x(), via.y(), via.z()};
    return arc;
}

double TcpMotion::turn_deg() const {
    return (end_rotary_ - start_rotary_).norm();
}

}  // namespace gsim::path
