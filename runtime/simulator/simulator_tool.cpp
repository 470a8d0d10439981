// Moves of the tool in the work frame: TCP control and moves to poses.

#include "motion/path/tool_path.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

using text::DiagnosticKind;

using rrs::Status;

tl::expected<TipFrame, std::string> Simulator::tip_frame_of(const Eigen::Vector3d& offset_mm) const {
    const AxisVector zero = AxisVector::Zero(static_cast<Eigen::Index>(machine_.axes.size()));
    return TipFrame::make(setup_, to_joints(zero), machine_frames_.tool_shift().translation(), offset_mm);
}

/// Updates the TCP of the tool in use as the machine carries it, even if the program does not set the TCP.
void Simulator::tip_changed() {
    const auto frame = tip_frame_of(tool_offset_mm_);
    const Eigen::Vector3d tip_mm = frame ? frame->tip_mm() : machine_frames_.tool_shift().translation();
    way_deviation_.set_tip(tip_mm);
    tip_ = tips_.number(tip_mm);
}

void Simulator::set_tool_offset(const Eigen::Vector3d& offset_mm) {
    if (offset_mm == tool_offset_mm_) return;
    tool_offset_mm_ = offset_mm;
    if (observer_ != nullptr) observer_->tool_offset(offset_mm);
    zones_.set_tool_offset(offset_mm, next_id_);
    tip_changed();
}

bool Simulator::set_tip_control(const std::optional<Eigen::Vector3d>& offset_mm, const Place& place) {
    if (!offset_mm && !tip_frame_) return true;
    wait();
    std::optional<TipFrame> frame;
    if (offset_mm) {
        auto made = tip_frame_of(*offset_mm);
        if (!made) return fail(DiagnosticKind::machine, made.error(), place);
        frame = *made;
    }
    const motion::Planned taken =
        motion_->check_tip(frame ? std::optional(frame->tip_mm()) : std::optional<Eigen::Vector3d>());
    if (!taken && taken.error().status == Status::RRS_SERVICE_NOT_SUPPORTED)
        return fail(DiagnosticKind::mode, "this controller has no tool-centre-point control", place);
    if (!taken) return refused(taken.error(), place);
    tip_frame_ = frame;
    tip_offset_mm_ = offset_mm.value_or(Eigen::Vector3d::Zero());
    if (frame && observer_ != nullptr)
        observer_->untold_motion("tool-centre-point control (G43.4) moves the tip, not the axes");
    position_ = position_at(motion_->position());
    return true;
}

tl::expected<rrs::JointPos, std::string> Simulator::joints_of(const AxisVector& target) const {
    if (tip_frame_) return tip_frame_->joints(setup_, to_joints(target));
    return to_joints(target);
}

AxisVector Simulator::position_at(const rrs::JointPos& joints) const {
    return to_axes(tip_frame_ ? tip_frame_->coordinates(setup_, joints) : joints);
}

tl::expected<AxisVector, std::string> Simulator::axes_of(const rrs::CartPos& pose,
                                                         const std::vector<GroupTarget>& groups) const {
    rrs::JointPos near = to_joints(position_);
    for (const motion::LedJoint& one : led_joints(groups)) near[one.joint] = one.value;
    return setup_.kinematics->inverse(work_frames().tool_centre_of(pose), near)
        .map([this](const rrs::JointPos& joints) { return to_axes(joints); });
}

bool Simulator::move(const PoseMove& move) {
    if (!wait_if_led(move)) return false;
    if (!check_feed(move.feed, false, move.place)) return false;
    MoveInfo info = next_move(MoveKind::linear, move.place, move.feed.linear_mm_min);
    info.timed = move.feed.motion_s.has_value();
    obey_overrides(info, move.feed);
    const std::vector<motion::LedJoint> led = led_joints(move.groups);
    if (move.via) {
        info.turns = 1;
        const motion::WorkFrames frames = work_frames();
        const motion::LedWay way(setup_, motion_->position(), led);
        set_axis(info, setup_.kinematics->forward(way.as_seen(motion_->position())) * frames.tip_mm(),
                 (frames.object * *move.via).translation(), (frames.object * move.target).translation());
    }
    const motion::RangePass pass(begin_move());
    recorder_.expect(info);
    const motion::WorkFrames frames = motion_->work_frames().value_or(motion::WorkFrames{});
    const auto goal = [&](const rrs::CartPos& pose) {
        return motion::Goal{{}, motion::PoseGoal{frames.object * pose, frames.tool}};
    };
    motion::Move whole = new_move(info);
    whole.goal = goal(move.target);
    whole.goal.pose->led = led;
    if (tip_frame_ && motion_->selections().frame_names) whole.tip_mm = frames.tip_mm();
    if (move.via) {
        whole.type = rrs::MotionType::circular;
        whole.via = goal(*move.via);
    }
    set_time_of(move.feed, false, whole);
    const motion::Put put = motion_->put(whole);
    if (!put) return refused(put.error(), move.place);
    position_ = position_at(motion_->position());
    if (observer_ != nullptr) {
        observer_->untold_motion(
            "the script moves to poses of the tool, which the recorder is not told as moves of the axes; use "
            "words such as G1, or move");
    }
    warn_if_singular(position_, move.place);
    return finish_move(put, move.place);
}

}  // namespace gsim::simulation
