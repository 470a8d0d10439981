#include "toolpath/rotary/move_generator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "toolpath/rotary/arc_blocks.h"

namespace gsim::path {

using Eigen::Vector3d;

namespace {

constexpr double kFullCircle_rad = 2 * std::numbers::pi * (1 + 1e-9);
constexpr double kMaxRotaryTurn_deg = 360'000;
constexpr int kRangeSamples = 16;
constexpr double kPositionTolerance_mm = 1e-6;

}  // namespace

std::optional<TargetError> MoveGenerator::go_to(const Point& point, std::size_t target, const State& before) {
    target_ = target;
    const AxisValues rotary = turns_.at(target);
    const Vector3d end = to_eigen(point.position_mm);
    const AxisValues axes = space_.axes(end, rotary);
    if (auto range_error = check_range(axes)) return range_error;
    if (before.at_machine_point.value() != false) sink_.retract();
    if (point.acceleration_mm_s2) sink_.acceleration(*point.acceleration_mm_s2);
    if (auto differs = report_work_offset(point, before)) return differs;
    std::optional<TargetError> failed;
    if (point.motion == MotionType::rapid) {
        sink_.move({axes, true, std::nullopt, 0, false});
    } else if (point.motion == MotionType::none) {
        failed = set_position(point, axes, before);
    } else {
        const std::optional<Vector>& start = before.position_mm.value();
        std::optional<ArcShape> arc;
        if (point.motion == MotionType::circular) {
            if (!start) {
                return error(
                    "this arc has a different start for each use of the sub-path; begin the sub-path with a "
                    "line or a rapid");
            }
            arc = arc_shape(*start, point).value();
        }
        failed =
            run(TcpMotion(space_, start ? to_eigen(*start) : end, end, rotary_, rotary, arc), point, before);
    }
    rotary_ = rotary;
    return failed ? failed : arrive(point.dwell_s, point.actions, before);
}

std::optional<TargetError> MoveGenerator::go_to(const MachinePoint& point, std::size_t target,
                                                const State& before) {
    target_ = target;
    if (jet_ && before.process_on.value() != false)
        return error(
            fmt::format("the jet may be on during the move to {}; turn it off before", point_title(point)));
    if (auto range_error = space_.find_axis_range_error(point.axes))
        return error(std::move(range_error->message));
    const MachineApproach travel = plan_approach(point, options_.retract_mm);
    if (travel.retract_first) sink_.retract();
    sink_.go_to(travel);
    if (turns_.is_known(target)) rotary_ = turns_.at(target);
    return arrive(point.dwell_s, point.actions, before);
}

std::optional<TargetError> MoveGenerator::arrive(double dwell_s, const std::vector<std::string>& actions,
                                                 const State& before) {
    if (dwell_s > 0) sink_.dwell(dwell_s);
    const auto all = insert_restore_actions(actions, before.active_modes, options_.tool_change_stops);
    if (!all) return error(all.error().message);
    for (const std::string& each : *all) sink_.action(each);
    return std::nullopt;
}

std::optional<TargetError> MoveGenerator::report_work_offset(const Point& point, const State& before) {
    if (point.work_offset.empty() && before.work_offset.differs())
        return error("the point needs 'work_offset': the paths that lead here have different ones");
    const std::string name =
        point.work_offset.empty() ? before.work_offset.value().value_or("") : point.work_offset;
    if (!name.empty() && name != work_offset_) sink_.work_offset(name);
    work_offset_ = name;
    return std::nullopt;
}

// Handles a point where the tool already is.
std::optional<TargetError> MoveGenerator::set_position(const Point& point, const AxisValues& axes,
                                                       const State& before) {
    const std::optional<Vector>& at = before.position_mm.value();
    if (at && (to_eigen(*at) - to_eigen(point.position_mm)).norm() > kPositionTolerance_mm)
        return error("a point of motion \"none\" must have the position of the previous point");
    if (!at) sink_.set_position(axes);
    return std::nullopt;
}

std::optional<MoveGenerator::Feed> MoveGenerator::motion_feed(const TcpMotion& motion, const Point& point,
                                                              const State& before,
                                                              bool is_rotary_only) const {
    if (point.duration_s) {
        const double travel = is_rotary_only ? motion.turn_deg() : motion.length_mm();
        return Feed{travel * 60 / *point.duration_s, is_rotary_only, point.duration_s};
    }
    const std::optional<double> feed = point.feed_mm_min ? point.feed_mm_min : before.feed_mm_min.value();
    if (is_rotary_only) {
        const std::optional<double> turning =
            point.feed_deg_min ? point.feed_deg_min : before.feed_deg_min.value();
        if (turning) return Feed{*turning, true};
        if (feed) return Feed{*feed, true};  // as controllers do: one F for both
    }
    if (!feed) return std::nullopt;
    const double per_rev =
        point.feed_mm_min ? point.feed_mm_rev.value_or(0) : before.feed_mm_rev.value().value_or(0);
    return Feed{*feed, false, std::nullopt, per_rev > 0 ? std::optional(per_rev) : std::nullopt};
}

std::optional<TargetError> MoveGenerator::run(const TcpMotion& motion, const Point& point,
                                              const State& before) {
    // An unknown path to the point is taken for a line of some length.
    const bool is_start_known = before.position_mm.value().has_value();
    const bool is_rotary_only = is_start_known && motion.length_mm() < options_.resolution_mm / 2;
    if (point.duration_s && !is_start_known) {
        return error("'duration_s' needs a start, which differs between the paths that lead here");
    }
    const std::optional<Feed> feed = motion_feed(motion, point, before, is_rotary_only);
    if (!feed) {
        return error(before.feed_mm_min.differs()
                         ? "the first motion of this sub-path needs 'feed_mm_min': the uses of the sub-path "
                           "have different feeds"
                         : "the motion needs 'feed_mm_min': no previous point has one");
    }
    if (space_.is_coupled() && motion.turn_deg() > kMaxRotaryTurn_deg) {
        return error(
            fmt::format("the rotary axes turn by {:.6g} degrees in one motion; the maximum is {:.6g}",
                        motion.turn_deg(), kMaxRotaryTurn_deg));
    }
    if (motion.arc() || space_.is_coupled()) {
        for (int i = 1; i < kRangeSamples; ++i) {
            if (auto range_error = check_range(motion.at(static_cast<double>(i) / kRangeSamples)))
                return range_error;
        }
    }
    if (motion.tilts_through_vertical()) {
        sink_.note(target_id(),
                   "the tool, which is tilted at both ends of this arc, is vertical between them; with a "
                   "point in between it would turn with the arc");
    }
    if (motion.arc()) {
        if (!is_representable_arc(*motion.arc(), options_) &&
            (!space_.is_coupled() || motion.turn_deg() == 0)) {
            // The program's numbers cannot express more of such an arc.
            lines(motion, *feed, std::min(options_.tolerance_mm, options_.resolution_mm / 2));
            return std::nullopt;
        }
        if (arcs(motion, *feed)) return std::nullopt;
        const bool is_axis_arc = !space_.is_coupled() || motion.turn_deg() == 0;
        if (options_.arcs && options_.oblique_arcs == ObliqueArcs::rejected && is_axis_arc) {
            return error(
                "this arc is outside the planes of X, Y and Z, and the post rejects such arcs ([arcs], "
                "oblique)");
        }
    } else if (is_one_line(motion, is_start_known)) {
        const Feed converted_feed = is_start_known ? axis_feed(motion, 0, 1, *feed) : *feed;
        AxisMove move = feed_move(motion.at(1), converted_feed, 1);
        move.lead_mm = point.lead_mm;
        sink_.move(move);
        return std::nullopt;
    }
    if (point.lead_mm) return error("a line in step with the spindle would have to be divided");
    sink_.note(target_id(), fmt::format("{} as lines within {:.6g} mm",
                                        !motion.arc()   ? "a line with rotating axes"
                                        : options_.arcs ? "an arc outside the planes of the axes"
                                                        : "an arc",
                                        options_.tolerance_mm));
    lines(motion, *feed, options_.tolerance_mm);
    return std::nullopt;
}

// Accepts a line if it is unknown how the axes come to a sub-path, because no other motion is possible.
bool MoveGenerator::is_one_line(const TcpMotion& motion, bool is_start_known) {
    const bool is_rotary_known = rotary_.size() == static_cast<Eigen::Index>(space_.rotary_count());
    if (is_start_known && is_rotary_known) return motion.is_axis_line(options_.tolerance_mm);
    if (space_.is_coupled() && is_sub_path_ && (!is_rotary_known || motion.turn_deg() > 0)) {
        sink_.note(target_id(),
                   "the TCP may leave the line to the first point of this sub-path, because the axes come "
                   "from different positions; a rapid would be better");
    }
    return true;
}

bool MoveGenerator::is_printed_equal(const Vector3d& a, const Vector3d& b) const {
    return ((a / options_.resolution_mm).array().round() == (b / options_.resolution_mm).array().round())
        .all();
}

// Converts a feed, which is that of the TCP, or of the rotary axes if the TCP is at standstill. Coupled axes
// move another length, and a controller takes F as mm of X, Y and Z if any of them moves.
MoveGenerator::Feed MoveGenerator::axis_feed(const TcpMotion& motion, double from, double to,
                                             const Feed& feed) const {
    const double turn_deg = motion.turn_deg() * (to - from);
    if (!space_.is_coupled() || turn_deg == 0) return feed;
    const double minutes = (feed.rotary ? turn_deg : motion.length_mm() * (to - from)) / feed.per_min;
    const Vector3d start = space_.linear(motion.at(from));
    const Vector3d end = space_.linear(motion.at(to));
    if (is_printed_equal(start, end)) return {turn_deg / minutes, true, feed.duration_s};
    return {(end - start).norm() / minutes, false, feed.duration_s};
}

// Returns a feed move for a share of the motion.
AxisMove MoveGenerator::feed_move(const AxisValues& axes, const Feed& feed, double share) const {
    AxisMove move{axes, false, std::nullopt, feed.per_min, feed.rotary};
    if (feed.duration_s) move.duration_s = *feed.duration_s * share;
    move.feed_mm_rev = feed.per_rev;
    return move;
}

void MoveGenerator::lines(const TcpMotion& motion, const Feed& feed, double tolerance_mm) {
    double before = 0;
    motion.cut(tolerance_mm, [&](double share) {
        const Feed converted_feed = axis_feed(motion, before, share, feed);
        sink_.move(feed_move(motion.at(share), converted_feed, share - before));
        before = share;
    });
}

bool MoveGenerator::arcs(const TcpMotion& motion, const Feed& feed) {
    const ArcShape& arc = *motion.arc();
    if (!options_.arcs || !is_representable_arc(arc, options_)) return false;
    const bool moves_linear_axes = space_.is_coupled() && motion.turn_deg() > 0;
    const int turns = moves_linear_axes ? 1 : turns_per_block(arc, options_);
    if (turns > 1 && arcs(motion, feed, 1, &TcpMotion::axis_arc, turns)) return true;
    if (arcs(motion, feed, planar_block_count(arc, options_), &TcpMotion::axis_arc)) return true;
    return options_.oblique_arcs == ObliqueArcs::through_points &&
           arcs(motion, feed, three_point_block_count(arc, options_), &TcpMotion::oblique_arc);
}

bool MoveGenerator::arcs(const TcpMotion& motion, const Feed& feed, int parts, ArcPartFunction part_of_arc,
                         int turns) {
    std::vector<AxisArc> found;
    found.reserve(static_cast<std::size_t>(parts));
    for (int i = 0; i < parts; ++i) {
        const auto arc_part = (motion.*part_of_arc)(
            static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts, options_.tolerance_mm);
        if (!arc_part) return false;
        found.push_back(*arc_part);
    }
    if (turns == 1 && motion.arc()->turn_rad > kFullCircle_rad)
        sink_.note(target_id(), "an arc of several turns as several blocks");
    for (int i = 0; i < parts; ++i) {
        AxisMove move = feed_move(motion.at(static_cast<double>(i + 1) / parts), feed, 1.0 / parts);
        move.arc = found[static_cast<std::size_t>(i)];
        move.arc->turn_rad = motion.arc()->turn_rad / parts;
        move.arc->turns = turns;
        sink_.move(move);
    }
    return parts > 0;
}

// Turns the jet off, so that it does not cut a hole at standstill.
std::optional<TargetError> MoveGenerator::unwind(std::size_t target, const AxisValues* to, const State& at) {
    if (to == nullptr) return std::nullopt;
    target_ = target;
    const bool jet = jet_ && at.process_on.value() != false;
    const bool abrasive = jet && at.abrasive_on.value() == true;
    sink_.note(target_id(), jet ? "the rotary axes unwind, with the jet off" : "the rotary axes unwind");
    if (abrasive) sink_.action("abrasive_off");
    if (jet) sink_.action("waterjet_off");
    // A TCP off the axes would otherwise swing about them, through the work.
    const Vector3d tcp = to_eigen(*at.position_mm.value());
    const TcpMotion turn(space_, tcp, tcp, rotary_, *to, std::nullopt);
    std::optional<TargetError> range_error;
    turn.cut(options_.tolerance_mm, [&](double share) {
        const AxisValues axes = turn.at(share);
        if (!range_error) range_error = check_range(axes);
        sink_.move({axes, true, std::nullopt, 0, false});
    });
    if (jet) sink_.action("waterjet_on");
    if (abrasive) sink_.action("abrasive_on");
    rotary_ = *to;
    return range_error;
}

}  // namespace gsim::path
