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
constexpr double kLeastValue = 1e-100;
constexpr double kMostValue = 1e100;
constexpr double kMostShare = 1e50;
constexpr double kMostCells = 1e6;

double sane(double value) {
    return value > 0 ? std::clamp(value, kLeastValue, kMostValue) : kMostValue;
}

JointPos sane(JointPos limits) {
    for (Eigen::Index joint = 0; joint < limits.size(); ++joint) limits[joint] = sane(limits[joint]);
    return limits;
}

bool usable(const JointPos& values, Eigen::Index joint) {
    return joint < values.size() && std::abs(values[joint]) <= kMostShare;
}

// Returns the largest area that |f| can enclose over `length` if it changes from f0 to f1 with slopes up to
// `slope`: a roof over its ends.
double most_travel(double length, double f0, double f1, double slope) {
    const double rise = slope * length;
    const double peak = std::max(0.0, (squared(rise) - squared(f1 - f0)) / (4 * slope));
    return length * ((f0 + f1) / 2) + peak;
}

// Band -down <= q2 y + q1 a <= up: y is the square of the path speed and a its acceleration; q1 >= 0.
struct Band {
    double q2;
    double q1;
    double up;
    double down;
};

// Returns the highest y for which some a keeps both bands: the upper edge of one meets the lower edge of the
// other there.
double meeting_speed2(const Band& one, const Band& other) {
    const double apart = one.q2 * other.q1 - other.q2 * one.q1;
    const double room =
        apart > 0 ? one.up * other.q1 + other.down * one.q1 : other.up * one.q1 + one.down * other.q1;
    return apart == 0 ? squared(kMostValue) : room / std::abs(apart);
}

}  // namespace

TimeBound::TimeBound(JointLimits limits, TimeBoundGrid grid)
    : limits_{sane(std::move(limits.max_speed)), sane(std::move(limits.max_acceleration))}, grid_(grid) {
    grid_.window = std::max<std::size_t>(grid_.window, 2);
}

void TimeBound::begin() {
    pieces_.clear();
    joints_.clear();
    front_speed2_ = 0;
    settled_s_ = 0;
}

void TimeBound::stop() {
    settle_all(0);
    front_speed2_ = 0;
}

void TimeBound::change_measure() {
    settle_all(front_speed2_);
    front_speed2_ = squared(kMostValue);
}

double TimeBound::bound_s() const {
    Backward pass = at_front(0);
    go_back(pass, 0);
    return settled_s_ + pass.time_s;
}

TimeBound::Reach TimeBound::reach_of(const PathCaps& caps) {
    return {squared(sane(caps.max_speed)), sane(caps.max_acceleration), sane(caps.max_deceleration)};
}

void TimeBound::add_line(double length, const PathCaps& caps) {
    if (!(length > kLeastValue)) return;
    const Reach reach = reach_of(caps);
    add_piece({std::min(length, kMostValue), reach, 0, 0}, reach.speed2, reach.speed2);
}

void TimeBound::add_line(double length, const JointPos& q1, const PathCaps& caps) {
    PathCaps all = caps;
    const auto lower = [](double& cap, double other) { cap = sane(cap) < other ? cap : other; };
    for (Eigen::Index joint = 0; joint < q1.size(); ++joint) {
        const double share = usable(q1, joint) ? std::abs(q1[joint]) : 0;
        if (share == 0) continue;
        if (joint < limits_.max_speed.size()) lower(all.max_speed, limits_.max_speed[joint] / share);
        if (joint >= limits_.max_acceleration.size()) continue;
        lower(all.max_acceleration, limits_.max_acceleration[joint] / share);
        lower(all.max_deceleration, limits_.max_acceleration[joint] / share);
    }
    add_line(length, all);
}

void TimeBound::add_curve(const Curve& curve, const PathCaps& caps) {
    if (!(curve.length > kLeastValue) || curve.length > kMostValue || !curve.at) return;
    const double wanted = std::ceil(curve.turn_rad / grid_.cell_rad);
    const int cells = wanted > 1 ? static_cast<int>(std::min(wanted, kMostCells)) : 1;
    const double length = curve.length / cells;
    const Reach path = reach_of(caps);
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
                         const Reach& path) {
    std::size_t count = 0;
    const Eigen::Index joints = std::min(limits_.max_speed.size(), limits_.max_acceleration.size());
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
        const double max_q2 = joint < curve.max_q2.size() ? std::abs(curve.max_q2[joint]) : kMostValue;
        if (add_joint_cell(joint, length, start, end, max_q2)) ++count;
    }
    add_piece({length, path, 0, count}, node_speed2(start, path), node_speed2(end, path));
}

// The distance of a joint that cannot turn back in the cell is known exactly: q1 = 0 at some position would
// make |q1| at the ends no more than max_q2 times their distances to it.
bool TimeBound::add_joint_cell(Eigen::Index joint, double length, const CurvePoint& start,
                               const CurvePoint& end, double max_q2) {
    for (const JointPos* values : {&start.q, &start.q1, &end.q, &end.q1}) {
        if (!usable(*values, joint)) return false;
    }
    const double share0 = std::abs(start.q1[joint]);
    const double share1 = std::abs(end.q1[joint]);
    const double distance = std::abs(end.q[joint] - start.q[joint]);
    const bool one_way = share0 + share1 > max_q2 * length;
    if (!one_way && !(max_q2 > 0 && max_q2 <= kMostShare)) return false;
    const double travel = one_way ? distance : most_travel(length, share0, share1, max_q2);
    const double acceleration = limits_.max_acceleration[joint];
    joints_.push_back({squared(share0),
                       squared(share1),
                       2 * acceleration * travel,
                       distance,
                       {squared(limits_.max_speed[joint]), acceleration, acceleration}});
    return true;
}

double TimeBound::node_speed2(const CurvePoint& point, const Reach& path) const {
    std::array<Band, rrs::kMaxJoints + 1> bands;
    std::size_t count = 0;
    bands[count++] = {0, 1, path.acceleration, path.deceleration};
    double speed2 = path.speed2;
    for (Eigen::Index joint = 0; joint < limits_.max_speed.size(); ++joint) {
        const double share = usable(point.q1, joint) ? std::abs(point.q1[joint]) : 0;
        if (share > 0) speed2 = std::min(speed2, squared(limits_.max_speed[joint] / share));
    }
    for (Eigen::Index joint = 0; joint < limits_.max_acceleration.size(); ++joint) {
        if (!usable(point.q1, joint) || !usable(point.q2, joint)) continue;
        const double q1 = point.q1[joint];
        const double q2 = point.q2[joint];
        const double most = limits_.max_acceleration[joint];
        bands[count] = {q1 < 0 ? -q2 : q2, std::abs(q1), most, most};
        for (std::size_t other = 0; other < count; ++other) {
            speed2 = std::min(speed2, meeting_speed2(bands[count], bands[other]));
        }
        ++count;
    }
    return speed2;
}

void TimeBound::add_piece(const Piece& piece, double start_cap2, double end_cap2) {
    const double start2 = std::min(front_speed2_, start_cap2);
    front_speed2_ = std::min(end_cap2, start2 + 2 * piece.reach.acceleration * piece.length);
    for (std::size_t i = joints_.size() - piece.joint_count; i < joints_.size(); ++i) {
        const JointCell& joint = joints_[i];
        front_speed2_ =
            std::min(front_speed2_, (joint.share2_start * start2 + joint.gain) / joint.share2_end);
    }
    pieces_.push_back(piece);
    pieces_.back().start_speed2 = start2;
    if (pieces_.size() >= grid_.window) settle_older_half();
}

void TimeBound::go_back(Backward& pass, std::size_t first) const {
    while (pass.pieces > first) {
        const Piece& piece = pieces_[--pass.pieces];
        const std::size_t joints_end = pass.joints;
        pass.joints -= piece.joint_count;
        const double end2 = pass.speed2;
        double start2 = std::min(piece.start_speed2, end2 + 2 * piece.reach.deceleration * piece.length);
        for (std::size_t i = pass.joints; i < joints_end; ++i) {
            const JointCell& joint = joints_[i];
            start2 = std::min(start2, (joint.share2_end * end2 + joint.gain) / joint.share2_start);
        }
        double time_s = least_s(piece.length, start2, end2, piece.reach);
        for (std::size_t i = pass.joints; i < joints_end; ++i) {
            const JointCell& joint = joints_[i];
            time_s = std::max(time_s, least_s(joint.distance, joint.share2_start * start2,
                                              joint.share2_end * end2, joint.reach));
        }
        pass.speed2 = start2;
        pass.time_s += time_s;
    }
}

// Returns the time of the trapezoid between speeds with squares of at most start2 and end2. The three
// distances add up to `length` exactly, so that a split that suffers from cancellation does not harm the
// time.
double TimeBound::least_s(double length, double start2, double end2, const Reach& reach) {
    const double up = reach.acceleration;
    const double down = reach.deceleration;
    const double to2 = std::min(end2, start2 + 2 * up * length);
    const double from2 = std::min(start2, to2 + 2 * down * length);
    const double meeting2 = (down * from2 + up * to2 + 2 * up * down * length) / (up + down);
    const double top2 = std::min(reach.speed2, meeting2);
    if (!(top2 > 0)) return 0;
    const double top = std::sqrt(top2);
    const double rise = std::clamp((top2 - from2) / (2 * up), 0.0, length);
    const double fall = std::clamp((top2 - to2) / (2 * down), 0.0, length - rise);
    return 2 * rise / (top + std::sqrt(from2)) + 2 * fall / (top + std::sqrt(to2)) +
           (length - rise - fall) / top;
}

void TimeBound::settle_all(double end2) {
    Backward pass = at_front(end2);
    go_back(pass, 0);
    settled_s_ += pass.time_s;
    pieces_.clear();
    joints_.clear();
}

// A later stop can lower the speeds before it only as far as braking from the caps reaches. That is commonly
// less than the newer half, and the older half is final. Otherwise the newest end is taken at its highest
// speed, which no continuation exceeds: still a lower bound.
void TimeBound::settle_older_half() {
    const std::size_t half = pieces_.size() / 2;
    Backward pass = at_front(front_speed2_);
    go_back(pass, half);
    const std::size_t old_joints = pass.joints;
    pass.time_s = 0;
    go_back(pass, 0);
    settled_s_ += pass.time_s;
    pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(half));
    joints_.erase(joints_.begin(), joints_.begin() + static_cast<std::ptrdiff_t>(old_joints));
}

}  // namespace gsim::motion
