#include "motion/moves/tool_moves.h"

#include <utility>

#include "motion/kinematics/pose.h"
#include "motion/lookahead/look_ahead.h"
#include "motion/path/axis_space.h"
#include "motion/path/circle.h"

namespace gsim::motion {

using rrs::Status;

namespace {

Eigen::Vector3d tcp_position(const PlannerSetup& setup, const rrs::JointPos& joints,
                             const Eigen::Vector3d& tcp_mm) {
    return setup.kinematics->forward(joints) * tcp_mm;
}

/// Converts an inverse time feed into a speed along the full path.
void set_speed(const ToolPath& path, MoveRules& rules) {
    const double requested_s = std::exchange(rules.min_duration_s, 0);
    if (requested_s <= 0) return;
    if (path.role() == JointRole::rotary) {
        rules.orientation_speed_rad_s = path.length() / requested_s;
    } else {
        rules.programmed_speed_mm_s = path.length() / requested_s;
    }
}

/// Returns the point that follows the path, in the frame of the tool centre point.
Eigen::Vector3d tcp_of_move(const Move& move) {
    if (move.tcp_mm) return *move.tcp_mm;
    return move.goal.pose ? Eigen::Vector3d(move.goal.pose->tool.translation()) : Eigen::Vector3d::Zero();
}

}  // namespace

ToolMoves::ToolMoves(const ActiveMachine& machine, const TargetSolver& targets, const PathBuilder& paths,
                     BufferedMoves& buffered_moves, Dwells& dwells, Timeline& timeline,
                     RobotPosition& position)
    : machine_(machine),
      targets_(targets),
      paths_(paths),
      buffered_moves_(buffered_moves),
      dwells_(dwells),
      timeline_(timeline),
      position_(position),
      exact_stop_model_(std::make_unique<LookAhead>(machine.setup(), timeline)) {}

bool ToolMoves::accepts(const Move& move) const {
    if (move.type == rrs::MotionType::joint || !machine_.is_interpolated(move.move_parameters.rapid))
        return false;
    return move.tcp_mm ||
           (move.goal.pose && rotary_joints_move_tcp(machine_.setup(), move.goal.pose->tool.translation()));
}

/// Returns `via` as a position of the controlled point. It is taken from the pose if the machine has fixed
/// joints, because the joints that would reach it are known only on the path.
tl::expected<Eigen::Vector3d, PlanError> ToolMoves::via_point(const Move& move) const {
    if (move.via->pose && machine_.has_fixed_joints())
        return Eigen::Vector3d(move.via->pose->pose.translation());
    rrs::JointPos via;
    if (PlanResult solved = targets_.solve(*move.via, via); !solved)
        return tl::unexpected(std::move(solved.error()));
    return tcp_position(machine_.setup(), via, tcp_of_move(move));
}

tl::expected<TcpPath, PlanError> ToolMoves::make_tcp_path(const Move& move, const Eigen::Vector3d& from,
                                                          const Eigen::Vector3d& to) const {
    TcpPath tcp_path{.from = from, .to = to};
    if (move.type == rrs::MotionType::linear) return tcp_path;
    tcp_path.kind = SegmentKind::circular;
    PlanResult planned;
    if (move.circle) {
        planned = arc_about(from, to, move.circle->center_mm, move.circle->axis, move.circle->sweep_rad,
                            machine_.setup().arc_tolerance_mm, tcp_path.arc);
    } else if (move.via) {
        const auto via = via_point(move);
        if (!via) return tl::unexpected(via.error());
        planned = arc_through(from, *via, to, tcp_path.arc);
    } else {
        planned = no_via_point_error();
    }
    if (!planned) return tl::unexpected(std::move(planned.error()));
    return tcp_path;
}

/// The other joints move in proportion if three slides carry the controlled point. Otherwise, and if the
/// inverse holds joints, the tool turns evenly.
tl::expected<std::unique_ptr<ToolPath>, PlanError> ToolMoves::make_tool_path(const Move& move) const {
    const PlannerSetup& setup = machine_.setup();
    const rrs::JointPos& start = position_.joints();
    const bool is_pose_move = move.goal.pose && (slide_count(setup) < 3 || machine_.has_fixed_joints());
    rrs::JointPos end;
    if (is_pose_move) {
        if (auto checked = kinematics::check_pose(move.goal.pose->pose); !checked)
            return make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    } else {
        if (PlanResult solved = targets_.solve(move.goal, end); !solved)
            return tl::unexpected(std::move(solved.error()));
    }
    const Eigen::Vector3d tcp = tcp_of_move(move);
    const Eigen::Vector3d to =
        is_pose_move ? Eigen::Vector3d(move.goal.pose->pose.translation()) : tcp_position(setup, end, tcp);
    GroupPath group_joints =
        is_pose_move ? GroupPath(setup, start, move.goal.pose->group_joints) : GroupPath();
    auto tcp_path =
        make_tcp_path(move, tcp_position(setup, group_joints.with_synchronous_joints(start), tcp), to);
    if (!tcp_path) return tl::unexpected(std::move(tcp_path.error()));
    if (is_pose_move)
        return make_pose_path(setup, *std::move(tcp_path), move.goal.pose->tool, start, move.goal.pose->pose,
                              std::move(group_joints));
    return make_slide_compensated_path(setup, *std::move(tcp_path), tcp, start, end);
}

EnqueueResult ToolMoves::enqueue(const Move& move) {
    if (move.tcp_mm) {
        if (PlanResult checked = machine_.check_tcp_control(); !checked)
            return tl::unexpected(std::move(checked.error()));
    }
    if (move.move_parameters.rapid && move.type == rrs::MotionType::circular)
        return tl::unexpected(std::move(paths_.check_circular(true).error()));
    auto path = make_tool_path(move);
    if (!path) return tl::unexpected(std::move(path.error()));
    auto sub_segments = cut(**path, machine_.setup(), position_.joints());
    if (!sub_segments) return tl::unexpected(std::move(sub_segments.error()));
    PathMove full_move;
    paths_.set_parameters(move, full_move);
    full_move.merge_tolerance_mm = 0;
    set_speed(**path, full_move.rules);
    if (PlanResult result = add_sub_segments(full_move, **path, *sub_segments); !result)
        return tl::unexpected(std::move(result.error()));
    return {};
}

/// The controller's model takes the sub-segments if it supports them. Otherwise another model takes them,
/// which stops at the end.
PlanResult ToolMoves::add_sub_segments(const PathMove& full_move, const ToolPath& path,
                                       const std::vector<PathSubSegment>& sub_segments) {
    const bool is_look_ahead = machine_.setup().controller.capabilities().plans_tool_paths;
    if (!is_look_ahead) {
        buffered_moves_.plan_to_standstill();
        buffered_moves_.clear();
    }
    if (sub_segments.empty() && !is_look_ahead) {
        dwells_.append(full_move.target_id, 0);
        return {};
    }
    MotionModel& model = is_look_ahead ? *buffered_moves_.model() : *exact_stop_model_;
    const bool is_pending = is_look_ahead && timeline_.pending().enqueue(full_move.target_id);
    PathMove move = full_move;
    move.end = position_.joints();
    for (std::size_t i = 0; i < sub_segments.size(); ++i) {
        const PathSubSegment& sub_segment = sub_segments[i];
        move.start = std::exchange(move.end, sub_segment.end);
        move.sub_segment = std::make_shared<const ToolSubSegment>(
            ToolSubSegment{path.role(), sub_segment.share * path.length(), sub_segment.joint_curvature});
        move.reaches_target = i + 1 == sub_segments.size();
        move.share = sub_segment.share;
        if (PlanResult result = model.add(move); !result) {
            if (is_pending) timeline_.pending().discard_last_move();
            if (!is_look_ahead) model.clear();
            return result;
        }
    }
    position_.move_to(move.end);
    if (!is_look_ahead) model.plan_to_standstill();
    return {};
}

}  // namespace gsim::motion
