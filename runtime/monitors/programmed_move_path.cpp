#include "runtime/monitors/programmed_move_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "motion/path/axis_space.h"

namespace gsim::simulation {

using Eigen::Vector3d;
using motion::SegmentKind;

namespace {

constexpr double kStep_rad = 0.1;  // from point to point of a curve
constexpr double kMaxSteps = 20'000;
constexpr int kSearchSteps = 24;

/// Returns the smallest value of a function of one variable between two values, if it falls and then rises
/// there. The search drops thirds of the range.
template <typename Function>
double min_between(double from, double to, int steps, const Function& function) {
    constexpr double kInverseGoldenRatio = 0.6180339887498949;
    double a = to - kInverseGoldenRatio * (to - from), b = from + kInverseGoldenRatio * (to - from);
    double at_a = function(a), at_b = function(b);
    for (int i = 0; i < steps; ++i) {
        if (at_a < at_b) {
            to = b;
            b = a;
            at_b = at_a;
            a = to - kInverseGoldenRatio * (to - from);
            at_a = function(a);
        } else {
            from = a;
            a = b;
            at_a = at_b;
            b = from + kInverseGoldenRatio * (to - from);
            at_b = function(b);
        }
    }
    return std::min(at_a, at_b);
}

std::size_t nearest(const Vector3d& point, std::span<const Vector3d> curve) {
    std::size_t near = 0;
    double min = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double square = (curve[i] - point).squaredNorm();
        if (square < min) {
            min = square;
            near = i;
        }
    }
    return near;
}

double turn_rad(const motion::PathMove& move, const std::array<int, 3>& position_joints) {
    double turn = move.kind == SegmentKind::circular ? move.arc.sweep_rad : 0;
    for (int joint = 0; joint < move.start.size(); ++joint) {
        if (std::find(position_joints.begin(), position_joints.end(), joint) == position_joints.end())
            turn += std::abs(move.end[joint] - move.start[joint]);
    }
    return turn;
}

}  // namespace

double distance_to_line(const Vector3d& point, const Vector3d& start, const Vector3d& end) {
    const Vector3d displacement = end - start, to_point = point - start;
    const double square = displacement.squaredNorm();
    const double share = square > 0 ? std::clamp(to_point.dot(displacement) / square, 0.0, 1.0) : 0;
    return (to_point - share * displacement).norm();
}

double distance_to_chords(const Vector3d& point, std::span<const Vector3d> curve) {
    if (curve.size() == 2) return distance_to_line(point, curve[0], curve[1]);
    const std::size_t near = nearest(point, curve);
    double min = std::numeric_limits<double>::infinity();
    if (near > 0) min = distance_to_line(point, curve[near - 1], curve[near]);
    if (near + 1 < curve.size()) min = std::min(min, distance_to_line(point, curve[near], curve[near + 1]));
    return min;
}

double distance_to_curve(const Vector3d& point, std::span<const Vector3d> curve) {
    if (curve.size() == 2) return distance_to_line(point, curve[0], curve[1]);
    const std::size_t middle = std::clamp<std::size_t>(nearest(point, curve), 1, curve.size() - 2);
    const Vector3d& at = curve[middle];
    const Vector3d slope = (curve[middle + 1] - curve[middle - 1]) / 2;
    const Vector3d curvature = (curve[middle + 1] - 2 * at + curve[middle - 1]) / 2;
    return std::sqrt(min_between(-1, 1, kSearchSteps, [&](double u) {
        return (at + u * slope + u * u * curvature - point).squaredNorm();
    }));
}

ProgrammedMovePath::ProgrammedMovePath(const motion::PathMove& move,
                                       const std::array<int, 3>& position_joints,
                                       std::shared_ptr<WorkpieceTcp> tcp, const SourceLocation& location)
    : id_(move.target_id), rapid_(move.rapid), location_(location), tcp_(std::move(tcp)) {
    const bool turns = tcp_->turns(move.start, move.end);
    if (!turns) tcp_->set_position(move.start);
    ends_ = {tcp_->at(move.start), tcp_->at(move.end)};
    if (turns || move.kind == SegmentKind::circular)
        curve_ = std::make_unique<Curve>(Curve{move, position_joints});
}

Vector3d ProgrammedMovePath::at(double share) const {
    const motion::PathMove& move = curve_->move;
    rrs::JointPos joints = move.start + share * (move.end - move.start);
    if (move.kind == SegmentKind::circular) {
        const double phi_rad = move.arc.phi_at(share * move.arc.length_mm());
        motion::write_position(curve_->position_joints, move.arc.at(phi_rad), joints);
    }
    if (move.orientation) {
        const motion::HeadAngles angles = move.orientation->at(share * move.orientation->length_rad()).angles;
        joints[move.orientation->turn_joint()] = angles.turn;
        joints[move.orientation->tilt_joint()] = angles.tilt;
    }
    return tcp_->at(joints);
}

std::span<const Vector3d> ProgrammedMovePath::points() {
    if (!curve_) return ends_;
    std::vector<Vector3d>& points = curve_->points;
    if (!points.empty()) return points;
    if (!tcp_->turns(curve_->move.start, curve_->move.end)) tcp_->set_position(curve_->move.start);
    const double turn = turn_rad(curve_->move, curve_->position_joints);
    const int steps = static_cast<int>(std::clamp(std::ceil(turn / kStep_rad), 2.0, kMaxSteps));
    points.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i) points.push_back(at(static_cast<double>(i) / steps));
    points.front() = start();
    points.back() = end();
    return points;
}

double ProgrammedMovePath::distance(const Vector3d& point, double cutoff) {
    if (!curve_) return distance_to_line(point, start(), end());
    const std::span<const Vector3d> curve = points();
    const std::size_t near = nearest(point, curve);
    const double distance_at_point = (curve[near] - point).norm();
    if (distance_at_point <= cutoff) return distance_at_point;
    const double step = 1.0 / static_cast<double>(curve.size() - 1);
    const double from = step * (near > 0 ? static_cast<double>(near - 1) : 0.0);
    const double to = std::min(1.0, step * static_cast<double>(near + 1));
    const double between =
        min_between(from, to, kSearchSteps, [&](double share) { return (at(share) - point).norm(); });
    return std::min(distance_at_point, between);
}

}  // namespace gsim::simulation
