#include "runtime/monitors/programmed_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/path/axis_space.h"

namespace gsim::simulation {

using Eigen::Vector3d;

namespace {

constexpr double kSectionAngle_rad = 0.05;
constexpr double kMaxSections = 2000;     // 16 turns: each of them comes near every point
constexpr double kDifferenceStep = 1e-6;  // over which a slope is taken

/// Returns the joints of a programmed move at a share of its path.
rrs::JointPos joints_at(const motion::PathMove& move, const std::array<int, 3>& position_joints,
                        double share) {
    rrs::JointPos joints = move.start + share * (move.end - move.start);
    if (move.kind == motion::SegmentKind::circular) {
        const double phi_rad = move.arc.phi_at(share * move.arc.length_mm());
        motion::write_position(position_joints, move.arc.at(phi_rad), joints);
    }
    if (move.orientation) {
        const motion::HeadAngles angles = move.orientation->at(share * move.orientation->length_rad()).angles;
        joints[move.orientation->turn_joint()] = angles.turn;
        joints[move.orientation->tilt_joint()] = angles.tilt;
    }
    return joints;
}

bool is_circular(const motion::PathMove& move) {
    return move.kind == motion::SegmentKind::circular || move.orientation;
}

/// Returns the number of parts for a path that is not straight.
double section_count(const motion::PathMove& move, const WorkpieceTcp& tcp) {
    const double curve_angle_rad = is_circular(move) ? std::max(1.0, move.arc.sweep_rad) : 0;
    return std::max(
        2.0, std::ceil((tcp.rotation_rad(move.start, move.end) + curve_angle_rad) / kSectionAngle_rad));
}

}  // namespace

void ProgrammedPath::on_programmed_move(const motion::PathMove& move) {
    is_reported_ = true;
    reported_moves_.push_back(move);
}

void ProgrammedPath::forget() {
    reported_moves_.clear();
    first_added_ = false;
}

void ProgrammedPath::mark_lost() {
    executed_moves_.clear();
    first_added_ = begun_ = false;
}

bool ProgrammedPath::drive(rrs::TargetId id, double start_s, const WorkpieceTcp& tcp) {
    if (!executed_moves_.empty() && executed_moves_.back().id == id) return true;
    bool is_reported = false, exceeds_max_sections = false;
    while (!reported_moves_.empty() && reported_moves_.front().target_id <= id) {
        const motion::PathMove& move = reported_moves_.front();
        is_reported = is_reported || move.target_id == id;
        exceeds_max_sections = exceeds_max_sections || section_count(move, tcp) > kMaxSections;
        if (!std::exchange(first_added_, false) && !exceeds_max_sections) add(move, tcp);
        reported_moves_.pop_front();
    }
    if (!is_reported || exceeds_max_sections) {
        mark_lost();
        return false;
    }
    // A corner is rounded on both of its sides.
    if (!reported_moves_.empty() && section_count(reported_moves_.front(), tcp) <= kMaxSections &&
        !std::exchange(first_added_, true)) {
        add(reported_moves_.front(), tcp);
    }
    executed_moves_.push_back({start_s, id});
    return true;
}

void ProgrammedPath::add(const motion::PathMove& move, const WorkpieceTcp& tcp) {
    if (!std::exchange(begun_, true)) path_.begin(tcp.at(move.start));
    const auto time = static_cast<double>(move.target_id);
    if (!is_circular(move) && tcp.rotation_rad(move.start, move.end) == 0)
        return path_.add_line(tcp.at(move.end), time, false);
    const double part_count = section_count(move, tcp);
    const auto section_end_at = [&](double share) -> SetPointPath::EndPoint {
        const double in = std::clamp(share, kDifferenceStep, 1 - kDifferenceStep);
        const auto point = [&](double at) { return tcp.at(joints_at(move, position_joints_, at)); };
        const Vector3d change = point(in + kDifferenceStep) - point(in - kDifferenceStep);
        return {point(share), change / (2 * kDifferenceStep * part_count)};
    };
    SetPointPath::EndPoint from = section_end_at(0);
    for (double i = 1; i <= part_count; ++i) {
        const SetPointPath::EndPoint to = section_end_at(i / part_count);
        path_.add_curve(from, to, time);
        from = to;
    }
}

void ProgrammedPath::discard_before(double t_s) {
    while (executed_moves_.size() > 1 && executed_moves_[1].start_s <= t_s) executed_moves_.pop_front();
    if (!executed_moves_.empty()) path_.discard_before(static_cast<double>(executed_moves_.front().id));
}

std::optional<double> ProgrammedPath::distance_mm(const Vector3d& point_mm) {
    if (executed_moves_.empty()) return std::nullopt;
    return path_.distance_mm(point_mm);
}

}  // namespace gsim::simulation
