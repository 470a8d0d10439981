#include "motion/path/limited_path.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/units.h"
#include "motion/lookahead/blend.h"
#include "motion/path/axis_space.h"
#include "motion/path/joint_changes.h"
#include "motion/planner/move_limits.h"

namespace gsim::motion {

namespace {

constexpr double kMaxJointRotation_rad = 2.5 * kRadPerDeg;  // between two points of a path
constexpr double kMaxArcAngle_rad = 0.2;
constexpr int kMinParts = 2;
constexpr int kMaxParts = 48;
constexpr double kFlatSlope = 1e-9;  // difference of slopes that counts as none

int count_parts(double turn, double max_turn) {
    const double parts = std::ceil(turn / max_turn);
    return static_cast<int>(std::clamp<double>(parts, kMinParts, kMaxParts));
}

/// Returns the turn of the rotary joints between two positions, together.
double turn_between(const PlannerSetup& setup, const rrs::JointPos& from, const rrs::JointPos& to) {
    double turn = 0;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (setup.role(joint) == JointRole::rotary) turn += std::abs(to[joint] - from[joint]);
    }
    return turn;
}

void add_line(const PlannerSetup& setup, const rrs::JointPos& from, const rrs::JointPos& to,
              const rrs::JointPos& slope, std::vector<PathPoint>& points) {
    const int parts = count_parts(turn_between(setup, from, to), kMaxJointRotation_rad);
    for (int i = 0; i <= parts; ++i)
        points.push_back({from + static_cast<double>(i) / parts * (to - from), slope});
}

/// The joints that carry the position run round, the others in proportion.
void add_arc(const PlannerSetup& setup, const Block& block, std::vector<PathPoint>& points) {
    const PathMove& move = block.move;
    const int parts = std::max(count_parts(move.arc.sweep_rad, kMaxArcAngle_rad),
                               count_parts(turn_between(setup, move.start, move.end), kMaxJointRotation_rad));
    for (int i = 0; i <= parts; ++i) {
        const double share = static_cast<double>(i) / parts;
        const double phi = move.arc.phi_at(share * move.arc.length_mm());
        PathPoint point{move.start + share * (move.end - move.start), block.slope_in};
        write_position(setup.position_joints, move.arc.at(phi), point.position);
        write_position(setup.position_joints, move.arc.tangent(phi), point.slope);
        points.push_back(std::move(point));
    }
}

bool is_linear_move(const PathMove& move) {
    return move.kind == SegmentKind::linear && !move.sub_segment;
}

bool stops_always(const PlannerSetup& setup) {
    return setup.controller.capabilities().stops_at_each_move;
}

LimitedPath limited_path_of(const PlannerSetup& setup, const Block& block) {
    const bool stops = block.move.mode == rrs::PathMode::exact_stop || stops_always(setup);
    LimitedPath path{.points = {},
                     .straight = is_linear_move(block.move),
                     .is_rest_to_rest = stops && !block.move.sub_segment,
                     .length = block.master.length,
                     .curvature = 0,
                     .max_speed = block.max_speed};
    if (block.move.kind == SegmentKind::circular) {
        path.curvature = block.move.arc.max_curvature();
        add_arc(setup, block, path.points);
    } else {
        add_line(setup, block.move.start, block.move.end, block.slope_in, path.points);
    }
    return path;
}

/// A move from standstill to standstill with a required time is faster in its middle than in the mean.
PathMove without_duration(const PathMove& move, const PlannerSetup& setup) {
    PathMove untimed_move = move;
    if (stops_always(setup)) untimed_move.rules.min_duration_s = 0;
    return untimed_move;
}

/// Returns the setup with joints of unlimited acceleration: the remaining limits are those of speeds.
PlannerSetup without_acceleration_limits(PlannerSetup setup) {
    for (JointSetup& joint : setup.joints) {
        joint.max_acceleration = kUnlimited;
        joint.max_deceleration.reset();
    }
    return setup;
}

void cap_joint_speeds(const Block& block, double max_speed, PlannerSetup& setup) {
    rrs::JointPos shares = block.slope_in.cwiseAbs();
    if (block.move.kind == SegmentKind::circular)
        write_position(setup.position_joints, block.move.arc.max_shares(), shares);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (shares[joint] < kMinShare) continue;
        double& joint_max_speed = setup.joints[static_cast<std::size_t>(joint)].max_speed;
        joint_max_speed = std::min(joint_max_speed, max_speed * shares[joint]);
    }
}

/// Shares the acceleration if the planner does not slow down for curves: half is for the path round, half for
/// speeding up and slowing down. So both together are no more, for any direction of the path to the joint.
void split_curve_acceleration(LimitedPath& path, PlannerSetup& setup) {
    constexpr double kHalf = 0.5;
    for (const int joint : setup.position_joints) {
        if (joint < 0) continue;
        JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        limits.max_deceleration = kHalf * limits.deceleration();
        limits.max_acceleration *= kHalf;
        path.max_speed = std::min(path.max_speed, std::sqrt(limits.min_acceleration() / path.curvature));
    }
}

/// Returns the points of a corner: between lines those of the parts that blends may use.
LimitedPath corner_path(const PlannerSetup& setup, const Block& from, const Block& to) {
    LimitedPath path;
    path.max_speed = std::min(from.max_speed, to.max_speed);
    const rrs::JointPos& at = to.move.start;
    if (is_linear_move(from.move)) {
        add_line(setup, from.line_at((1 - kMaxCutShare) * from.master.length), at, from.slope_out,
                 path.points);
    } else {
        path.points.push_back({at, from.slope_out});
    }
    path.points.push_back({at, (from.slope_out + to.slope_in) / 2});
    if (is_linear_move(to.move)) {
        add_line(setup, at, to.line_at(kMaxCutShare * to.master.length), to.slope_in, path.points);
    } else {
        path.points.push_back({at, to.slope_in});
    }
    return path;
}

}  // namespace

tl::expected<PlannerSetup, PlanError> setup_for_path(const PathMove& move, const PlannerSetup& setup,
                                                     const Overrides& overrides) {
    PlannerSetup limited = without_acceleration_limits(setup);
    auto block = make_block(without_duration(move, setup), limited, overrides);
    if (!block) return tl::unexpected(std::move(block.error()));
    limited.joints = setup.joints;
    if (!*block) return limited;
    LimitedPath path = limited_path_of(setup, **block);
    if (PlanResult planned = setup.move_limits->limit(path, limited.joints); !planned)
        return tl::unexpected(std::move(planned.error()));
    if (move.kind == SegmentKind::circular && stops_always(setup)) split_curve_acceleration(path, limited);
    if (path.max_speed < (*block)->max_speed) cap_joint_speeds(**block, path.max_speed, limited);
    return limited;
}

tl::expected<std::optional<Block>, PlanError> limited_block(const PathMove& move, const PlannerSetup& setup,
                                                            const Overrides& overrides) {
    const auto limited = setup_for_path(move, setup, overrides);
    if (!limited) return tl::unexpected(limited.error());
    return make_block(move, *limited, overrides);
}

std::optional<rrs::JointPos> corner_accelerations(const PlannerSetup& setup, const Block& from,
                                                  const Block& to) {
    const bool stops = from.move.mode == rrs::PathMode::exact_stop || from.master.role != to.master.role;
    const bool turns = ((to.slope_in - from.slope_out).array().abs() >= kFlatSlope).any();
    std::vector<JointSetup> joints = setup.joints;
    if (turns && !stops) {
        LimitedPath path = corner_path(setup, from, to);
        if (!setup.move_limits->limit(path, joints)) return std::nullopt;
    }
    rrs::JointPos accelerations(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        accelerations[joint] = joints[static_cast<std::size_t>(joint)].min_acceleration();
    return accelerations;
}

PlannerSetup setup_for_corner(const PlannerSetup& setup, const rrs::JointPos& accelerations) {
    PlannerSetup at_corner = setup;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        JointSetup& limits = at_corner.joints[static_cast<std::size_t>(joint)];
        limits.max_acceleration = accelerations[joint];
        limits.max_deceleration.reset();
    }
    return at_corner;
}

}  // namespace gsim::motion
