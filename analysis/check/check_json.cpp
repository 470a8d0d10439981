#include <cmath>

#include "analysis/check/machine_check.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/units.h"
#include "machine/model/group_motion.h"

namespace gsim::check {

namespace {

using Json = nlohmann::ordered_json;
using cell::Verdict;

Json number(double value) {
    return std::isfinite(value) ? Json(text::rounded(value)) : Json(nullptr);
}

std::string letter(const machine::Machine& machine, int joint) {
    return {machine.axes[static_cast<std::size_t>(joint)].letter};
}

Json values(const machine::Machine& machine, const rrs::JointPos& joints) {
    Json list = Json::object();
    for (int joint = 0; joint < joints.size(); ++joint) {
        const machine::Axis& axis = machine.axes[static_cast<std::size_t>(joint)];
        list[letter(machine, joint)] = number(machine::axis_value(axis, joints[joint]));
    }
    return list;
}

Json axes(const machine::Machine& machine) {
    Json list = Json::array();
    for (const machine::Axis& axis : machine.axes) {
        list.push_back({{"letter", std::string(1, axis.letter)},
                        {"kind", axis.kind == machine::AxisKind::linear ? "linear" : "rotary"},
                        {"carries", machine::name(axis.carries)},
                        {"min", number(axis.min)},
                        {"max", number(axis.max)},
                        {"home", number(axis.home)},
                        {"max_speed", number(axis.max_speed)},
                        {"max_acceleration", number(axis.max_acceleration)}});
    }
    return list;
}

Json motions(const MachineCheck& check) {
    Json list = Json::array();
    for (const AxisMotion& motion : check.motions) {
        const Eigen::Vector3d& d = motion.direction;
        list.push_back({{"axis", std::string(1, motion.letter)},
                        {"turns", motion.is_rotary},
                        {"carries", motion.carries_work ? "work" : "tool"},
                        {"direction", {number(d.x()), number(d.y()), number(d.z())}},
                        {"text", to_message(motion)}});
    }
    return list;
}

Json groups(const machine::Machine& machine) {
    Json list = Json::array();
    for (const machine::AxisGroup& group : machine.groups) {
        Json axes = Json::array();
        for (const std::size_t axis : group.axes) axes.push_back(letter(machine, static_cast<int>(axis)));
        const bool work = machine.axes[group.axes.front()].carries == machine::CarriedPart::work;
        list.push_back({{"name", group.name},
                        {"axes", std::move(axes)},
                        {"carries", work ? "work" : "tool"},
                        {"motion", machine::name(group.motion)}});
    }
    return list;
}

Json inverse(const MachineCheck& check) {
    const InverseCheck& of = check.inverse;
    if (of.poses == 0) return nullptr;
    return {{"poses", of.poses},
            {"unsolved", of.unsolved},
            {"out_of_range", of.out_of_range},
            {"off", of.inaccurate_count},
            {"worst_mm", number(of.worst_mm)},
            {"worst_deg", number(of.worst_rad * kDegPerRad)},
            {"first_bad", of.is_consistent() ? Json(nullptr) : values(check.machine, of.first_bad)}};
}

Json singular(const MachineCheck& check) {
    Json ranges = Json::array();
    for (const SingularRange& range : check.singular.ranges) {
        const machine::Axis& axis = check.machine.axes[static_cast<std::size_t>(range.joint)];
        Json aligned_joints = Json::array();
        for (const int joint : range.aligned_joints) aligned_joints.push_back(letter(check.machine, joint));
        ranges.push_back({{"axis", letter(check.machine, range.joint)},
                          {"min_deg", number(machine::axis_value(axis, range.low))},
                          {"max_deg", number(machine::axis_value(axis, range.high))},
                          {"lined_up", std::move(aligned_joints)}});
    }
    return {{"ranges", std::move(ranges)},
            {"near_share", number(check.singular.near_share)},
            {"at_home", check.singular.at_home}};
}

const char* verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::free: return "free";
        case Verdict::contact: return "touch";
        case Verdict::undecided: break;
    }
    return "undecided";
}

Json pairs(const MachineCheck& check) {
    Json list = Json::array();
    for (const cell::PairFinding& of : check.pair_findings) {
        list.push_back({{"pair", {check.bodies[of.items.first], check.bodies[of.items.second]}},
                        {"verdict", verdict_name(of.verdict)},
                        {"nearest_mm", number(of.nearest_mm)},
                        {"contact_share", number(of.contact_share)},
                        {"at", values(check.machine, of.joints)}});
    }
    return list;
}

}  // namespace

std::string to_json(const MachineCheck& check) {
    const Eigen::Vector3d tcp = check.home.translation();
    const Json json = {{"machine", check.machine.name},
                       {"controller", check.machine.controller.model},
                       {"clean", check.is_clean()},
                       {"axes", axes(check.machine)},
                       {"groups", groups(check.machine)},
                       {"home_mm", {number(tcp.x()), number(tcp.y()), number(tcp.z())}},
                       {"motions", motions(check)},
                       {"left_handed", check.left_handed},
                       {"inverse", inverse(check)},
                       {"singular", singular(check)},
                       {"bodies", check.bodies},
                       {"pairs", pairs(check)},
                       {"notes", check.notes}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace gsim::check
