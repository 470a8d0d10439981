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

Eigen::Vector3d tip_of(const PlannerSetup& setup, const rrs::JointPos& joints,
                       const Eigen::Vector3d& tip_mm) {
    return setup.kinematics->forward(joints) * tip_mm;
}

std::ptrdiff_t slide_count(const PlannerSetup& setup) {
    return std::count_if(setup.position_joints.begin(), setup.position_joints.end(),
                         [](int joint) { return joint >= 0; });
}

/// Converts an inverse time feed into a speed along the full path.
void set_speed(const ToolPath& path, MoveRules& rules) {
    const double asked_s = std::exchange(rules.least_duration_s, 0);
    if (asked_s <= 0) return;
    if (path.role() == JointRole::rotary) {
        rules.orientation_speed_rad_s = path.length() / asked_s;
    } else {
        rules.programmed_speed_mm_s = path.length() / asked_s;
    }
}

/// Returns the point that follows the path, in the frame of the tool centre point.
Eigen::Vector3d tip_of_move(const Move& move) {
    if (move.tip_mm) return *move.tip_mm;
    return move.goal.pose ? Eigen::Vector3d(move.goal.pose->tool.translation()) : Eigen::Vector3d::Zero();
}

}  // namespace

bool Planner::moves_tool(const Move& move) const {
    if (move.type == rrs::MotionType::joint || !interpolates(move)) return false;
    return move.tip_mm || (move.goal.pose && tip_turns(setup_, move.goal.pose->tool.translation()));
}

/// Returns `via` as a position of the controlled point. It is taken from the pose if joints are `led` on the
/// path, because the joints that would reach it are known only on the path.
tl::expected<Eigen::Vector3d, PlanError> Planner::via_point(const Move& move) const {
    if (move.via->pose && holds_joints()) return Eigen::Vector3d(move.via->pose->pose.translation());
    rrs::JointPos via;
    if (Planned solved = solve(*move.via, via); !solved) return tl::unexpected(std::move(solved.error()));
    return tip_of(setup_, via, tip_of_move(move));
}

tl::expected<TipWay, PlanError> Planner::tip_way(const Move& move, const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to) const {
    TipWay way{.from = from, .to = to};
    if (move.type == rrs::MotionType::linear) return way;
    way.kind = SegmentKind::circular;
    Planned planned;
    if (move.circle) {
        planned = arc_about(from, to, move.circle->center_mm, move.circle->axis, move.circle->sweep_rad,
                            setup_.arc_tolerance_mm, way.arc);
    } else if (move.via) {
        const auto via = via_point(move);
        if (!via) return tl::unexpected(via.error());
        planned = arc_through(from, *via, to, way.arc);
    } else {
        planned = no_via_point();
    }
    if (!planned) return tl::unexpected(std::move(planned.error()));
    return way;
}

/// The other joints move in proportion if three slides carry the controlled point. Otherwise, and if the
/// inverse holds joints, the tool turns evenly.
tl::expected<std::unique_ptr<ToolPath>, PlanError> Planner::tool_path(const Move& move) const {
    const bool by_pose = move.goal.pose && (slide_count(setup_) < 3 || holds_joints());
    rrs::JointPos end;
    if (by_pose) {
        if (auto checked = kinematics::check_pose(move.goal.pose->pose); !checked)
            return refused(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    } else {
        if (Planned solved = solve(move.goal, end); !solved) return tl::unexpected(std::move(solved.error()));
    }
    const Eigen::Vector3d tip = tip_of_move(move);
    const Eigen::Vector3d to =
        by_pose ? Eigen::Vector3d(move.goal.pose->pose.translation()) : tip_of(setup_, end, tip);
    LedWay led = by_pose ? LedWay(setup_, position_, move.goal.pose->led) : LedWay();
    auto way = tip_way(move, tip_of(setup_, led.as_seen(position_), tip), to);
    if (!way) return tl::unexpected(std::move(way.error()));
    if (by_pose)
        return pose_path(setup_, *std::move(way), move.goal.pose->tool, position_, move.goal.pose->pose,
                         std::move(led));
    return tip_path(setup_, *std::move(way), tip, position_, end);
}

Planned Planner::check_tip_control() const {
    if (slide_count(setup_) >= 3) return {};
    return refused(Status::RRS_MODE_NOT_SUPPORTED,
                   "Tool-centre-point control needs three slides, X, Y and Z, which this machine has not.");
}

Put Planner::put_tool_move(const Move& move) {
    if (move.tip_mm) {
        if (Planned checked = check_tip_control(); !checked)
            return tl::unexpected(std::move(checked.error()));
    }
    if (move.terms.rapid && move.type == rrs::MotionType::circular)
        return tl::unexpected(std::move(circular_allowed(true).error()));
    auto path = tool_path(move);
    if (!path) return tl::unexpected(std::move(path.error()));
    auto pieces = cut(**path, setup_, position_);
    if (!pieces) return tl::unexpected(std::move(pieces.error()));
    PathMove whole;
    set_terms(move, whole);
    whole.merge_tolerance_mm = 0;
    set_speed(**path, whole.rules);
    if (Planned added = add_pieces(whole, **path, *pieces); !added)
        return tl::unexpected(std::move(added.error()));
    return {};
}

/// The planner's model takes the sub-segments if it supports them. Otherwise another model takes them, which
/// stops at the end.
Planned Planner::add_pieces(const PathMove& whole, const ToolPath& path,
                            const std::vector<PathPiece>& pieces) {
    const bool own = setup_.controller.planner == rrs::PlannerKind::look_ahead;
    if (!own && model_) {
        end_model();
        model_->clear();
    }
    if (pieces.empty() && !own) {
        append_rest(whole.target_id, 0);
        return {};
    }
    MotionModel& model = own ? *model_ : *tool_model_;
    const bool held = own && held_.put(whole.target_id);
    PathMove move = whole;
    move.end = position_;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const PathPiece& piece = pieces[i];
        move.start = std::exchange(move.end, piece.end);
        move.piece = std::make_shared<const ToolPiece>(
            ToolPiece{path.role(), piece.share * path.length(), piece.bend});
        move.reaches_target = i + 1 == pieces.size();
        move.share = piece.share;
        if (Planned added = model.add(move); !added) {
            if (held) held_.take_back();
            if (!own) model.clear();
            return added;
        }
    }
    position_ = move.end;
    if (!own) model.come_to_rest();
    return {};
}

}  // namespace gsim::motion
