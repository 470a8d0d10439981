#pragma once

#include <string>
#include <vector>

#include "analysis/check/axis_motion.h"
#include "analysis/check/inverse_check.h"
#include "analysis/check/singular_check.h"
#include "collision/pairs/joint_box_search.h"

namespace gsim::check {

/// Facts that a careful user checks before trusting a machine.
struct MachineCheck {
    machine::Machine machine;
    machine::JointBox box;  ///< Over which all was looked at.
    rrs::CartPos home;      ///< The tool centre point in the work frame, with all axes at home.
    bool has_head = false;  ///< Its two rotary axes turn the tool about its TCP.
    std::vector<AxisMotion> motions = {};
    std::vector<std::string> left_handed = {};  ///< Messages of find_left_handed_axes().
    InverseCheck inverse = {};
    SingularCheck singular = {};
    std::vector<std::string> bodies = {};  ///< Names of the cell's items.
    std::vector<cell::PairFinding> pair_findings = {};
    std::vector<std::string> notes = {};  ///< Messages: possibly intended, but worth a check.

    std::size_t count(cell::Verdict verdict) const;
    /// Returns true if no error was found and no question was left undecided.
    bool is_clean() const;
};

/// Checks a machine that its reader has accepted, with the bodies of a cell: its own ones
/// (cell::make_machine_cell), or those of a cell that was read for it.
MachineCheck check_machine(const machine::Machine& machine, const cell::Cell& cell);

/// Returns the check as readable text, ASCII.
std::string to_text(const MachineCheck& check);
/// Returns the check as JSON (docs/machine-file.md).
std::string to_json(const MachineCheck& check);

/// Returns the joint values of a machine as its axes show them: "A 0 B 45.5", mm and deg.
std::string axis_values_text(const machine::Machine& machine, const rrs::JointPos& joints);

}  // namespace gsim::check
