#include "toolpath/rotary/pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gsim::path {

namespace {

using Eigen::Vector3d;

constexpr int kDeepest = 24;  // halvings of one motion
constexpr double kQuarter_rad = std::numbers::pi / 2;
constexpr double kQuarter_deg = 90;
constexpr int kSamples = 16;  // at which an arc of coupled axes is looked at

}  // namespace

TipMotion::TipMotion(const MachineSpace& space, const Vector3d& start_mm, const Vector3d& end_mm,
                     const AxisValues& start_rotary, const AxisValues& end_rotary,
                     std::optional<ArcShape> arc)
    : space_(space),
      start_(start_mm),
      end_(end_mm),
      start_rotary_(start_rotary.size() == end_rotary.size() ? start_rotary : end_rotary),
      end_rotary_(end_rotary),
      arc_(std::move(arc)) {}

Vector3d TipMotion::tip(double share) const {
    if (share >= 1) return end_;
    return arc_ ? arc_->at(share) : Vector3d(start_ + share * (end_ - start_));
}

AxisValues TipMotion::at(double share) const {
    if (share >= 1) return space_.axes(end_, end_rotary_);
    return space_.axes(tip(share), start_rotary_ + share * (end_rotary_ - start_rotary_));
}

double TipMotion::length_mm() const {
    if (!arc_) return (end_ - start_).norm();
    return std::hypot(arc_->radius_mm() * arc_->turn_rad, arc_->rise_mm);
}

// Returns the number of parts of a stretch in which neither the arc nor an axis that moves the TCP turns more
// than a quarter.
int TipMotion::quarters(double from, double to) const {
    double most = arc_ ? arc_->turn_rad / kQuarter_rad : 0;
    if (space_.coupled() && end_rotary_.size() > 0) {
        most = std::max(most, (end_rotary_ - start_rotary_).cwiseAbs().maxCoeff() / kQuarter_deg);
    }
    return std::max(1, static_cast<int>(std::ceil(most * (to - from) - 1e-9)));
}

// Returns the deviation of the axes' path from the straight line between two of its points, checked four
// times in each quarter turn.
double TipMotion::deviation(double from, double to) const {
    const Vector3d first = space_.linear(at(from));
    const Vector3d last = space_.linear(at(to));
    double greatest = 0;
    const int samples = 4 * quarters(from, to);
    for (int i = 1; i < samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const Vector3d wanted = space_.linear(at(from + share * (to - from)));
        greatest = std::max(greatest, (wanted - first - share * (last - first)).norm());
    }
    return greatest;
}

bool TipMotion::tilts_over_the_upright() const {
    constexpr double kLeast_rad = 1e-3;
    constexpr double kMostOfEnds = 0.7;  // value on the shortest path between two axes a quarter turn apart
    if (!arc_ || turn_deg() == 0) return false;
    const auto lean_rad = [&](double share) {
        const Vector3d axis = space_.tool_axis(at(share));
        return std::atan2(axis.cross(arc_->normal).norm(), std::abs(axis.dot(arc_->normal)));
    };
    const double at_ends_rad = std::min(lean_rad(0), lean_rad(1));
    return at_ends_rad >= kLeast_rad && lean_rad(0.5) <= kMostOfEnds * at_ends_rad;
}

bool TipMotion::is_line_of_axes(double tolerance_mm) const {
    if (arc_) return false;
    if (!space_.coupled() || turn_deg() == 0) return true;
    return deviation(0, 1) <= tolerance_mm;
}

void TipMotion::cut(double tolerance_mm, const std::function<void(double share)>& piece) const {
    const int pieces = quarters(0, 1);
    struct Halver {
        const TipMotion& motion;
        double tolerance;
        const std::function<void(double)>& piece;

        void run(double from, double to, int depth) const {
            if (depth == kDeepest || motion.deviation(from, to) <= tolerance) return piece(to);
            run(from, (from + to) / 2, depth + 1);
            run((from + to) / 2, to, depth + 1);
        }
    };
    const Halver halver{*this, tolerance_mm, piece};
    for (int i = 0; i < pieces; ++i) {
        halver.run(static_cast<double>(i) / pieces, static_cast<double>(i + 1) / pieces, 0);
    }
}

std::optional<AxisArc> TipMotion::axis_arc(double from, double to, double tolerance_mm) const {
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
    if (!space_.coupled() || turn_deg() == 0) return arc;

    // If turning moves the linear axes, their path is an arc by chance only.
    const Vector3d end = space_.linear(at(to));
    const double sense = arc.counterclockwise ? 1 : -1;
    const Vector3d axis = sense * Vector3d::Unit(about);
    for (int i = 1; i <= kSamples; ++i) {
        const double share = static_cast<double>(i) / kSamples;
        const Eigen::AngleAxisd turn(share * (to - from) * arc_->turn_rad, axis);
        Vector3d expected = start + offset - turn * offset;
        expected[about] = start[about] + share * (end[about] - start[about]);
        const Vector3d wanted = space_.linear(at(from + share * (to - from)));
        if ((wanted - expected).norm() > tolerance_mm) return std::nullopt;
    }
    return arc;
}

std::optional<AxisArc> TipMotion::oblique_arc(double from, double to, double tolerance_mm) const {
    if (std::abs(arc_->rise_mm * (to - from)) > tolerance_mm / 2) return std::nullopt;
    if (space_.coupled() && turn_deg() > 0) return std::nullopt;
    const Vector3d via = space_.linear(at((from + to) / 2));
    AxisArc arc;
    arc.via_mm = {via.x(), via.y(), via.z()};
    return arc;
}

double TipMotion::turn_deg() const {
    return (end_rotary_ - start_rotary_).norm();
}

}  // namespace gsim::path
