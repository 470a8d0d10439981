#include "runtime/monitors/program_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/path/axis_space.h"

namespace gsim::simulation {

using Eigen::Vector3d;

namespace {

constexpr double kPiece_rad = 0.05;
constexpr double kMostPieces = 2000;  // 16 turns: each of them comes near every point
constexpr double kSlopeShare = 1e-6;  // over which a slope is taken

/// Returns the joints of a programmed move at a share of its path.
rrs::JointPos joints_at(const motion::PathMove& move, const std::array<int, 3>& position_joints,
                        double share) {
    rrs::JointPos joints = move.start + share * (move.end - move.start);
    if (move.kind == motion::SegmentKind::circular) {
        const double phi_rad = move.arc.phi_at(share * move.arc.length_mm());
        motion::put_position(position_joints, move.arc.at(phi_rad), joints);
    }
    if (move.orientation) {
        const motion::HeadAngles angles = move.orientation->at(share * move.orientation->length_rad()).angles;
        joints[move.orientation->turn_joint()] = angles.turn;
        joints[move.orientation->tilt_joint()] = angles.tilt;
    }
    return joints;
}

bool is_round(const motion::PathMove& move) {
    return move.kind == motion::SegmentKind::circular || move.orientation;
}

/// Returns the number of parts for a path that is not straight.
double pieces_of(const motion::PathMove& move, const PartTip& tip) {
    const double round_rad = is_round(move) ? std::max(1.0, move.arc.sweep_rad) : 0;
    return std::max(2.0, std::ceil((tip.turned_rad(move.start, move.end) + round_rad) / kPiece_rad));
}

}  // namespace

void ProgramWay::programmed(const motion::PathMove& move) {
    is_told_ = true;
    told_.push_back(move);
}

void ProgramWay::forget() {
    told_.clear();
    first_added_ = false;
}

void ProgramWay::lose() {
    driven_.clear();
    first_added_ = begun_ = false;
}

bool ProgramWay::drive(rrs::TargetId id, double start_s, const PartTip& tip) {
    if (!driven_.empty() && driven_.back().id == id) return true;
    bool is_told = false, turns_long = false;
    while (!told_.empty() && told_.front().target_id <= id) {
        const motion::PathMove& move = told_.front();
        is_told = is_told || move.target_id == id;
        turns_long = turns_long || pieces_of(move, tip) > kMostPieces;
        if (!std::exchange(first_added_, false) && !turns_long) add(move, tip);
        told_.pop_front();
    }
    if (!is_told || turns_long) {
        lose();
        return false;
    }
    // A corner is rounded on both of its sides.
    if (!told_.empty() && pieces_of(told_.front(), tip) <= kMostPieces &&
        !std::exchange(first_added_, true)) {
        add(told_.front(), tip);
    }
    driven_.push_back({start_s, id});
    return true;
}

void ProgramWay::add(const motion::PathMove& move, const PartTip& tip) {
    if (!std::exchange(begun_, true)) way_.begin(tip.at(move.start));
    const auto time = static_cast<double>(move.target_id);
    if (!is_round(move) && tip.turned_rad(move.start, move.end) == 0)
        return way_.add_line(tip.at(move.end), time, false);
    const double pieces = pieces_of(move, tip);
    const auto end_at = [&](double share) -> SetPointWay::End {
        const double in = std::clamp(share, kSlopeShare, 1 - kSlopeShare);
        const auto point = [&](double at) { return tip.at(joints_at(move, position_joints_, at)); };
        const Vector3d change = point(in + kSlopeShare) - point(in - kSlopeShare);
        return {point(share), change / (2 * kSlopeShare * pieces)};
    };
    SetPointWay::End from = end_at(0);
    for (double i = 1; i <= pieces; ++i) {
        const SetPointWay::End to = end_at(i / pieces);
        way_.add_curve(from, to, time);
        from = to;
    }
}

void ProgramWay::forget_before(double t_s) {
    while (driven_.size() > 1 && driven_[1].start_s <= t_s) driven_.pop_front();
    if (!driven_.empty()) way_.forget_before(static_cast<double>(driven_.front().id));
}

std::optional<double> ProgramWay::distance_mm(const Vector3d& point_mm) {
    if (driven_.empty()) return std::nullopt;
    return way_.distance_mm(point_mm);
}

}  // namespace gsim::simulation
