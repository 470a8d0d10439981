#include "toolpath/placement/set_up.h"

#include <fmt/format.h>

#include "toolpath/rotary/axis_moves.h"

namespace gsim::path {

namespace {

// Returns true if the machine has moved.
bool is_under_way(const State& at) {
    return at.position_mm.value().has_value() || at.position_mm.differs();
}

}  // namespace

std::set<std::string> SetUp::frames() const {
    return in_force_ ? std::set{*in_force_} : states_.frames(path_);
}

std::optional<Fault> SetUp::before(std::size_t target, const State& at) {
    target_ = target;
    const Path& path = program_.paths[path_];
    const auto* use = std::get_if<SubPath>(&path.targets[target]);
    Inherited<std::string> frame = states_.entry(path_).frame;
    std::optional<Tool> tool = path.tool;
    if (use != nullptr) {
        const WorkFrame& named = frame_of(program_, *use);
        if (!named.name.empty()) frame = Inherited<std::string>(named.name);
        if (program_.paths[use->path].tool) tool = program_.paths[use->path].tool;
    }
    if (auto failed = change(frame, tool, at)) return failed;
    const bool elsewhere = use != nullptr && ends_elsewhere(*use);
    const bool from_above = changed_ || (elsewhere && use->repeats > 1);
    changed_ = elsewhere;
    return from_above ? must_be_rapid({path_, target}) : std::nullopt;
}

// Returns true if a sub-path's last motion is in another frame than the sub-path.
bool SetUp::ends_elsewhere(const SubPath& use) const {
    const auto* last = &use;
    for (;;) {
        last = std::get_if<SubPath>(&program_.paths[last->path].targets.back());
        if (last == nullptr) return false;
        const std::string& name = frame_of(program_, *last).name;
        if (!name.empty() && name != in_force_) return true;
    }
}

std::optional<Fault> SetUp::finish(const State& at) {
    target_ = std::nullopt;
    return change(states_.entry(path_).frame, std::nullopt, at);
}

std::optional<Fault> SetUp::change(const Inherited<std::string>& frame, const std::optional<Tool>& tool,
                                   const State& at) {
    if (frame.differs() && in_force_)
        return fault(
            "the path needs its own 'work_offset': it goes back to it behind a sub-path in another one, "
            "and the places that use it hand over different ones");
    const std::string name = frame.value().value_or("");
    const bool other_frame = !name.empty() && name != in_force_;
    const bool other_tool = tool && at.tool.value() != tool;
    if (!other_frame && !other_tool) return std::nullopt;
    if (jet_ && at.jet_on.value() != false)
        return fault("the jet may be on where the tool or the work offset changes; turn it off before");
    changed_ = changed_ || is_under_way(at);
    if (changed_ || other_tool) sink_.retract();
    if (other_tool) {
        if (auto failed = change_tool(*tool, at)) return failed;
    }
    if (other_frame) {
        sink_.work_offset(name);
        in_force_ = name;
    }
    return std::nullopt;
}

std::optional<Fault> SetUp::change_tool(const Tool& tool, const State& at) {
    const auto again = restored(at.running, stops_);
    if (!again) return fault(again.error());
    sink_.action(fmt::format("tool_select T{}", tool.number));
    sink_.action(fmt::format("tool_change T{}", tool.number));
    for (const std::string& each : *again) sink_.action(each);
    sink_.action(tool.length_offset == 0 ? "tool_length_off"
                                         : fmt::format("tool_length H{}", tool.length_offset));
    if (tool.diameter_offset) sink_.action(fmt::format("tool_diameter D{}", *tool.diameter_offset));
    return std::nullopt;
}

// Requires a rapid, because the motion from the retract height to the work is not part of the path.
std::optional<Fault> SetUp::must_be_rapid(const TargetId& id) const {
    const Target& target = program_.paths[id.path].targets[*id.target];
    if (const auto* use = std::get_if<SubPath>(&target)) return must_be_rapid({use->path, 0});
    const auto* point = std::get_if<Point>(&target);
    if (point == nullptr || point->motion == MotionType::rapid) return std::nullopt;
    return Fault{
        id,
        "the first motion in another work offset or with another tool must be a rapid: the tool comes "
        "to it from above"};
}

}  // namespace gsim::path
