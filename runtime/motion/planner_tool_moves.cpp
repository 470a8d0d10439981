// Targets of DefaultPlanner to which the joints go curved ways, so that the tool's tip goes a straight or
// circular one: under tool-centre-point control, and Cartesian ones where slides alone do not carry the tip.

#include <algorithm>
#include <utility>

#include "runtime/kinematics/pose.h"
#include "runtime/motion/circle.h"
#include "runtime/motion/planner.h"

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

/// An inverse time feed becomes a speed along the whole way.
void set_speed(const ToolPath& path, MoveRules& rules) {
    const double asked_s = std::exchange(rules.least_duration_s, 0);
    if (asked_s <= 0) return;
    if (path.role() == JointRole::rotary) {
        rules.orientation_speed_rad_s = path.length() / asked_s;
    } else {
        rules.programmed_speed_mm_s = path.length() / asked_s;
    }
}

}  // namespace

Status DefaultPlanner::SetTipControl(bool on, const Eigen::Vector3d& tip_mm) {
    if (!initialized_) return not_initialized();
    if (!tip_mm.allFinite())
        return refuse(Status::RRS_INVALID_PARAMETER, "The place of the tip is not finite.");
    if (!on) {
        tip_.reset();
        return Status::RRS_SUCCESS;
    }
    if (slide_count(setup_) < 3) {
        return refuse(
            Status::RRS_MODE_NOT_SUPPORTED,
            "Tool-centre-point control needs three slides, X, Y and Z, which this machine has not.");
    }
    tip_ = tip_mm;
    return Status::RRS_SUCCESS;
}

bool DefaultPlanner::moves_tool(bool along_path) const {
    if (!along_path) return false;
    return tip_ || (tip_turns_ && programmed_.target_type == rrs::TargetType::cartesian);
}

tl::expected<TipWay, PlanError> DefaultPlanner::tip_way(const Eigen::Vector3d& from,
                                                        const Eigen::Vector3d& to,
                                                        const std::optional<Circle>& circle) const {
    TipWay way{.from = from, .to = to};
    if (!circle && programmed_.motion_type == rrs::MotionType::linear) return way;
    way.kind = SegmentKind::circular;
    Planned planned;
    if (circle) {
        const bool by_pose = programmed_.target_type == rrs::TargetType::cartesian;
        const rrs::CartPos frame = by_pose ? work_frames_.object : rrs::CartPos::Identity();
        planned = arc_about(from, to, frame * circle->center_mm, frame.linear() * circle->axis,
                            circle->sweep_rad, setup_.arc_tolerance_mm, way.arc);
    } else if (via_) {
        planned = arc_through(from, tip_of(setup_, *via_, tip_mm()), to, way.arc);
    } else {
        planned = refused(Status::RRS_INVALID_PARAMETER,
                          "Circular motion needs a via point before its target, which tells the circle.");
    }
    if (!planned) return tl::unexpected(std::move(planned.error()));
    return way;
}

/// Where three slides carry the tip the other joints go in proportion; else the tool turns evenly.
tl::expected<std::unique_ptr<ToolPath>, PlanError> DefaultPlanner::tool_path(
    const rrs::CartPos& cartesian, const rrs::JointPos& joints, const std::optional<Circle>& circle) const {
    rrs::JointPos end;
    const bool by_pose = slide_count(setup_) < 3;
    const Planned solved = by_pose ? Planned{} : solve_target(cartesian, joints, end);
    if (!solved) return tl::unexpected(solved.error());
    if (by_pose) {
        if (auto checked = kinematics::check_pose(cartesian); !checked)
            return refused(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    }
    const Eigen::Vector3d tip = tip_mm();
    const rrs::CartPos target = work_frames_.object * cartesian;
    const Eigen::Vector3d to = by_pose ? Eigen::Vector3d(target.translation()) : tip_of(setup_, end, tip);
    auto way = tip_way(tip_of(setup_, position_, tip), to, circle);
    if (!way) return tl::unexpected(std::move(way.error()));
    if (by_pose) return pose_path(setup_, *std::move(way), work_frames_.tool, position_, target);
    return tip_path(setup_, *std::move(way), tip, position_, end);
}

Status DefaultPlanner::put_tool_move(rrs::TargetId id, const rrs::CartPos& cartesian,
                                     const rrs::JointPos& joints, const std::optional<Circle>& circle) {
    if (programmed_.rapid && (circle || programmed_.motion_type == rrs::MotionType::circular))
        return tell(std::move(circular_allowed().error()));
    auto path = tool_path(cartesian, joints, circle);
    if (!path) return tell(std::move(path.error()));
    auto pieces = cut(**path, setup_, position_);
    if (!pieces) return tell(std::move(pieces.error()));
    Move whole;
    whole.target_id = id;
    whole.rules = programmed_.rules(setup_.path);
    set_speed(**path, whole.rules);
    whole.obeyed = programmed_.obeyed;
    whole.rapid = programmed_.rapid;
    whole.mode = programmed_.path_mode;
    whole.tolerance_mm = programmed_.tolerance_mm;
    if (Planned added = add_pieces(whole, **path, *pieces); !added) return tell(std::move(added.error()));
    programmed_.motion_time_s = 0;
    via_.reset();
    if (const double rest_s = std::exchange(programmed_.rest_s, 0); rest_s > 0)
        append_rest(id, dwell_s(rest_s));
    return Status::RRS_SUCCESS;
}

/// The planner's model takes them if it knows what a piece is; else one does that comes to rest at the end.
Planned DefaultPlanner::add_pieces(const Move& whole, const ToolPath& path,
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
    Move move = whole;
    move.end = position_;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const PathPiece& piece = pieces[i];
        move.start = std::exchange(move.end, piece.end);
        move.piece = std::make_shared<const ToolPiece>(
            ToolPiece{path.role(), piece.share * path.length(), piece.bend});
        move.reaches_target = i + 1 == pieces.size();
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
