// Moves of Planner with curved joint paths, so that the TCP follows a straight or circular path: under TCP
// control, and to poses if slides alone do not carry the TCP.

#include <algorithm>
#include <utility>

#include "motion/kinematics/pose.h"
#include "motion/path/circle.h"
#include "motion/planner/planner.h"

namespace gsim::motion {

using rrs::Status;

namespace {

Eigen::Vector3d tcp_position(const PlannerSetup& setup, const rrs::JointPos& joints,
                             const Eigen::Vector3d& tcp_mm) {
    return setup.kinematics->forward(joints) * tcp_mm;
}

std::ptrdiff_t slide_count(const PlannerSetup& setup) {
    return std::count_if(setup.position_joints.begin(), setup.position_joints.end(),
                         [](int joint) { return joint >= 0; });
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

bool Planner::moves_tool(const Move& move) const {
    if (move.type == rrs::MotionType::joint || !is_interpolated(move)) return false;
    return move.tcp_mm ||
           (move.goal.pose && rotary_joints_move_tcp(setup_, move.goal.pose->tool.translation()));
}

/// Returns `via` as a position of the controlled point. It is taken from the pose if joints are `led` on the
/// path, because the joints that would reach it are known only on the path.
tl::expected<Eigen::Vector3d, PlanError> Planner::via_point(const Move& move) const {
    if (move.via->pose && has_fixed_joints()) return Eigen::Vector3d(move.via->pose->pose.translation());
    rrs::JointPos via;
    if (PlanResult solved = solve(*move.via, via); !solved) return tl::unexpected(std::move(solved.error()));
    return tcp_position(setup_, via, tcp_of_move(move));
}

tl::expected<TcpPath, PlanError> Planner::make_tcp_path(const Move& move, const Eigen::Vector3d& from,
                                                        const Eigen::Vector3d& to) const {
    TcpPath tcp_path{.from = from, .to = to};
    if (move.type == rrs::MotionType::linear) return tcp_path;
    tcp_path.kind = SegmentKind::circular;
    PlanResult planned;
    if (move.circle) {
        planned = arc_about(from, to, move.circle->center_mm, move.circle->axis, move.circle->sweep_rad,
                            setup_.arc_tolerance_mm, tcp_path.arc);
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
tl::expected<std::unique_ptr<ToolPath>, PlanError> Planner::make_tool_path(const Move& move) const {
    const bool is_pose_move = move.goal.pose && (slide_count(setup_) < 3 || has_fixed_joints());
    rrs::JointPos end;
    if (is_pose_move) {
        if (auto checked = kinematics::check_pose(move.goal.pose->pose); !checked)
            return make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    } else {
        if (PlanResult solved = solve(move.goal, end); !solved)
            return tl::unexpected(std::move(solved.error()));
    }
    const Eigen::Vector3d tcp = tcp_of_move(move);
    const Eigen::Vector3d to =
        is_pose_move ? Eigen::Vector3d(move.goal.pose->pose.translation()) : tcp_position(setup_, end, tcp);
    GroupPath group_joints =
        is_pose_move ? GroupPath(setup_, position_, move.goal.pose->group_joints) : GroupPath();
    auto tcp_path =
        make_tcp_path(move, tcp_position(setup_, group_joints.with_synchronous_joints(position_), tcp), to);
    if (!tcp_path) return tl::unexpected(std::move(tcp_path.error()));
    if (is_pose_move)
        return make_pose_path(setup_, *std::move(tcp_path), move.goal.pose->tool, position_,
                              move.goal.pose->pose, std::move(group_joints));
    return make_slide_compensated_path(setup_, *std::move(tcp_path), tcp, position_, end);
}

PlanResult Planner::check_tcp_control() const {
    if (slide_count(setup_) >= 3) return {};
    return make_plan_error(
        Status::RRS_MODE_NOT_SUPPORTED,
        "Tool-centre-point control needs three slides, X, Y and Z, which this machine has not.");
}

EnqueueResult Planner::enqueue_tool_move(const Move& move) {
    if (move.tcp_mm) {
        if (PlanResult checked = check_tcp_control(); !checked)
            return tl::unexpected(std::move(checked.error()));
    }
    if (move.move_parameters.rapid && move.type == rrs::MotionType::circular)
        return tl::unexpected(std::move(check_circular(true).error()));
    auto path = make_tool_path(move);
    if (!path) return tl::unexpected(std::move(path.error()));
    auto sub_segments = cut(**path, setup_, position_);
    if (!sub_segments) return tl::unexpected(std::move(sub_segments.error()));
    PathMove full_move;
    set_parameters(move, full_move);
    full_move.merge_tolerance_mm = 0;
    set_speed(**path, full_move.rules);
    if (PlanResult result = add_sub_segments(full_move, **path, *sub_segments); !result)
        return tl::unexpected(std::move(result.error()));
    return {};
}

/// The planner's model takes the sub-segments if it supports them. Otherwise another model takes them, which
/// stops at the end.
PlanResult Planner::add_sub_segments(const PathMove& full_move, const ToolPath& path,
                                     const std::vector<PathSubSegment>& sub_segments) {
    const bool is_look_ahead = setup_.controller.planner == rrs::PlannerKind::look_ahead;
    if (!is_look_ahead && model_) {
        end_model();
        model_->clear();
    }
    if (sub_segments.empty() && !is_look_ahead) {
        append_dwell(full_move.target_id, 0);
        return {};
    }
    MotionModel& model = is_look_ahead ? *model_ : *tool_model_;
    const bool is_pending = is_look_ahead && pending_.enqueue(full_move.target_id);
    PathMove move = full_move;
    move.end = position_;
    for (std::size_t i = 0; i < sub_segments.size(); ++i) {
        const PathSubSegment& sub_segment = sub_segments[i];
        move.start = std::exchange(move.end, sub_segment.end);
        move.sub_segment = std::make_shared<const ToolSubSegment>(
            ToolSubSegment{path.role(), sub_segment.share * path.length(), sub_segment.joint_curvature});
        move.reaches_target = i + 1 == sub_segments.size();
        move.share = sub_segment.share;
        if (PlanResult result = model.add(move); !result) {
            if (is_pending) pending_.retract_last();
            if (!is_look_ahead) model.clear();
            return result;
        }
    }
    position_ = move.end;
    if (!is_look_ahead) model.plan_to_standstill();
    return {};
}

}  // namespace gsim::motion
