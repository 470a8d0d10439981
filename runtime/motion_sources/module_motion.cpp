#include "runtime/motion_sources/module_motion.h"

#include <utility>

#include "motion/planner/range_check.h"

namespace gsim::simulation {

using rrs::is_error_status;
using rrs::Status;

ModuleMotion::ModuleMotion(rrs::RcsModule module, const motion::PlannerSetup& setup, double max_time_s,
                           motion::SegmentSink& sink)
    : setup_(setup), shell_(std::move(module), setup, max_time_s, sink), settings_(shell_, setup_.joints) {
    setup_.overtravel_log = nullptr;  // they let targets through; what a module refuses is refused
}

motion::PlanError ModuleMotion::last_error() {
    motion::PlanError error;
    error.message = shell_.last_message();
    return error;
}

motion::PlanError ModuleMotion::plan_error(Status status) {
    motion::PlanError error = last_error();
    error.status = status;
    return error;
}

motion::EnqueueResult ModuleMotion::enqueue_result(Status status) {
    if (is_error_status(status)) return tl::unexpected(plan_error(status));
    if (status == Status::RRS_MOTION_TIME_RAISED) return motion::MotionTimeIncrease{};
    return {};
}

motion::PlanResult ModuleMotion::start_at(const rrs::JointPos& joints) {
    return shell_.run_as_program([&]() -> motion::PlanResult {
        Status status = shell_.Initialize();
        if (!is_error_status(status))
            status = shell_.SetInitialPosition(rrs::CartPos::Identity(), joints, {});
        if (is_error_status(status)) return tl::unexpected(plan_error(status));
        return {};
    });
}

motion::PlanResult ModuleMotion::check_tcp(const std::optional<Eigen::Vector3d>& tcp_mm) {
    return shell_.run_as_program([&]() -> motion::PlanResult {
        const Status status =
            shell_.SetTipControl(tcp_mm.has_value(), tcp_mm.value_or(Eigen::Vector3d::Zero()));
        if (is_error_status(status)) return tl::unexpected(plan_error(status));
        return {};
    });
}

Status ModuleMotion::enqueue_move(const motion::Move& move) {
    if (const Status sent = settings_.send(move); is_error_status(sent)) return sent;
    const auto enqueue = [&](rrs::TargetParam param, const motion::Goal& goal) {
        const rrs::CartPos pose = goal.pose ? goal.pose->pose : rrs::CartPos::Identity();
        return shell_.SetNextTarget(move.target_id, param, pose, goal.pose ? position() : goal.joints, {}, 0);
    };
    if (move.circle) {
        return shell_.SetNextArcTarget(move.target_id, move.circle->center_mm, move.circle->axis,
                                       move.circle->sweep_rad, rrs::CartPos::Identity(), move.goal.joints);
    }
    if (move.via) {
        if (const Status via = enqueue(rrs::TargetParam::via, *move.via); is_error_status(via)) return via;
    }
    return enqueue(rrs::TargetParam::end, move.goal);
}

/// Checks ranges first: a module rejects positions past a range with its own message, and the messages of the
/// machine's axes say more.
motion::EnqueueResult ModuleMotion::enqueue(const motion::Move& move) {
    if (move.goal.pose && !move.goal.pose->group_joints.empty()) {
        return tl::unexpected(motion::PlanError{
            .status = Status::RRS_MODE_NOT_SUPPORTED,
            .message =
                "A controller module does not support axis groups; move their axes by words (G0, G1)."});
    }
    return shell_.run_as_program([&]() -> motion::EnqueueResult {
        const Status status = enqueue_move(move);
        if (status == Status::RRS_JOINT_LIMIT && !move.goal.pose) {
            if (const auto in_range = motion::check_target_ranges(setup_, move.goal.joints); !in_range)
                return tl::unexpected(in_range.error());
        }
        return enqueue_result(status);
    });
}

Status ModuleMotion::enqueue_move_until(const motion::Move& move, const motion::StopSearch& search) {
    const Status status = enqueue_move(move);
    while (!is_error_status(status)) {
        const double from_s = time_s();
        const Status step_status = shell_.step();
        if (is_error_status(step_status)) return step_status;
        if (time_s() > from_s && search(shell_.segments().segment())) return shell_.stop_and_cancel();
        if (step_status == Status::RRS_NEED_MORE_DATA) break;
    }
    return status;
}

motion::EnqueueResult ModuleMotion::enqueue_until(const motion::Move& move,
                                                  const motion::StopSearch& search) {
    plan_to_standstill(true);
    return shell_.run_as_program([&] { return enqueue_result(enqueue_move_until(move, search)); });
}

motion::PlanResult ModuleMotion::enqueue_independent(const rrs::JointPos&) {
    return tl::unexpected(
        motion::PlanError{.status = Status::RRS_MODE_NOT_SUPPORTED,
                          .message = "A controller module does not support independent motion of axes."});
}

motion::PlanResult ModuleMotion::enqueue_dwell(const DwellRequest& request) {
    return shell_.run_as_program([&]() -> motion::PlanResult {
        const Status status = shell_.SetNextRest(request.target_id, request.dwell_s);
        if (is_error_status(status)) return tl::unexpected(plan_error(status));
        return {};
    });
}

void ModuleMotion::come_to_rest(rrs::RestReason reason) {
    shell_.run_as_program([&] {
        shell_.ComeToRest(reason);
        shell_.step_to_end();
    });
}

void ModuleMotion::plan_to_standstill(bool waits) {
    come_to_rest(waits ? rrs::RestReason::wait : rrs::RestReason::query);
}

void ModuleMotion::end_program() {
    come_to_rest(rrs::RestReason::end);
}

}  // namespace gsim::simulation
