#include "motion/path/limited_way.h"

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

constexpr double kTurnOfJoints_rad = 2.5 * kRadPerDeg;  // between two points of a path
constexpr double kTurnOfArc_rad = 0.2;
constexpr int kLeastParts = 2;
constexpr int kMostParts = 48;
constexpr double kStraightOn = 1e-9;  // difference of slopes that counts as none

int parts_of(double turn, double turn_of_part) {
    const double parts = std::ceil(turn / turn_of_part);
    return static_cast<int>(std::clamp<double>(parts, kLeastParts, kMostParts));
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
              const rrs::JointPos& slope, std::vector<WayPoint>& points) {
    const int parts = parts_of(turn_between(setup, from, to), kTurnOfJoints_rad);
    for (int i = 0; i <= parts; ++i)
        points.push_back({from + static_cast<double>(i) / parts * (to - from), slope});
}

/// The joints that carry the position run round, the others in proportion.
void add_arc(const PlannerSetup& setup, const Block& block, std::vector<WayPoint>& points) {
    const PathMove& move = block.move;
    const int parts = std::max(parts_of(move.arc.sweep_rad, kTurnOfArc_rad),
                               parts_of(turn_between(setup, move.start, move.end), kTurnOfJoints_rad));
    for (int i = 0; i <= parts; ++i) {
        const double share = static_cast<double>(i) / parts;
        const double phi = move.arc.phi_at(share * move.arc.length_mm());
        WayPoint point{move.start + share * (move.end - move.start), block.slope_in};
        put_position(setup.position_joints, move.arc.at(phi), point.position);
        put_position(setup.position_joints, move.arc.tangent(phi), point.slope);
        points.push_back(std::move(point));
    }
}

bool goes_straight(const PathMove& move) {
    return move.kind == SegmentKind::linear && !move.piece;
}

bool rests_always(const PlannerSetup& setup) {
    return setup.controller.planner == rrs::PlannerKind::rest_to_rest;
}

WayToLimit way_of(const PlannerSetup& setup, const Block& block) {
    const bool stops = block.move.mode == rrs::PathMode::exact_stop || rests_always(setup);
    WayToLimit way{.points = {},
                   .straight = goes_straight(block.move),
                   .rests = stops && !block.move.piece,
                   .length = block.lead.length,
                   .curvature = 0,
                   .max_speed = block.max_speed};
    if (block.move.kind == SegmentKind::circular) {
        way.curvature = block.move.arc.max_curvature();
        add_arc(setup, block, way.points);
    } else {
        add_line(setup, block.move.start, block.move.end, block.slope_in, way.points);
    }
    return way;
}

/// A move from standstill to standstill with a required time is faster in its middle than in the mean.
PathMove at_any_time(const PathMove& move, const PlannerSetup& setup) {
    PathMove free = move;
    if (rests_always(setup)) free.rules.least_duration_s = 0;
    return free;
}

/// Returns the setup with joints of unlimited acceleration: the remaining limits are those of speeds.
PlannerSetup freed(PlannerSetup setup) {
    for (JointSetup& joint : setup.joints) {
        joint.max_acceleration = kUnlimited;
        joint.max_deceleration.reset();
    }
    return setup;
}

void keep_speed(const Block& block, double max_speed, PlannerSetup& setup) {
    rrs::JointPos shares = block.slope_in.cwiseAbs();
    if (block.move.kind == SegmentKind::circular)
        put_position(setup.position_joints, block.move.arc.max_shares(), shares);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (shares[joint] < kNoShare) continue;
        double& most = setup.joints[static_cast<std::size_t>(joint)].max_speed;
        most = std::min(most, max_speed * shares[joint]);
    }
}

/// Shares the acceleration if the planner does not slow down for curves: half is for the path round, half for
/// speeding up and slowing down. So both together are no more, for any direction of the path to the joint.
void share_on_curve(WayToLimit& way, PlannerSetup& setup) {
    constexpr double kHalf = 0.5;
    for (const int joint : setup.position_joints) {
        if (joint < 0) continue;
        JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        limits.max_deceleration = kHalf * limits.deceleration();
        limits.max_acceleration *= kHalf;
        way.max_speed = std::min(way.max_speed, std::sqrt(limits.least_acceleration() / way.curvature));
    }
}

/// Returns the points of a corner: between lines those of the parts that blends may use.
WayToLimit way_at_corner(const PlannerSetup& setup, const Block& from, const Block& to) {
    WayToLimit way;
    way.max_speed = std::min(from.max_speed, to.max_speed);
    const rrs::JointPos& at = to.move.start;
    if (goes_straight(from.move)) {
        add_line(setup, from.line_at((1 - kMostOfLine) * from.lead.length), at, from.slope_out, way.points);
    } else {
        way.points.push_back({at, from.slope_out});
    }
    way.points.push_back({at, (from.slope_out + to.slope_in) / 2});
    if (goes_straight(to.move)) {
        add_line(setup, at, to.line_at(kMostOfLine * to.lead.length), to.slope_in, way.points);
    } else {
        way.points.push_back({at, to.slope_in});
    }
    return way;
}

}  // namespace

tl::expected<PlannerSetup, PlanError> setup_on_way(const PathMove& move, const PlannerSetup& setup,
                                                   const Overrides& overrides) {
    PlannerSetup limited = freed(setup);
    auto block = block_of(at_any_time(move, setup), limited, overrides);
    if (!block) return tl::unexpected(std::move(block.error()));
    limited.joints = setup.joints;
    if (!*block) return limited;
    WayToLimit way = way_of(setup, **block);
    if (Planned planned = setup.move_limits->limit(way, limited.joints); !planned)
        return tl::unexpected(std::move(planned.error()));
    if (move.kind == SegmentKind::circular && rests_always(setup)) share_on_curve(way, limited);
    if (way.max_speed < (*block)->max_speed) keep_speed(**block, way.max_speed, limited);
    return limited;
}

tl::expected<std::optional<Block>, PlanError> limited_block_of(const PathMove& move,
                                                               const PlannerSetup& setup,
                                                               const Overrides& overrides) {
    const auto limited = setup_on_way(move, setup, overrides);
    if (!limited) return tl::unexpected(limited.error());
    return block_of(move, *limited, overrides);
}

std::optional<rrs::JointPos> corner_accelerations(const PlannerSetup& setup, const Block& from,
                                                  const Block& to) {
    const bool stops = from.move.mode == rrs::PathMode::exact_stop || from.lead.role != to.lead.role;
    const bool turns = ((to.slope_in - from.slope_out).array().abs() >= kStraightOn).any();
    std::vector<JointSetup> joints = setup.joints;
    if (turns && !stops) {
        WayToLimit way = way_at_corner(setup, from, to);
        if (!setup.move_limits->limit(way, joints)) return std::nullopt;
    }
    rrs::JointPos accelerations(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        accelerations[joint] = joints[static_cast<std::size_t>(joint)].least_acceleration();
    return accelerations;
}

PlannerSetup setup_at_corner(const PlannerSetup& setup, const rrs::JointPos& accelerations) {
    PlannerSetup at_corner = setup;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        JointSetup& limits = at_corner.joints[static_cast<std::size_t>(joint)];
        limits.max_acceleration = accelerations[joint];
        limits.max_deceleration.reset();
    }
    return at_corner;
}

}  // namespace gsim::motion
