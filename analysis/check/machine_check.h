#pragma once

#include <string>
#include <vector>

#include "analysis/check/axis_motion.h"
#include "analysis/check/inverse_check.h"
#include "analysis/check/singular_check.h"
#include "collision/pairs/joint_box_search.h"

namespace gsim::check {

/// What a careful person would want to know of a machine before it is trusted.
struct MachineCheck {
    machine::Machine machine;
    machine::JointBox box;  ///< Over which all was looked at.
    rrs::CartPos home;      ///< The tool centre point in the work frame, with all axes at home.
    bool has_head = false;  ///< Its two rotary axes turn the tool about its tip.
    std::vector<AxisMotion> motions = {};
    std::vector<std::string> left_handed = {};  ///< Sentences of find_left_handed().
    InverseCheck inverse = {};
    SingularCheck singular = {};
    std::vector<std::string> bodies = {};  ///< Names of the cell's items.
    std::vector<cell::MeetingFinding> meetings = {};
    std::vector<std::string> notes = {};  ///< Sentences: what may be meant so, but is worth a look.

    std::size_t count(cell::Verdict verdict) const;
    /// Nothing is wrong, and nothing was left undecided.
    bool is_clean() const;
};

/// Checks a machine that its reader has let pass, with the bodies of a cell: its own ones
/// (cell::cell_of_machine), or those of a cell that was read for it.
MachineCheck check_machine(const machine::Machine& machine, const cell::Cell& cell);

/// The check for people, ASCII.
std::string to_text(const MachineCheck& check);
/// The check as JSON (docs/machine-file.md).
std::string to_json(const MachineCheck& check);

/// The joint values of a machine as its axes read them: "A 0 B 45.5", mm and deg.
std::string axis_values(const machine::Machine& machine, const rrs::JointPos& joints);

}  // namespace gsim::check
