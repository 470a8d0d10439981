#include "motion/moves/path_builder.h"

#include <utility>

#include "motion/exact_stop/arc_move.h"
#include "motion/path/circle.h"
#include "motion/path/orientation_path.h"
#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

tl::unexpected<PlanError> no_via_point_error() {
    return make_plan_error(Status::RRS_INVALID_PARAMETER,
                           "Circular motion needs a via point before its target, which defines the circle.");
}

tl::expected<const PathMove*, PlanError> PathBuilder::build(const Move& move) {
    if (PlanResult built = build_path(move); !built) return tl::unexpected(std::move(built.error()));
    return &path_;
}

void PathBuilder::set_parameters(const Move& move, PathMove& path) const {
    const MoveParameters& move_parameters = move.move_parameters;
    const PlannerSetup& setup = machine_.setup();
    path.target_id = move.target_id;
    path.start = position_.joints();
    path.rules = move_parameters.rules(setup.path);
    path.enabled_overrides = move_parameters.enabled_overrides;
    path.rapid = move_parameters.rapid;
    const bool stops =
        move_parameters.path_mode == rrs::PathMode::exact_path && setup.controller.corners.exact_path_stops;
    path.mode = stops ? rrs::PathMode::exact_stop : move_parameters.path_mode;
    path.tolerance_mm = move_parameters.tolerance_mm;
    path.merge_tolerance_mm = move_parameters.merge_tolerance_mm;
}

PlanResult PathBuilder::build_path(const Move& move) {
    const PlannerSetup& setup = machine_.setup();
    set_parameters(move, path_);
    path_.kind = SegmentKind::linear;
    path_.orientation.reset();
    if (PlanResult solved = targets_.solve(move.goal, path_.end); !solved) return solved;
    if (move.type == rrs::MotionType::circular) {
        if (PlanResult built = build_circle(move); !built) return built;
    }
    if (setup.controller.coordination.orientation != rrs::OrientationRule::joints && !path_.rapid) {
        auto joint_path = orientation_between(setup, path_.start, path_.end);
        if (!joint_path) return tl::unexpected(std::move(joint_path.error()));
        path_.orientation = *std::move(joint_path);
    }
    if (path_.kind != SegmentKind::circular) return {};
    PlanResult checked = check_arc(setup, path_.arc);
    return checked && !tracked_frame_.is_active() ? check_arc_ranges(setup, path_.arc) : checked;
}

PlanResult PathBuilder::build_circle(const Move& move) {
    path_.kind = SegmentKind::circular;
    if (PlanResult allowed = check_circular(move.move_parameters.rapid); !allowed) return allowed;
    if (move.circle) return build_circle_about_center(move, *move.circle);
    if (!move.via) return no_via_point_error();
    rrs::JointPos via;
    if (PlanResult solved = targets_.solve(*move.via, via); !solved) return solved;
    const PlannerSetup& setup = machine_.setup();
    return arc_through(read_position(setup, path_.start), read_position(setup, via),
                       read_position(setup, path_.end), path_.arc);
}

PlanResult PathBuilder::build_circle_about_center(const Move& move, const Circle& circle) {
    const PlannerSetup& setup = machine_.setup();
    const Eigen::Vector3d start = read_position(setup, path_.start);
    const Eigen::Vector3d end = read_position(setup, path_.end);
    if (!move.goal.pose) {
        return arc_about(start, end, circle.center_mm, circle.axis, circle.sweep_rad, setup.arc_tolerance_mm,
                         path_.arc);
    }
    const AxisSpace* axis_space = machine_.axis_space();
    if (axis_space == nullptr) {
        return make_plan_error(Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
                               "This machine accepts the centre of an arc only with joint targets: its "
                               "position joints do not span the space of the work frame.");
    }
    // The tool does not turn here, so its centre point follows the same circle next to that of the tool
    // frame.
    const rrs::CartPos tool = setup.kinematics->forward(position_.joints());
    const Eigen::Vector3d center = circle.center_mm - tool.linear() * move.goal.pose->tool.translation();
    return arc_about(start, end, axis_space->point(center), axis_space->turn_axis(circle.axis),
                     circle.sweep_rad, setup.arc_tolerance_mm, path_.arc);
}

PlanResult PathBuilder::check_circular(bool rapid) const {
    if (!machine_.setup().has_position_joints()) {
        return make_plan_error(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "Circular motion needs joints that carry the position of the tool; this machine has none.");
    }
    if (rapid) {
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Rapid circular motion is not possible; switch SetRapid off.");
    }
    return {};
}

}  // namespace gsim::motion
