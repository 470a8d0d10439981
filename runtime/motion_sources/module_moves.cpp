// Calls of a module's services for moves of a program: first settings that the module does not have yet, then
// the target.

#include <cmath>
#include <utility>

#include "motion/planner/range_check.h"
#include "runtime/motion_sources/module_motion.h"

namespace gsim::simulation {

using rrs::is_refused;
using rrs::MotionType;
using rrs::Status;
using rrs::TargetType;

namespace {

/// Returns true if the service is missing, or the module is broken; any other result leaves the controller as
/// it can be.
bool is_missing(Status status) {
    return status == Status::RRS_SERVICE_NOT_SUPPORTED || status == Status::RRS_MODULE_FAULT;
}

std::span<const double> all_of(const rrs::JointPos& joints) {
    return {joints.data(), static_cast<std::size_t>(joints.size())};
}

}  // namespace

/// Gives each side its own modes: before a client calls, selections that moves have made since are undone.
void ModuleMotion::calling() {
    if (by_program_) return;
    const Modes told = std::exchange(told_, {});
    if (!told.rapid) return;
    by_program([&] {
        RcsShell::SetRapid(client_.terms.rapid);
        SelectTargetType(client_.target_type);
        RcsShell::SelectMotionType(client_.motion_type);
        RcsShell::SetCartesianOrientationSpeed(client_.terms.orientation_speed_rad_s);
        if (client_.terms.position_speed_mm_s > 0)
            RcsShell::SetCartesianPositionSpeed(client_.terms.position_speed_mm_s);
        if (told.joint_speeds) RcsShell::SetJointSpeeds({}, all_of(client_joint_speeds_));
    });
}

Status ModuleMotion::SelectMotionType(MotionType type) {
    const Status status = RcsShell::SelectMotionType(type);
    if (!is_refused(status)) client_.motion_type = type;
    return status;
}

Status ModuleMotion::SetRapid(bool on) {
    const Status status = RcsShell::SetRapid(on);
    if (!is_refused(status)) client_.terms.rapid = on;
    return status;
}

Status ModuleMotion::SetCartesianPositionSpeed(double speed_mm_s) {
    const Status status = RcsShell::SetCartesianPositionSpeed(speed_mm_s);
    if (!is_refused(status)) client_.terms.position_speed_mm_s = speed_mm_s;
    return status;
}

Status ModuleMotion::SetCartesianOrientationSpeed(double speed_rad_s) {
    const Status status = RcsShell::SetCartesianOrientationSpeed(speed_rad_s);
    if (!is_refused(status)) client_.terms.orientation_speed_rad_s = speed_rad_s;
    return status;
}

Status ModuleMotion::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    const Status status = RcsShell::SetJointSpeeds(joints, speeds);
    if (is_refused(status)) return status;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        client_joint_speeds_[joints.empty() ? static_cast<Eigen::Index>(i) : joints[i]] = speeds[i];
    return status;
}

motion::PlanError ModuleMotion::refusal(Status status) {
    motion::PlanError error = last_error();
    error.status = status;
    return error;
}

motion::Put ModuleMotion::answer(Status status) {
    if (is_refused(status)) return tl::unexpected(refusal(status));
    if (status == Status::RRS_MOTION_TIME_RAISED) return motion::TimeRaised{};
    return {};
}

motion::Planned ModuleMotion::start_at(const rrs::JointPos& joints) {
    return by_program([&]() -> motion::Planned {
        Status status = Initialize();
        if (!is_refused(status)) status = SetInitialPosition(rrs::CartPos::Identity(), joints, {});
        if (is_refused(status)) return tl::unexpected(refusal(status));
        return {};
    });
}

motion::Planned ModuleMotion::check_tip(const std::optional<Eigen::Vector3d>& tip_mm) {
    return by_program([&]() -> motion::Planned {
        const Status status = SetTipControl(tip_mm.has_value(), tip_mm.value_or(Eigen::Vector3d::Zero()));
        if (is_refused(status)) return tl::unexpected(refusal(status));
        return {};
    });
}

/// Sends the kind of the move's target and path. Poses are impossible without the services; joint values
/// continue with what the controller has.
Status ModuleMotion::tell_kind(const motion::Move& move) {
    const TargetType target = move.goal.pose ? TargetType::cartesian : TargetType::joint;
    const MotionType type = move.via ? MotionType::circular : move.circle ? MotionType::linear : move.type;
    const auto is_wrong = [&](Status status) {
        return move.goal.pose ? is_refused(status) : is_missing(status);
    };
    if (told_.target_type != target) {
        if (const Status status = SelectTargetType(target); is_wrong(status)) return status;
        told_.motion_type.reset();  // a module may go back to joint motion
    }
    told_.target_type = target;
    if (told_.motion_type != type) {
        const Status status = RcsShell::SelectMotionType(type);
        if (is_wrong(status)) return status;
        told_.joints_alone = status == Status::RRS_MOTION_TYPE_NOT_SUPPORTED;
    }
    told_.motion_type = type;
    if (told_.rapid == move.terms.rapid) return Status::RRS_SUCCESS;
    const Status status = RcsShell::SetRapid(move.terms.rapid);
    const bool knows_none = !move.terms.rapid && status == Status::RRS_SERVICE_NOT_SUPPORTED;
    if (is_missing(status) && !knows_none) return status;
    told_.rapid = move.terms.rapid;
    return Status::RRS_SUCCESS;
}

Status ModuleMotion::tell_feed(const motion::MoveTerms& terms) {
    const bool any_speed = terms.rapid || terms.motion_time_s > 0;  // will do: it does not hold
    const double position_mm_s = any_speed ? motion::kUnlimited : terms.position_speed_mm_s;
    const double orientation_rad_s = any_speed ? motion::kUnlimited : terms.orientation_speed_rad_s;
    if (terms.rapid && told_.position_speed_mm_s) return Status::RRS_SUCCESS;
    if (told_.position_speed_mm_s != position_mm_s) {
        const Status status = RcsShell::SetCartesianPositionSpeed(position_mm_s);
        if (status != Status::RRS_SUCCESS && !any_speed) return status;
        told_.position_speed_mm_s = position_mm_s;
    }
    if (terms.rapid) return Status::RRS_SUCCESS;
    if (told_.orientation_speed_rad_s != orientation_rad_s) {
        const Status status = RcsShell::SetCartesianOrientationSpeed(orientation_rad_s);
        if (status != Status::RRS_SUCCESS && !any_speed) return status;
        told_.orientation_speed_rad_s = orientation_rad_s;
    }
    return terms.motion_time_s > 0 ? SetMotionTime(terms.motion_time_s) : Status::RRS_SUCCESS;
}

/// Returns the speeds for a line of joint values that are independent, because none of the joints carries the
/// tool. They move evenly, all together as fast as the feed says, which is that of the slides if some move.
rrs::JointPos ModuleMotion::joint_speeds_of(const motion::Move& move) const {
    rrs::JointPos speeds = rrs::JointPos::Constant(target_.size(), motion::kUnlimited);
    if (move.terms.rapid || move.terms.motion_time_s > 0) return speeds;
    const rrs::JointPos way = (move.goal.joints - target_).cwiseAbs();
    rrs::JointPos slides = way;
    for (Eigen::Index i = 0; i < way.size(); ++i) {
        if (setup_.joints[static_cast<std::size_t>(i)].kind == rrs::JointKind::revolute) slides[i] = 0;
    }
    const bool turns = slides.isZero(0);
    const double length = turns ? way.norm() : slides.norm();
    const double speed = turns ? move.terms.orientation_speed_rad_s : move.terms.position_speed_mm_s;
    for (Eigen::Index i = 0; i < way.size(); ++i) {
        if (way[i] > 0 && std::isfinite(speed)) speeds[i] = speed * way[i] / length;
    }
    return speeds;
}

Status ModuleMotion::tell_joint_speeds(const motion::Move& move) {
    if (!told_.joints_alone || move.goal.pose) return Status::RRS_SUCCESS;
    const rrs::JointPos speeds = joint_speeds_of(move);
    if (told_.joint_speeds == speeds) return Status::RRS_SUCCESS;
    told_.joint_speeds = speeds;
    const Status status = RcsShell::SetJointSpeeds({}, all_of(speeds));
    if (status != Status::RRS_SERVICE_NOT_SUPPORTED) return status;
    remarks_.emplace_back("the controller has no speeds of joints (SetJointSpeeds): joints move at its own");
    return Status::RRS_SUCCESS;
}

void ModuleMotion::tell_passing(const motion::MoveTerms& terms) {
    if (terms.path_mode == told_terms_.path_mode && terms.tolerance_mm == told_terms_.tolerance_mm &&
        terms.merge_tolerance_mm == told_terms_.merge_tolerance_mm) {
        return;
    }
    told_terms_.path_mode = terms.path_mode;
    told_terms_.tolerance_mm = terms.tolerance_mm;
    told_terms_.merge_tolerance_mm = terms.merge_tolerance_mm;
    if (SetPathMode(terms.path_mode, terms.tolerance_mm, terms.merge_tolerance_mm) ==
        Status::RRS_SERVICE_NOT_SUPPORTED) {
        remarks_.emplace_back(
            "the controller has no path modes (G61, G64): it passes the ends of moves in its own way");
    }
}

void ModuleMotion::tell_ramps(const motion::MoveTerms& terms) {
    if (terms.ramps == told_terms_.ramps) return;
    told_terms_.ramps = terms.ramps;
    motion::ProgrammedRamps ramps =
        terms.ramps ? *terms.ramps : motion::ProgrammedRamps(static_cast<int>(target_.size()));
    const auto tell = [&](Status status) {
        if (is_refused(status)) remarks_.push_back(last_error().message);
    };
    tell(SetRampMode(ramps.mode));
    for (const auto limit :
         {rrs::RampLimit::acceleration, rrs::RampLimit::deceleration, rrs::RampLimit::jerk}) {
        const rrs::JointPos& values = ramps.of(limit);
        tell(SetJointRampLimits(limit, {}, all_of(values)));
    }
}

Status ModuleMotion::tell(const motion::Move& move) {
    if (const Status status = tell_kind(move); is_refused(status)) return status;
    if (const Status status = tell_feed(move.terms); is_refused(status)) return status;
    if (const Status status = tell_joint_speeds(move); is_refused(status)) return status;
    tell_passing(move.terms);
    tell_ramps(move.terms);
    return Status::RRS_SUCCESS;
}

Status ModuleMotion::put_told(const motion::Move& move) {
    if (const Status told = tell(move); is_refused(told)) return told;
    const auto put = [&](rrs::TargetParam param, const motion::Goal& goal) {
        const rrs::CartPos pose = goal.pose ? goal.pose->pose : rrs::CartPos::Identity();
        return SetNextTarget(move.target_id, param, pose, goal.pose ? target_ : goal.joints, {}, 0);
    };
    if (move.circle) {
        return SetNextArcTarget(move.target_id, move.circle->center_mm, move.circle->axis,
                                move.circle->sweep_rad, rrs::CartPos::Identity(), move.goal.joints);
    }
    if (move.via) {
        if (const Status via = put(rrs::TargetParam::via, *move.via); is_refused(via)) return via;
    }
    return put(rrs::TargetParam::end, move.goal);
}

/// Checks ranges first: a module rejects positions past a range with its own message, and the messages of the
/// machine's axes say more.
motion::Put ModuleMotion::put(const motion::Move& move) {
    if (move.goal.pose && !move.goal.pose->led.empty()) {
        return tl::unexpected(motion::PlanError{
            .status = Status::RRS_MODE_NOT_SUPPORTED,
            .message = "A controller module knows no groups of axes; lead their axes by words (G0, G1)."});
    }
    return by_program([&]() -> motion::Put {
        const Status status = put_told(move);
        if (status == Status::RRS_JOINT_LIMIT && !move.goal.pose) {
            if (const auto in_range = motion::check_target_ranges(setup_, move.goal.joints); !in_range)
                return tl::unexpected(in_range.error());
        }
        return answer(status);
    });
}

Status ModuleMotion::put_until_told(const motion::Move& move, const motion::StopSearch& search) {
    const Status status = put_told(move);
    while (!is_refused(status)) {
        const double from_s = time_s_;
        const Status stepped = step();
        if (is_refused(stepped)) return stepped;
        if (time_s_ > from_s && search(segment_)) return stop_here();
        if (stepped == Status::RRS_NEED_MORE_DATA) break;
    }
    return status;
}

motion::Put ModuleMotion::put_until(const motion::Move& move, const motion::StopSearch& search) {
    come_to_rest(true);
    return by_program([&] { return answer(put_until_told(move, search)); });
}

motion::Planned ModuleMotion::put_own(const rrs::JointPos&) {
    return tl::unexpected(
        motion::PlanError{.status = Status::RRS_MODE_NOT_SUPPORTED,
                          .message = "A controller module has no axes that go by themselves."});
}

motion::Planned ModuleMotion::put_rest(const AskedRest& rest) {
    return by_program([&]() -> motion::Planned {
        const Status status = SetNextRest(rest.target_id, rest.rest_s);
        if (is_refused(status)) return tl::unexpected(refusal(status));
        return {};
    });
}

}  // namespace gsim::simulation
