// Moves of the tool in the work frame: TCP control and moves to poses.

#include "motion/path/tool_path.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

using text::DiagnosticKind;

using rrs::Status;

tl::expected<TcpFrame, std::string> Simulator::make_tcp_frame(const Eigen::Vector3d& offset_mm) const {
    const AxisVector zero = AxisVector::Zero(static_cast<Eigen::Index>(machine_.axes.size()));
    return TcpFrame::make(setup_, to_joints(zero), machine_frames_.tool_shift().translation(), offset_mm);
}

/// Updates the TCP of the tool in use as the machine carries it, even if the program does not set the TCP.
void Simulator::update_tcp() {
    const auto frame = make_tcp_frame(tool_offset_mm_);
    const Eigen::Vector3d tcp_mm = frame ? frame->tcp_mm() : machine_frames_.tool_shift().translation();
    path_deviation_monitor_.set_tcp(tcp_mm);
    tcp_ = tcps_.number(tcp_mm);
}

void Simulator::set_tool_offset(const Eigen::Vector3d& offset_mm) {
    if (offset_mm == tool_offset_mm_) return;
    tool_offset_mm_ = offset_mm;
    if (observer_ != nullptr) observer_->tool_offset(offset_mm);
    zones_.set_tool_offset(offset_mm, next_id_);
    update_tcp();
}

bool Simulator::set_tcp_control(const std::optional<Eigen::Vector3d>& offset_mm,
                                const SourceLocation& location) {
    if (!offset_mm && !tcp_frame_) return true;
    wait();
    std::optional<TcpFrame> frame;
    if (offset_mm) {
        auto tcp_frame_result = make_tcp_frame(*offset_mm);
        if (!tcp_frame_result) return fail(DiagnosticKind::machine, tcp_frame_result.error(), location);
        frame = *tcp_frame_result;
    }
    const motion::PlanResult planned =
        motion_->check_tcp(frame ? std::optional(frame->tcp_mm()) : std::optional<Eigen::Vector3d>());
    if (!planned && planned.error().status == Status::RRS_SERVICE_NOT_SUPPORTED)
        return fail(DiagnosticKind::mode, "this controller has no tool-centre-point control", location);
    if (!planned) return report_plan_error(planned.error(), location);
    tcp_frame_ = frame;
    tcp_offset_mm_ = offset_mm.value_or(Eigen::Vector3d::Zero());
    if (frame && observer_ != nullptr)
        observer_->on_unrecordable_motion("tool-centre-point control (G43.4) moves the tip, not the axes");
    position_ = position_at(motion_->position());
    return true;
}

tl::expected<rrs::JointPos, std::string> Simulator::solve_joints(const AxisVector& target) const {
    if (tcp_frame_) return tcp_frame_->joints(setup_, to_joints(target));
    return to_joints(target);
}

AxisVector Simulator::position_at(const rrs::JointPos& joints) const {
    return to_axes(tcp_frame_ ? tcp_frame_->coordinates(setup_, joints) : joints);
}

tl::expected<AxisVector, std::string> Simulator::solve_axes(const rrs::CartPos& pose,
                                                            const std::vector<GroupTarget>& groups) const {
    rrs::JointPos near = to_joints(position_);
    for (const motion::GroupJoint& one : coordinated_joints(groups)) near[one.joint] = one.value;
    return setup_.kinematics->inverse(work_frames().to_tool_centre(pose), near)
        .map([this](const rrs::JointPos& joints) { return to_axes(joints); });
}

bool Simulator::move(const PoseMove& move) {
    if (!wait_if_coordinated(move)) return false;
    if (!check_feed(move.feed, false, move.location)) return false;
    MoveInfo info = make_move_info(MoveKind::linear, move.location, move.feed.linear_mm_min);
    info.timed = move.feed.motion_s.has_value();
    apply_override_rules(info, move.feed);
    const std::vector<motion::GroupJoint> group_joints = coordinated_joints(move.groups);
    if (move.via) {
        info.turns = 1;
        const motion::WorkFrames frames = work_frames();
        const motion::GroupPath coordinated_path(setup_, motion_->position(), group_joints);
        set_axis(info,
                 setup_.kinematics->forward(coordinated_path.with_synchronous_joints(motion_->position())) *
                     frames.tcp_mm(),
                 (frames.object * *move.via).translation(), (frames.object * move.target).translation());
    }
    const motion::OvertravelPermit pass(begin_move());
    recorder_.expect(info);
    const motion::WorkFrames frames = motion_->work_frames().value_or(motion::WorkFrames{});
    const auto goal = [&](const rrs::CartPos& pose) {
        return motion::Goal{{}, motion::PoseGoal{frames.object * pose, frames.tool}};
    };
    motion::Move full_move = make_move(info);
    full_move.goal = goal(move.target);
    full_move.goal.pose->group_joints = group_joints;
    if (tcp_frame_ && motion_->selections().frame_names) full_move.tcp_mm = frames.tcp_mm();
    if (move.via) {
        full_move.type = rrs::MotionType::circular;
        full_move.via = goal(*move.via);
    }
    set_move_time(move.feed, false, full_move);
    const motion::EnqueueResult enqueue = motion_->enqueue(full_move);
    if (!enqueue) return report_plan_error(enqueue.error(), move.location);
    position_ = position_at(motion_->position());
    if (observer_ != nullptr) {
        observer_->on_unrecordable_motion(
            "the script moves to poses of the tool, which the recorder is not told as moves of the axes; use "
            "words such as G1, or move");
    }
    warn_if_singular(position_, move.location);
    return finish_move(enqueue, move.location);
}

}  // namespace gsim::simulation
