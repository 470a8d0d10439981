#include "analysis/check/machine_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/json_text.h"

namespace gsim::check {

namespace {

const char* unit(const machine::Axis& axis) {
    return axis.kind == machine::AxisKind::linear ? "mm" : "deg";
}

void add_limit_notes(const machine::Axis& axis, std::vector<std::string>& notes) {
    if (axis.min == axis.max) notes.push_back(fmt::format("axis {} has a range of zero", axis.letter));
    std::string missing;
    if (std::isinf(axis.max_speed)) missing = "no speed limit";
    if (std::isinf(axis.max_acceleration))
        missing += missing.empty() ? "no acceleration limit" : " and no acceleration limit";
    if (!missing.empty()) notes.push_back(fmt::format("axis {} has {}", axis.letter, missing));
}

void add_box_note(const MachineCheck& check, std::vector<std::string>& notes) {
    for (const int joint : check.box.cut) {
        const machine::Axis& axis = check.machine.axes[static_cast<std::size_t>(joint)];
        notes.push_back(fmt::format("axis {} has an unlimited range; checked from {:.6g} to {:.6g} {}",
                                    axis.letter, machine::axis_value(axis, check.box.low[joint]),
                                    machine::axis_value(axis, check.box.high[joint]), unit(axis)));
    }
}

std::vector<std::string> find_notes(const MachineCheck& check) {
    std::vector<std::string> notes;
    for (const machine::Axis& axis : check.machine.axes) add_limit_notes(axis, notes);
    add_box_note(check, notes);
    for (const std::string& turn : find_left_handed_rotations(check.motions)) notes.push_back(turn);
    if (check.inverse.poses == 0)
        notes.emplace_back("the machine has no inverse: programs move joints, and poses are rejected");
    if (check.singular.at_home) notes.emplace_back("home is at or near a singularity");
    if (check.bodies.empty())
        notes.emplace_back("the machine has no bodies ([[shape]]), so collisions are not checked");
    return notes;
}

}  // namespace

std::size_t MachineCheck::count(cell::Verdict verdict) const {
    return static_cast<std::size_t>(std::count_if(pair_findings.begin(), pair_findings.end(),
                                                  [verdict](const auto& m) { return m.verdict == verdict; }));
}

bool MachineCheck::is_clean() const {
    return left_handed.empty() && inverse.is_consistent() &&
           count(cell::Verdict::free) == pair_findings.size();
}

MachineCheck check_machine(const machine::Machine& machine, const cell::Cell& cell) {
    const auto kinematics = machine::make_kinematics(machine);
    MachineCheck check{.machine = machine,
                       .box = machine::joint_box(machine),
                       .home = kinematics->forward(machine::home_position(machine)),
                       .has_head = kinematics->tilting_head().has_value()};
    check.motions = axis_motions(machine);
    check.left_handed = find_left_handed_axes(check.motions);
    check.inverse = check_inverse(machine, check.box);
    check.singular = check_singular(machine, check.box);
    check.bodies.reserve(cell.items.size());
    for (const cell::Item& item : cell.items) check.bodies.push_back(item.name);
    check.pair_findings = cell::search_joint_box(cell, machine, check.box);
    check.notes = find_notes(check);
    return check;
}

std::string axis_values_text(const machine::Machine& machine, const rrs::JointPos& joints) {
    std::string text;
    Eigen::Index joint = 0;
    for (const machine::Axis& axis : machine.axes) {
        const double value = std::round(machine::axis_value(axis, joints[joint++]) * 1e3) / 1e3;
        text += fmt::format("{}{} {}", text.empty() ? "" : " ", axis.letter, text::rounded(value));
    }
    return text;
}

}  // namespace gsim::check
