#include "runtime/simulation/limit_name.h"

#include <string_view>

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

using motion::LimitKind;

std::string of_joint(int joint, const machine::Machine& machine, std::string_view what) {
    const auto index = static_cast<std::size_t>(joint);
    if (joint < 0 || index >= machine.axes.size()) return fmt::format("joint {}", what);
    const machine::Axis& axis = machine.axes[index];
    const bool rotary = axis.kind == machine::AxisKind::rotary;
    return fmt::format("{} {} {}", rotary ? "rotary" : "joint", axis.letter, what);
}

}  // namespace

std::string describe(motion::LimitedBy limited_by, const machine::Machine& machine) {
    switch (limited_by.kind) {
        case LimitKind::feed: return "feed";
        case LimitKind::path_speed: return "contour speed";
        case LimitKind::joint_speed: return of_joint(limited_by.joint, machine, "speed");
        case LimitKind::acceleration: return of_joint(limited_by.joint, machine, "acceleration");
        case LimitKind::path_acceleration: return "path acceleration";
        case LimitKind::centripetal: return "centripetal";
        case LimitKind::corner: return "corner";
        case LimitKind::stop: return "stop";
        case LimitKind::jerk: return "jerk";
        case LimitKind::look_ahead: return "look-ahead";
        case LimitKind::block_time: return "block time";
        case LimitKind::time: return "time";
        case LimitKind::rapid_override: return "rapid override";
        case LimitKind::short_brakes: return "braked short";
        case LimitKind::unknown: break;
    }
    return "unknown";
}

}  // namespace gsim::simulation
