#include "runtime/simulator/moves/move_queue.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::simulation {

using text::DiagnosticKind;

bool MoveQueue::enqueue(const LineMove& move) {
    if (!groups_.wait_before(move.target, move.location)) return false;
    const bool rotary = position_.is_rotary_only(move.target);
    const bool rapid = move.kind == MoveKind::rapid;
    if (!rapid && !feeds_.check(move.feed, rotary, move.location)) return false;
    const auto joints = position_.solve_joints(move.target);
    if (!joints) return outcome_.fail(DiagnosticKind::unreachable, joints.error(), move.location);
    const motion::OvertravelPermit pass(ranges_.begin_move());
    if (const auto in_range = ranges_.check_target(*joints); !in_range)
        return outcome_.fail(in_range.error(), move.location);
    const MoveInfo info =
        program_.make_info(move.kind, move.location, move.feed, feeds_.per_min(move, rotary));
    motion_.recorder().expect(info);
    motion::Move full_move = program_.make_move(info);
    full_move.goal.joints = *joints;
    if (!rapid) feeds_.apply(move.feed, rotary, full_move);
    return acceptance_.finish(
        motion_.source().enqueue(full_move), move.target, move.location,
        [&](ProgramObserver& observer, const AxisVector& from) { observer.line(from, move, rotary); });
}

bool MoveQueue::enqueue(const ArcMove& move) {
    if (!groups_.wait_before(move.target, move.location)) return false;
    if (!feeds_.check(move.feed, false, move.location)) return false;
    const auto joints = position_.solve_joints(move.target);
    if (!joints) return outcome_.fail(DiagnosticKind::unreachable, joints.error(), move.location);
    const motion::OvertravelPermit pass(ranges_.begin_move());
    if (const auto in_range = ranges_.check_target(*joints); !in_range)
        return outcome_.fail(in_range.error(), move.location);
    MoveInfo info = program_.make_info(move.kind, move.location, move.feed, feeds_.per_min(move));
    info.normal = move.normal;
    info.turns = std::max(1, static_cast<int>(std::ceil(move.sweep_rad / (2 * std::numbers::pi) - 1e-9)));
    motion_.recorder().expect(info);
    motion::Move full_move = program_.make_move(info);
    full_move.goal.joints = *joints;
    full_move.type = rrs::MotionType::circular;
    full_move.circle = position_.circle(move);
    feeds_.apply(move.feed, false, full_move);
    return acceptance_.finish(
        motion_.source().enqueue(full_move), move.target, move.location,
        [&](ProgramObserver& observer, const AxisVector& from) { observer.arc(from, move); });
}

bool MoveQueue::enqueue(const ViaMove& move) {
    if (!groups_.wait_before(move.target, move.location)) return false;
    if (!feeds_.check(move.feed, false, move.location)) return false;
    const auto via = position_.solve_joints(move.via);
    const auto target = position_.solve_joints(move.target);
    if (!via || !target) {
        return outcome_.fail(DiagnosticKind::unreachable, via ? target.error() : via.error(), move.location);
    }
    const motion::OvertravelPermit pass(ranges_.begin_move());
    if (const auto in_range = ranges_.check_target(*target); !in_range)
        return outcome_.fail(in_range.error(), move.location);
    MoveInfo info = program_.make_info(MoveKind::arc_ccw, move.location, move.feed, move.feed.linear_mm_min);
    info.turns = 1;
    set_axis(info, position_.space_point(position_.axes()), position_.space_point(move.via),
             position_.space_point(move.target));
    motion_.recorder().expect(info);
    motion::Move full_move = program_.make_move(info);
    full_move.goal.joints = *target;
    full_move.type = rrs::MotionType::circular;
    full_move.via = motion::Goal{*via, std::nullopt};
    feeds_.apply(move.feed, false, full_move);
    return acceptance_.finish(
        motion_.source().enqueue(full_move), move.target, move.location,
        [&](ProgramObserver& observer, const AxisVector& from) { observer.arc(from, move); });
}

}  // namespace gsim::simulation
