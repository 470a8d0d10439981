#pragma once

#include "machine/model/machine.h"
#include "motion/path/machine_frames.h"
#include "motion/planner/move.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/move_settings.h"
#include "runtime/simulator/program/process_state.h"
#include "runtime/simulator/program/program_calls.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/program_zones.h"
#include "runtime/simulator/program/ramp_settings.h"
#include "runtime/simulator/program/source_files.h"
#include "runtime/simulator/program/target_ids.h"
#include "runtime/simulator/program/tool_offset.h"
#include "runtime/simulator/program/work_offsets.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Modal state of a program: makes of it what each move has in addition to its target.
class ProgramState {
  public:
    /// Begins as a program begins. All arguments must outlive this.
    ProgramState(const machine::Machine& machine, MachineMotion& motion, const ProgramPosition& position,
                 const ProgramNotifier& notifier, Warnings& warnings);
    ProgramState(const ProgramState&) = delete;
    ProgramState& operator=(const ProgramState&) = delete;

    SourceFiles& files() { return files_; }
    const SourceFiles& files() const { return files_; }
    TargetIds& ids() { return ids_; }
    const TargetIds& ids() const { return ids_; }
    ProgramCalls& calls() { return calls_; }
    const ProgramCalls& calls() const { return calls_; }
    WorkOffsets& work_offsets() { return work_offsets_; }
    const WorkOffsets& work_offsets() const { return work_offsets_; }
    ProcessState& process() { return process_; }
    ProgramZones& zones() { return zones_; }
    /// Returns the frames "tool" and "base" of the machine as the program has set them.
    motion::MachineFrames& machine_frames() { return machine_frames_; }
    const motion::MachineFrames& machine_frames() const { return machine_frames_; }
    ToolOffset& tool() { return tool_; }
    const ToolOffset& tool() const { return tool_; }
    MoveSettings& settings() { return settings_; }
    RampSettings& ramps() { return ramps_; }

    /// Returns the data of a new target of the program for reports, without the rules of overrides. The feed
    /// is in mm/min or deg/min.
    MoveInfo make_info(MoveKind kind, const SourceLocation& location, double feed_per_min);
    /// Returns the same with the rules of overrides for a move of this feed.
    MoveInfo make_info(MoveKind kind, const SourceLocation& location, const Feed& feed, double feed_per_min);
    /// Returns the move without its target, with the present settings, on top of those that clients of the
    /// services have selected.
    motion::Move make_move(const MoveInfo& info) const;

  private:
    MachineMotion& motion_;
    const ProgramPosition& position_;
    SourceFiles files_;
    TargetIds ids_;
    ProgramCalls calls_;
    WorkOffsets work_offsets_;
    ProcessState process_;
    ProgramZones zones_;
    motion::MachineFrames machine_frames_;
    ToolOffset tool_;
    MoveSettings settings_;
    RampSettings ramps_;
};

}  // namespace gsim::simulation
