#include "motion/planner/time_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "motion/profile/quadratic.h"

namespace gsim::motion {

namespace {

using rrs::JointPos;

// No product below overflows or vanishes within these limits; no value in a workshop comes near them.
constexpr double kMinValue = 1e-100;
constexpr double kInfeasible = 1e100;
constexpr double kMaxTimeScale = 1e50;
constexpr double kMaxCells = 1e6;

double sanitized(double value) {
    return value > 0 ? std::clamp(value, kMinValue, kInfeasible) : kInfeasible;
}

JointPos sanitized(JointPos limits) {
    for (Eigen::Index joint = 0; joint < limits.size(); ++joint) limits[joint] = sanitized(limits[joint]);
    return limits;
}

bool is_usable(const JointPos& values, Eigen::Index joint) {
    return joint < values.size() && std::abs(values[joint]) <= kMaxTimeScale;
}

// Returns the largest area that |f| can enclose over `length` if it changes from f0 to f1 with slopes up to
// `slope`: a roof over its ends.
double max_travel(double length, double f0, double f1, double slope) {
    const double acceleration_length = slope * length;
    const double peak = std::max(0.0, (squared(acceleration_length) - squared(f1 - f0)) / (4 * slope));
    return length * ((f0 + f1) / 2) + peak;
}

// Band -down <= q2 y + q1 a <= up: y is the square of the path speed and a its acceleration; q1 >= 0.
struct AccelerationBand {
    double q2;
    double q1;
    double up;
    double down;
};

// Returns the highest y for which some a keeps both bands: the upper edge of one meets the lower edge of the
// other there.
double max_common_speed2(const AccelerationBand& one, const AccelerationBand& other) {
    const double determinant = one.q2 * other.q1 - other.q2 * one.q1;
    const double acceleration_range =
        determinant > 0 ? one.up * other.q1 + other.down * one.q1 : other.up * one.q1 + one.down * other.q1;
    return determinant == 0 ? squared(kInfeasible) : acceleration_range / std::abs(determinant);
}

}  // namespace

TimeBound::TimeBound(JointLimits limits, TimeBoundGrid grid)
    : limits_{sanitized(std::move(limits.max_speed)), sanitized(std::move(limits.max_acceleration))},
      grid_(grid) {
    grid_.window = std::max<std::size_t>(grid_.window, 2);
}

void TimeBound::begin() {
    sub_segments_.clear();
    joints_.clear();
    front_speed2_ = 0;
    finalized_s_ = 0;
}

void TimeBound::stop() {
    finalize_all(0);
    front_speed2_ = 0;
}

void TimeBound::change_measure() {
    finalize_all(front_speed2_);
    front_speed2_ = squared(kInfeasible);
}

double TimeBound::bound_s() const {
    BackwardPass pass = start_backward_pass(0);
    run_backward_pass(pass, 0);
    return finalized_s_ + pass.time_s;
}

TimeBound::MotionLimits TimeBound::squared_limits(const PathCaps& caps) {
    return {squared(sanitized(caps.max_speed)), sanitized(caps.max_acceleration),
            sanitized(caps.max_deceleration)};
}

void TimeBound::add_line(double length, const PathCaps& caps) {
    if (!(length > kMinValue)) return;
    const MotionLimits motion_limits = squared_limits(caps);
    add_sub_segment({std::min(length, kInfeasible), motion_limits, 0, 0}, motion_limits.speed2,
                    motion_limits.speed2);
}

void TimeBound::add_line(double length, const JointPos& q1, const PathCaps& caps) {
    PathCaps all = caps;
    const auto lower = [](double& cap, double other) { cap = sanitized(cap) < other ? cap : other; };
    for (Eigen::Index joint = 0; joint < q1.size(); ++joint) {
        const double share = is_usable(q1, joint) ? std::abs(q1[joint]) : 0;
        if (share == 0) continue;
        if (joint < limits_.max_speed.size()) lower(all.max_speed, limits_.max_speed[joint] / share);
        if (joint >= limits_.max_acceleration.size()) continue;
        lower(all.max_acceleration, limits_.max_acceleration[joint] / share);
        lower(all.max_deceleration, limits_.max_acceleration[joint] / share);
    }
    add_line(length, all);
}

void TimeBound::add_curve(const Curve& curve, const PathCaps& caps) {
    if (!(curve.length > kMinValue) || curve.length > kInfeasible || !curve.at) return;
    const double requested = std::ceil(curve.turn_rad / grid_.cell_rad);
    const int cells = requested > 1 ? static_cast<int>(std::min(requested, kMaxCells)) : 1;
    const double length = curve.length / cells;
    const MotionLimits path = squared_limits(caps);
    CurvePoint start = curve.at(0);
    for (int cell = 1; cell <= cells; ++cell) {
        CurvePoint end = curve.at(cell < cells ? cell * length : curve.length);
        add_cell(length, start, end, curve, path);
        start = std::move(end);
    }
}

// A cell errs to the low side, because each of these holds for every law that keeps the limits:
// - at the nodes, the caps of node_speed2(), which are the limits at that position;
// - from node to node, with the joint's speed u = q1 v: d(u^2)/ds = 2 u (du/dt) / v = 2 q1 (du/dt), so that
//   u^2 changes by no more than 2 max_acceleration times what the joint travels, wherever it moves and turns;
// - the time of the cell is not less than that of any one joint (and of the path) that covers its distance
//   alone, as fast as speeds at the nodes and its limits allow.
// The passes take the highest speeds at the nodes that these allow. All of them have the form "no more than a
// rising function of the speed at the neighbouring node", and times fall as speeds rise, so no law beats the
// sum. Neither q1 nor q2 is interpolated. The second becomes |q2 v^2 + q1 a| <= max_acceleration as cells
// shrink.
void TimeBound::add_cell(double length, const CurvePoint& start, const CurvePoint& end, const Curve& curve,
                         const MotionLimits& path) {
    std::size_t count = 0;
    const Eigen::Index joints = std::min(limits_.max_speed.size(), limits_.max_acceleration.size());
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
        const double max_q2 = joint < curve.max_q2.size() ? std::abs(curve.max_q2[joint]) : kInfeasible;
        if (add_joint_cell(joint, length, start, end, max_q2)) ++count;
    }
    add_sub_segment({length, path, 0, count}, node_speed2(start, path), node_speed2(end, path));
}

// The distance of a joint that cannot turn back in the cell is known exactly: q1 = 0 at some position would
// make |q1| at the ends no more than max_q2 times their distances to it.
bool TimeBound::add_joint_cell(Eigen::Index joint, double length, const CurvePoint& start,
                               const CurvePoint& end, double max_q2) {
    for (const JointPos* values : {&start.q, &start.q1, &end.q, &end.q1}) {
        if (!is_usable(*values, joint)) return false;
    }
    const double share0 = std::abs(start.q1[joint]);
    const double share1 = std::abs(end.q1[joint]);
    const double distance = std::abs(end.q[joint] - start.q[joint]);
    const bool is_monotonic = share0 + share1 > max_q2 * length;
    if (!is_monotonic && !(max_q2 > 0 && max_q2 <= kMaxTimeScale)) return false;
    const double travel = is_monotonic ? distance : max_travel(length, share0, share1, max_q2);
    const double acceleration = limits_.max_acceleration[joint];
    joints_.push_back({squared(share0),
                       squared(share1),
                       2 * acceleration * travel,
                       distance,
                       {squared(limits_.max_speed[joint]), acceleration, acceleration}});
    return true;
}

double TimeBound::node_speed2(const CurvePoint& point, const MotionLimits& path) const {
    std::array<AccelerationBand, rrs::kMaxJoints + 1> acceleration_bands;
    std::size_t count = 0;
    acceleration_bands[count++] = {0, 1, path.acceleration, path.deceleration};
    double speed2 = path.speed2;
    for (Eigen::Index joint = 0; joint < limits_.max_speed.size(); ++joint) {
        const double share = is_usable(point.q1, joint) ? std::abs(point.q1[joint]) : 0;
        if (share > 0) speed2 = std::min(speed2, squared(limits_.max_speed[joint] / share));
    }
    for (Eigen::Index joint = 0; joint < limits_.max_acceleration.size(); ++joint) {
        if (!is_usable(point.q1, joint) || !is_usable(point.q2, joint)) continue;
        const double q1 = point.q1[joint];
        const double q2 = point.q2[joint];
        const double max = limits_.max_acceleration[joint];
        acceleration_bands[count] = {q1 < 0 ? -q2 : q2, std::abs(q1), max, max};
        for (std::size_t other = 0; other < count; ++other) {
            speed2 =
                std::min(speed2, max_common_speed2(acceleration_bands[count], acceleration_bands[other]));
        }
        ++count;
    }
    return speed2;
}

void TimeBound::add_sub_segment(const SubSegment& sub_segment, double start_cap2, double end_cap2) {
    const double start2 = std::min(front_speed2_, start_cap2);
    front_speed2_ =
        std::min(end_cap2, start2 + 2 * sub_segment.motion_limits.acceleration * sub_segment.length);
    for (std::size_t i = joints_.size() - sub_segment.joint_count; i < joints_.size(); ++i) {
        const JointCell& joint = joints_[i];
        front_speed2_ = std::min(front_speed2_,
                                 (joint.slope_squared_start * start2 + joint.gain) / joint.slope_squared_end);
    }
    sub_segments_.push_back(sub_segment);
    sub_segments_.back().start_speed2 = start2;
    if (sub_segments_.size() >= grid_.window) finalize_older_half();
}

void TimeBound::run_backward_pass(BackwardPass& pass, std::size_t first) const {
    while (pass.sub_segments > first) {
        const SubSegment& sub_segment = sub_segments_[--pass.sub_segments];
        const std::size_t joints_end = pass.joints;
        pass.joints -= sub_segment.joint_count;
        const double end2 = pass.speed2;
        double start2 = std::min(sub_segment.start_speed2,
                                 end2 + 2 * sub_segment.motion_limits.deceleration * sub_segment.length);
        for (std::size_t i = pass.joints; i < joints_end; ++i) {
            const JointCell& joint = joints_[i];
            start2 =
                std::min(start2, (joint.slope_squared_end * end2 + joint.gain) / joint.slope_squared_start);
        }
        double time_s = min_time_s(sub_segment.length, start2, end2, sub_segment.motion_limits);
        for (std::size_t i = pass.joints; i < joints_end; ++i) {
            const JointCell& joint = joints_[i];
            time_s = std::max(time_s, min_time_s(joint.distance, joint.slope_squared_start * start2,
                                                 joint.slope_squared_end * end2, joint.motion_limits));
        }
        pass.speed2 = start2;
        pass.time_s += time_s;
    }
}

// Returns the time of the trapezoid between speeds with squares of at most start2 and end2. The three
// distances add up to `length` exactly, so that a split that suffers from cancellation does not harm the
// time.
double TimeBound::min_time_s(double length, double start2, double end2, const MotionLimits& motion_limits) {
    const double up = motion_limits.acceleration;
    const double down = motion_limits.deceleration;
    const double to2 = std::min(end2, start2 + 2 * up * length);
    const double from2 = std::min(start2, to2 + 2 * down * length);
    const double peak_limit2 = (down * from2 + up * to2 + 2 * up * down * length) / (up + down);
    const double top2 = std::min(motion_limits.speed2, peak_limit2);
    if (!(top2 > 0)) return 0;
    const double top = std::sqrt(top2);
    const double acceleration_length = std::clamp((top2 - from2) / (2 * up), 0.0, length);
    const double deceleration_length =
        std::clamp((top2 - to2) / (2 * down), 0.0, length - acceleration_length);
    return 2 * acceleration_length / (top + std::sqrt(from2)) +
           2 * deceleration_length / (top + std::sqrt(to2)) +
           (length - acceleration_length - deceleration_length) / top;
}

void TimeBound::finalize_all(double end2) {
    BackwardPass pass = start_backward_pass(end2);
    run_backward_pass(pass, 0);
    finalized_s_ += pass.time_s;
    sub_segments_.clear();
    joints_.clear();
}

// A later stop can lower the speeds before it only as far as braking from the caps reaches. That is commonly
// less than the newer half, and the older half is final. Otherwise the newest end is taken at its highest
// speed, which no continuation exceeds: still a lower bound.
void TimeBound::finalize_older_half() {
    const std::size_t half = sub_segments_.size() / 2;
    BackwardPass pass = start_backward_pass(front_speed2_);
    run_backward_pass(pass, half);
    const std::size_t joints_before = pass.joints;
    pass.time_s = 0;
    run_backward_pass(pass, 0);
    finalized_s_ += pass.time_s;
    sub_segments_.erase(sub_segments_.begin(), sub_segments_.begin() + static_cast<std::ptrdiff_t>(half));
    joints_.erase(joints_.begin(), joints_.begin() + static_cast<std::ptrdiff_t>(joints_before));
}

}  // namespace gsim::motion
