#include "motion/moves/exact_stop_moves.h"

#include <utility>

#include "motion/exact_stop/arc_move.h"
#include "motion/exact_stop/joint_move.h"
#include "motion/exact_stop/line_move.h"
#include "motion/exact_stop/uncoordinated_move.h"
#include "motion/segment/move_part.h"

namespace gsim::motion {

ExactStopMoves::ExactStopMoves(const ActiveMachine& machine, const TrackedFrame& tracked_frame,
                               const TargetSolver& targets, PathBuilder& paths, BufferedMoves& buffered_moves,
                               OperatorOverrides& overrides, Timeline& timeline, RobotPosition& position)
    : machine_(machine),
      tracked_frame_(tracked_frame),
      targets_(targets),
      paths_(paths),
      buffered_moves_(buffered_moves),
      overrides_(overrides),
      timeline_(timeline),
      position_(position) {}

EnqueueResult ExactStopMoves::enqueue_joint_move(const Move& move) {
    buffered_moves_.leave();
    rrs::JointPos target;
    if (PlanResult solved = targets_.solve(move.goal, target); !solved)
        return tl::unexpected(std::move(solved.error()));
    const EnabledOverrides& enabled_overrides = move.move_parameters.enabled_overrides;
    overrides_.wait_out_hold(move.target_id, position_.joints(), enabled_overrides, false);
    Segment& segment = timeline_.begin_reserved(move.target_id);
    segment.start = position_.joints();
    segment.end = target;
    const double share = overrides_.current_share(enabled_overrides, false);
    PathMove joint_path;
    joint_path.start = segment.start;
    joint_path.end = target;
    joint_path.rapid = true;
    const auto setup = overrides_.setup_for_move(joint_path);
    if (!setup) return tl::unexpected(setup.error());
    PlanResult planned = plan_joint_move(**setup, move.move_parameters, share, segment);
    if (planned) planned = tracked_frame_.superimpose_in_range(segment);
    if (!planned) return tl::unexpected(std::move(planned.error()));
    position_.move_to(target);
    const double actual_s = segment.duration_s * share;
    timeline_.finish();
    return find_raised_time(actual_s, move.move_parameters.motion_time_s, false);
}

EnqueueResult ExactStopMoves::enqueue_path_move(const Move& move) {
    buffered_moves_.leave();
    const bool uncoordinated = !machine_.is_interpolated(move.move_parameters.rapid);
    if (tracked_frame_.is_active() && uncoordinated) {
        return make_plan_error(rrs::Status::RRS_MODE_NOT_SUPPORTED,
                               "Rapids that are not interpolated cannot follow a conveyor.");
    }
    const auto built = paths_.build(move);
    if (!built) return tl::unexpected(built.error());
    const PathMove& path = **built;
    overrides_.wait_out_hold(path.target_id, position_.joints(), path.enabled_overrides, path.rapid);
    Segment& segment = timeline_.begin_reserved(path.target_id);
    set_path(path, segment);
    const double share = overrides_.current_share(path.enabled_overrides, path.rapid);
    const MoveRules rules =
        path.rules.with_overrides(overrides_.current(), path.enabled_overrides, path.rapid);
    const auto limited = overrides_.setup_for_move(path);
    if (!limited) return tl::unexpected(limited.error());
    const PlannerSetup& setup = **limited;
    PlanResult planned = path.kind == SegmentKind::circular ? plan_arc(setup, rules, segment)
                         : uncoordinated                    ? plan_uncoordinated_move(setup, rules, segment)
                                                            : plan_line(setup, rules, segment);
    if (planned) planned = tracked_frame_.superimpose_in_range(segment);
    if (!planned) return tl::unexpected(std::move(planned.error()));
    position_.move_to(path.end);
    const double actual_s = segment.duration_s * share;
    overrides_.finish(path, segment);
    return find_raised_time(actual_s, move.move_parameters.motion_time_s, false);
}

}  // namespace gsim::motion
