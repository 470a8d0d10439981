// Moves of the tool to poses in the work frame.

#include "motion/path/tool_path.h"
#include "runtime/simulator/moves/move_queue.h"

namespace gsim::simulation {

void MoveQueue::set_arc_axis(const PoseMove& move, const std::vector<motion::GroupJoint>& group_joints,
                             MoveInfo& info) const {
    const motion::PlannerSetup& setup = motion_.setup();
    const motion::WorkFrames frames = poses_.work_frames();
    const rrs::JointPos& start = motion_.source().position();
    const motion::GroupPath group_path(setup, start, group_joints);
    set_axis(info, setup.kinematics->forward(group_path.with_synchronous_joints(start)) * frames.tcp_mm(),
             (frames.object * *move.via).translation(), (frames.object * move.target).translation());
}

motion::Move MoveQueue::make_pose_move(const PoseMove& move, const MoveInfo& info,
                                       const std::vector<motion::GroupJoint>& group_joints) const {
    const MotionSource& source = motion_.source();
    const motion::WorkFrames frames = source.work_frames().value_or(motion::WorkFrames{});
    const auto goal = [&](const rrs::CartPos& pose) {
        return motion::Goal{{}, motion::PoseGoal{frames.object * pose, frames.tool}};
    };
    motion::Move full_move = program_.make_move(info);
    full_move.goal = goal(move.target);
    full_move.goal.pose->group_joints = group_joints;
    if (position_.tcp_frame() && source.selections().frame_names) full_move.tcp_mm = frames.tcp_mm();
    if (move.via) {
        full_move.type = rrs::MotionType::circular;
        full_move.via = goal(*move.via);
    }
    return full_move;
}

bool MoveQueue::enqueue(const PoseMove& move) {
    if (!groups_.wait_before(move)) return false;
    if (!feeds_.check(move.feed, false, move.location)) return false;
    MoveInfo info = program_.make_info(MoveKind::linear, move.location, move.feed, move.feed.linear_mm_min);
    const std::vector<motion::GroupJoint> group_joints = groups_.joints(move.groups);
    if (move.via) {
        info.turns = 1;
        set_arc_axis(move, group_joints, info);
    }
    const motion::OvertravelPermit pass(ranges_.begin_move());
    motion_.recorder().expect(info);
    motion::Move full_move = make_pose_move(move, info, group_joints);
    feeds_.apply(move.feed, false, full_move);
    const motion::EnqueueResult enqueue = motion_.source().enqueue(full_move);
    if (!enqueue) return outcome_.fail(enqueue.error(), move.location);
    position_.set_joints(motion_.source().position());
    notifier_.notify_unrecordable(
        "the script moves to poses of the tool, which cannot be recorded as moves of the axes; use words "
        "such as G1, or move");
    poses_.warn_if_singular(position_.axes(), move.location);
    return acceptance_.finish(enqueue, move.location);
}

}  // namespace gsim::simulation
