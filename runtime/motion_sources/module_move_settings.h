#pragma once

#include <string>
#include <utility>
#include <vector>

#include "motion/planner/move.h"
#include "motion/planner/planner_setup.h"
#include "runtime/motion_sources/module_shell.h"

namespace gsim::simulation {

/// Settings of moves in a controller module: of the settings of a move it sends those that the module does
/// not have yet.
class ModuleMoveSettings {
  public:
    /// `shell` and `joints`, the machine's, must outlive this.
    ModuleMoveSettings(ModuleShell& shell, const std::vector<motion::JointSetup>& joints)
        : shell_(shell), joints_(joints) {}

    /// Sends the settings of a move. Returns an error if the module cannot make the move without one.
    rrs::Status send(const motion::Move& move);
    /// Returns messages on settings that the module has not accepted since the last call.
    std::vector<std::string> drain_warnings() { return std::exchange(warnings_, {}); }

  private:
    rrs::Status send_kind(const motion::Move& move);
    rrs::Status send_feed(const motion::MoveParameters& move_parameters);
    rrs::Status send_joint_speeds(const motion::Move& move);
    rrs::JointPos joint_speeds(const motion::Move& move) const;
    void send_blending(const motion::MoveParameters& move_parameters);
    void send_ramps(const motion::MoveParameters& move_parameters);

    ModuleShell& shell_;
    const std::vector<motion::JointSetup>& joints_;
    motion::MoveParameters sent_;  ///< Sent terms: how moves are passed, and their ramps.
    std::vector<std::string> warnings_;
};

}  // namespace gsim::simulation
