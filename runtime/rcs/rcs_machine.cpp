#include "runtime/rcs/rcs_machine.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/toml/toml_writer.h"
#include "controller/module/rcs_values.h"
#include "machine/file/controller_file.h"
#include "machine/schema/controller_keys.h"
#include "motion/kinematics/chain_kinematics.h"
#include "motion/kinematics/gantry.h"
#include "motion/kinematics/numeric_kinematics.h"

namespace gsim::rcs {

namespace {

using Kinematics = std::shared_ptr<const kinematics::Kinematics>;

gsim_rcs_joint to_rcs(const motion::JointSetup& joint) {
    gsim_rcs_joint result{};
    result.kind = joint.kind == rrs::JointKind::revolute ? GSIM_RCS_REVOLUTE : GSIM_RCS_PRISMATIC;
    result.min = joint.min;
    result.max = joint.max;
    result.max_speed = joint.max_speed;
    result.max_acceleration = joint.max_acceleration;
    result.max_deceleration = joint.deceleration();
    result.max_jerk = joint.max_jerk;
    result.max_speed_step = joint.max_speed_step;
    result.step = joint.step;
    return result;
}

void set_dh_row(gsim_rcs_joint& joint, std::size_t row, const kinematics::DhLink& link) {
    joint.row = static_cast<std::int32_t>(row);
    joint.dh_theta_rad = link.theta_rad;
    joint.dh_d_mm = link.d_mm;
    joint.dh_a_mm = link.a_mm;
    joint.dh_alpha_rad = link.alpha_rad;
}

std::int32_t to_rcs(kinematics::InverseKind kind) {
    switch (kind) {
        case kinematics::InverseKind::gantry: return GSIM_RCS_GANTRY;
        case kinematics::InverseKind::numeric: return GSIM_RCS_NUMERIC;
        case kinematics::InverseKind::none: break;
    }
    return GSIM_RCS_NO_INVERSE;
}

rrs::JointKind kind(const gsim_rcs_joint& joint) {
    return joint.kind == GSIM_RCS_REVOLUTE ? rrs::JointKind::revolute : rrs::JointKind::prismatic;
}

/// Returns the joints in the order of their rows; nullopt if the rows are not numbered from 0 up.
std::optional<std::vector<int>> joints_by_row(const gsim_rcs_machine& machine) {
    std::vector<int> joints(static_cast<std::size_t>(machine.joint_count), -1);
    for (int i = 0; i < machine.joint_count; ++i) {
        const std::int32_t row = machine.joints[i].row;
        if (row < 0 || row >= machine.joint_count || joints[static_cast<std::size_t>(row)] >= 0) return {};
        joints[static_cast<std::size_t>(row)] = i;
    }
    return joints;
}

kinematics::Link link(const gsim_rcs_machine& machine, int index) {
    const gsim_rcs_joint& joint = machine.joints[index];
    return kinematics::make_link(index, {.kind = kind(joint),
                                         .theta_rad = joint.dh_theta_rad,
                                         .d_mm = joint.dh_d_mm,
                                         .a_mm = joint.dh_a_mm,
                                         .alpha_rad = joint.dh_alpha_rad});
}

Result<Kinematics> read_kinematics(const gsim_rcs_machine& machine) {
    const auto joints = joints_by_row(machine);
    if (!joints) return Unexpected("The rows of the joints must be numbered from 0 up.");
    kinematics::Branch branch{.base = rrs::from_rcs(machine.base), .end = rrs::from_rcs(machine.tool)};
    branch.links.reserve(joints->size());
    for (const int joint : *joints) branch.links.push_back(link(machine, joint));
    std::vector<kinematics::JointRange> ranges;
    ranges.reserve(joints->size());
    for (int i = 0; i < machine.joint_count; ++i)
        ranges.push_back({.min = machine.joints[i].min, .max = machine.joints[i].max});
    kinematics::Chain chain(std::move(branch));
    if (machine.has_inverse == GSIM_RCS_GANTRY)
        return kinematics::GantryKinematics::make(std::move(chain), std::move(ranges));
    if (machine.has_inverse == GSIM_RCS_NUMERIC)
        return kinematics::NumericKinematics::make(std::move(chain), std::move(ranges));
    return std::make_shared<kinematics::ChainKinematics>(std::move(chain));
}

Result<rrs::ControllerRules> read_controller_rules(const gsim_rcs_machine& machine) {
    std::string toml = "[controller]\n";
    for (std::size_t i = 0; i < machine.parameter_count; ++i)
        toml += fmt::format("{} = {}\n", machine.parameters[i].key, machine.parameters[i].value);
    return machine::read_controller(toml, "controller parameters", rrs::ControllerRules{}.model);
}

}  // namespace

RcsMachine::RcsMachine(const motion::PlannerSetup& setup) {
    const kinematics::DhTable table = kinematics::dh_table(setup.kinematics->chain());
    machine_.joint_count = setup.joint_count();
    machine_.has_inverse = to_rcs(setup.kinematics->inverse_kind());
    for (std::size_t i = 0; i < setup.joints.size(); ++i) machine_.joints[i] = to_rcs(setup.joints[i]);
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        set_dh_row(machine_.joints[table.joints[row]], row, table.rows[row]);
    std::copy(setup.position_joints.begin(), setup.position_joints.end(), machine_.position_joints);
    machine_.queue_capacity = static_cast<std::int32_t>(setup.queue_capacity);
    machine_.base = rrs::to_rcs(table.base);
    machine_.tool = rrs::to_rcs(table.tool);
    machine_.max_feed_mm_s = setup.path.max_feed_mm_s;
    machine_.max_rapid_mm_s = setup.path.max_rapid_mm_s;
    machine_.max_acceleration_mm_s2 = setup.path.max_acceleration_mm_s2;
    machine_.arc_tolerance_mm = setup.arc_tolerance_mm;
    add_parameters(setup.controller);
}

void RcsMachine::add_parameters(const rrs::ControllerRules& rules) {
    constexpr std::string_view kBetween = " = ";
    base::TomlWriter toml;
    machine::print_controller_keys(toml, rules, rrs::ControllerRules{});
    std::istringstream lines(toml.release());
    for (std::string line; std::getline(lines, line);) {
        const std::size_t split = line.find(kBetween);
        if (split == std::string::npos) continue;
        texts_.push_back({line.substr(0, split), line.substr(split + kBetween.size())});
    }
    for (const Text& text : texts_) parameters_.push_back({text.key.c_str(), text.value.c_str()});
    machine_.parameters = parameters_.data();
    machine_.parameter_count = parameters_.size();
}

Result<motion::PlannerSetup> setup_from_rcs_machine(const gsim_rcs_machine& machine) {
    if (machine.joint_count < 1 || machine.joint_count > rrs::kMaxJoints)
        return Unexpected(fmt::format("There are {} joints; a planner accepts 1 to {}.", machine.joint_count,
                                      rrs::kMaxJoints));
    motion::PlannerSetup setup;
    for (int i = 0; i < machine.joint_count; ++i) {
        const gsim_rcs_joint& joint = machine.joints[i];
        setup.joints.push_back({.kind = kind(joint),
                                .min = joint.min,
                                .max = joint.max,
                                .max_speed = joint.max_speed,
                                .max_acceleration = joint.max_acceleration,
                                .max_jerk = joint.max_jerk,
                                .max_speed_step = joint.max_speed_step,
                                .step = joint.step,
                                .max_deceleration = joint.max_deceleration});
    }
    std::copy_n(machine.position_joints, 3, setup.position_joints.begin());
    setup.path = {.max_feed_mm_s = machine.max_feed_mm_s,
                  .max_rapid_mm_s = machine.max_rapid_mm_s,
                  .max_acceleration_mm_s2 = machine.max_acceleration_mm_s2};
    setup.arc_tolerance_mm = machine.arc_tolerance_mm;
    setup.queue_capacity = static_cast<std::size_t>(std::max(0, machine.queue_capacity));
    auto rules = read_controller_rules(machine);
    if (!rules) return tl::unexpected(std::move(rules.error()));
    setup.controller = *std::move(rules);
    auto kinematics = read_kinematics(machine);
    if (!kinematics) return tl::unexpected(std::move(kinematics.error()));
    setup.kinematics = *std::move(kinematics);
    if (auto setup_error = setup.validate()) return tl::unexpected(*std::move(setup_error));
    return setup;
}

}  // namespace gsim::rcs
