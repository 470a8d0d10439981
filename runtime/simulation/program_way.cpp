#include "runtime/simulation/program_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/motion/axis_space.h"

namespace gsim::simulation {

using Eigen::Vector3d;

namespace {

constexpr double kPiece_rad = 0.05;
constexpr double kMostPieces = 20'000;
constexpr double kSlopeShare = 1e-6;  // over which a slope is taken

/// The joints of a programmed move at a share of its way.
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
    bool is_told = false;
    while (!told_.empty() && told_.front().target_id <= id) {
        is_told = is_told || told_.front().target_id == id;
        if (!std::exchange(first_added_, false)) add(told_.front(), tip);
        told_.pop_front();
    }
    if (!is_told) {
        lose();
        return false;
    }
    // A corner is rounded on both sides of it.
    if (!told_.empty() && !std::exchange(first_added_, true)) add(told_.front(), tip);
    driven_.push_back({start_s, id});
    return true;
}

void ProgramWay::add(const motion::PathMove& move, const PartTip& tip) {
    if (!std::exchange(begun_, true)) way_.begin(tip.at(move.start));
    const auto time = static_cast<double>(move.target_id);
    const bool round = move.kind == motion::SegmentKind::circular || move.orientation;
    const double turned_rad = tip.turned_rad(move.start, move.end);
    if (!round && turned_rad == 0) return way_.add_line(tip.at(move.end), time, false);
    const double turn_rad = turned_rad + (round ? std::max(1.0, move.arc.sweep_rad) : 0);
    const double pieces = std::clamp(std::ceil(turn_rad / kPiece_rad), 2.0, kMostPieces);
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
