#include "toolpath/placement/set_up.h"

#include <fmt/format.h>

#include "toolpath/rotary/axis_moves.h"

namespace gsim::path {

namespace {

// Returns true if the machine has moved.
bool is_position_set(const State& at) {
    return at.position_mm.value().has_value() || at.position_mm.differs();
}

}  // namespace

std::set<std::string> PathSetup::frames() const {
    return active_frame_ ? std::set{*active_frame_} : states_.frames(path_);
}

std::optional<TargetError> PathSetup::before(std::size_t target, const State& at) {
    target_ = target;
    const Path& path = program_.paths[path_];
    const auto* sub_path_call = std::get_if<SubPath>(&path.targets[target]);
    Inherited<std::string> frame = states_.entry(path_).frame;
    std::optional<Tool> tool = path.tool;
    if (sub_path_call != nullptr) {
        const WorkFrame& named = sub_path_frame(program_, *sub_path_call);
        if (!named.name.empty()) frame = Inherited<std::string>(named.name);
        if (program_.paths[sub_path_call->path].tool) tool = program_.paths[sub_path_call->path].tool;
    }
    if (auto failed = change(frame, tool, at)) return failed;
    const bool frame_changes = sub_path_call != nullptr && ends_in_other_frame(*sub_path_call);
    const bool retract_first = needs_rapid_ || (frame_changes && sub_path_call->repeats > 1);
    needs_rapid_ = frame_changes;
    return retract_first ? require_rapid({path_, target}) : std::nullopt;
}

// Returns true if a sub-path's last motion is in another frame than the sub-path.
bool PathSetup::ends_in_other_frame(const SubPath& sub_path_call) const {
    const auto* last = &sub_path_call;
    for (;;) {
        last = std::get_if<SubPath>(&program_.paths[last->path].targets.back());
        if (last == nullptr) return false;
        const std::string& name = sub_path_frame(program_, *last).name;
        if (!name.empty() && name != active_frame_) return true;
    }
}

std::optional<TargetError> PathSetup::finish(const State& at) {
    target_ = std::nullopt;
    return change(states_.entry(path_).frame, std::nullopt, at);
}

std::optional<TargetError> PathSetup::change(const Inherited<std::string>& frame,
                                             const std::optional<Tool>& tool, const State& at) {
    if (frame.differs() && active_frame_)
        return make_error(
            "the path needs a separate 'work_offset': it is restored after a sub-path in another one, and "
            "the uses of the path have different ones");
    const std::string name = frame.value().value_or("");
    const bool is_other_frame = !name.empty() && name != active_frame_;
    const bool is_other_tool = tool && at.tool.value() != tool;
    if (!is_other_frame && !is_other_tool) return std::nullopt;
    if (jet_ && at.process_on.value() != false)
        return make_error("the jet may be on at a change of the tool or the work offset; turn it off before");
    needs_rapid_ = needs_rapid_ || is_position_set(at);
    if (needs_rapid_ || is_other_tool) sink_.retract();
    if (is_other_tool) {
        if (auto failed = change_tool(*tool, at)) return failed;
    }
    if (is_other_frame) {
        sink_.work_offset(name);
        active_frame_ = name;
    }
    return std::nullopt;
}

std::optional<TargetError> PathSetup::change_tool(const Tool& tool, const State& at) {
    const auto restored = restore_actions(at.active_modes, stops_);
    if (!restored) return make_error(restored.error().message);
    sink_.action(fmt::format("tool_select T{}", tool.number));
    sink_.action(fmt::format("tool_change T{}", tool.number));
    for (const std::string& each : *restored) sink_.action(each);
    sink_.action(tool.length_offset == 0 ? "tool_length_off"
                                         : fmt::format("tool_length H{}", tool.length_offset));
    if (tool.diameter_offset) sink_.action(fmt::format("tool_diameter D{}", *tool.diameter_offset));
    return std::nullopt;
}

// Requires a rapid, because the motion from the retract height to the work is not part of the path.
std::optional<TargetError> PathSetup::require_rapid(const TargetId& id) const {
    const Target& target = program_.paths[id.path].targets[*id.target];
    if (const auto* sub_path_call = std::get_if<SubPath>(&target))
        return require_rapid({sub_path_call->path, 0});
    const auto* point = std::get_if<Point>(&target);
    if (point == nullptr || point->motion == MotionType::rapid) return std::nullopt;
    return TargetError{id,
                       "the first motion in another work offset or with another tool must be a rapid: the "
                       "tool approaches from above"};
}

}  // namespace gsim::path
