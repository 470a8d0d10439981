#include "runtime/simulator/program/program_state.h"

namespace gsim::simulation {

ProgramState::ProgramState(const machine::Machine& machine, MachineMotion& motion,
                           const ProgramPosition& position, const ProgramNotifier& notifier,
                           Warnings& warnings)
    : motion_(motion),
      position_(position),
      calls_(motion.recorder(), ids_, notifier),
      work_offsets_(notifier),
      process_(machine, motion.recorder(), ids_),
      zones_(motion.zones(), ids_, warnings),
      machine_frames_(motion.setup().kinematics->chain()),
      tool_(motion, position, machine_frames_, ids_, notifier),
      settings_(machine, motion.setup(), position, notifier),
      ramps_(machine, motion, position, notifier, warnings) {}

MoveInfo ProgramState::make_info(MoveKind kind, const SourceLocation& location, double feed_per_min) {
    MoveInfo info;
    info.target_id = ids_.assign(location);
    motion_.path_deviation().expect(info.target_id, location);
    info.kind = kind;
    info.location = location;
    info.feed_per_min = feed_per_min;
    process_.begin_move(info);
    info.offset = work_offsets_.index();
    info.tcp = tool_.tcp();
    info.program = calls_.current();
    return info;
}

MoveInfo ProgramState::make_info(MoveKind kind, const SourceLocation& location, const Feed& feed,
                                 double feed_per_min) {
    MoveInfo info = make_info(kind, location, feed_per_min);
    info.timed = feed.motion_s.has_value();
    settings_.apply_override_rules(feed, info);
    return info;
}

motion::Move ProgramState::make_move(const MoveInfo& info) const {
    motion::Move move;
    move.target_id = info.target_id;
    if (const auto& frame = position_.tcp_frame()) move.tcp_mm = frame->tcp_mm();
    motion::MoveParameters& parameters = move.move_parameters;
    parameters = motion_.source().selections().move_parameters;
    parameters.rapid = info.kind == MoveKind::rapid;
    settings_.apply(parameters);
    parameters.motion_time_s = 0;
    parameters.enabled_overrides = info.enabled_overrides;
    parameters.follows_spindle = info.follows_spindle;
    if (ramps_.programmed()) parameters.ramps = ramps_.programmed();
    return move;
}

}  // namespace gsim::simulation
