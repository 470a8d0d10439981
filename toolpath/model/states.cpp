#include "toolpath/model/states.h"

#include <algorithm>

namespace gsim::path {

namespace {

template <typename T>
void set(Inherited<T>& target, const std::optional<T>& value) {
    if (value) target = Inherited<T>(*value);
}

bool turns_tool(const MachinePoint& point) {
    return std::any_of(point.axes.begin(), point.axes.end(),
                       [](const auto& each) { return each.first < 'X' || each.first > 'Z'; });
}

}  // namespace

void State::merge(const State& other) {
    position_mm.merge(other.position_mm);
    orientation.merge(other.orientation);
    feed_mm_min.merge(other.feed_mm_min);
    feed_deg_min.merge(other.feed_deg_min);
    feed_mm_rev.merge(other.feed_mm_rev);
    work_offset.merge(other.work_offset);
    frame.merge(other.frame);
    tool.merge(other.tool);
    process_on.merge(other.process_on);
    abrasive_on.merge(other.abrasive_on);
    at_machine_point.merge(other.at_machine_point);
    active_modes.merge(other.active_modes);
}

void State::pass(const Point& point) {
    position_mm = Inherited<Vector>(point.position_mm);
    set(orientation, point.orientation);
    set(feed_mm_min, point.feed_mm_min);
    if (point.feed_mm_min) feed_mm_rev = Inherited<double>(point.feed_mm_rev.value_or(0));
    set(feed_deg_min, point.feed_deg_min);
    if (!point.work_offset.empty()) work_offset = Inherited<std::string>(point.work_offset);
    at_machine_point = Inherited<bool>(false);
    apply_actions(point.actions);
}

// Makes the tool's position in the work unknown, and its tilt too if rotary axes have turned.
void State::pass(const MachinePoint& point) {
    position_mm = Inherited<Vector>::unknown();
    if (turns_tool(point)) orientation = Inherited<Orientation>::unknown();
    at_machine_point = Inherited<bool>(true);
    apply_actions(point.actions);
}

void State::apply_actions(const std::vector<std::string>& actions) {
    for (const std::string& action : actions) {
        if (action == "waterjet_on") process_on = Inherited<bool>(true);
        if (action == "waterjet_off") process_on = Inherited<bool>(false);
        if (action == "abrasive_on") abrasive_on = Inherited<bool>(true);
        if (action == "abrasive_off") abrasive_on = Inherited<bool>(false);
        active_modes.pass(action);
    }
}

States::States(const Program& program)
    : program_(program),
      entries_(program.paths.size()),
      frames_(program.paths.size()),
      changes_(program.paths.size()) {
    std::vector<bool> seen(program.paths.size(), false);
    visit(program.root, seen);
    std::reverse(order_.begin(), order_.end());
    State start;
    start.process_on = Inherited<bool>(false);
    start.abrasive_on = Inherited<bool>(false);
    start.at_machine_point = Inherited<bool>(false);
    start.frame = Inherited<std::string>(program.paths[program.root].frame.name);
    frames_[program.root] = {program.paths[program.root].frame.name};
    entries_[program.root] = start;
    for (const std::size_t path : order_) {
        State state = *entries_[path];
        for (const Target& target : program.paths[path].targets) {
            const auto* sub_path = std::get_if<SubPath>(&target);
            set_up(state, path, target);
            if (sub_path != nullptr) enter(*sub_path, path, state);
            pass(state, target);
            if (sub_path != nullptr && sub_path->repeats > 1) enter(*sub_path, path, state);
        }
    }
}

void States::visit(std::size_t path, std::vector<bool>& seen) {
    seen[path] = true;
    // Visits targets from the last to the first, so that the reversed order lists paths by first use.
    const std::vector<Target>& targets = program_.paths[path].targets;
    for (auto target = targets.rbegin(); target != targets.rend(); ++target) {
        const auto* sub_path = std::get_if<SubPath>(&*target);
        if (sub_path != nullptr && !seen[sub_path->path]) visit(sub_path->path, seen);
    }
    for (const Target& target : targets) {
        set_up(changes_[path], path, target);
        pass(changes_[path], target);
    }
    order_.push_back(path);
}

void States::enter(const SubPath& sub_path_call, std::size_t user, State state) {
    const std::size_t path = sub_path_call.path;
    const std::string& frame = sub_path_frame(program_, sub_path_call).name;
    if (!frame.empty()) state.frame = Inherited<std::string>(frame);
    if (frame.empty()) {
        frames_[path].insert(frames_[user].begin(), frames_[user].end());
    } else {
        frames_[path].insert(frame);
    }
    if (entries_[path]) {
        entries_[path]->merge(state);
    } else {
        entries_[path] = state;
    }
}

void States::set_up(State& state, std::size_t path, const Target& target) const {
    const auto* sub_path = std::get_if<SubPath>(&target);
    set(state.tool, program_.paths[path].tool);
    if (sub_path != nullptr) set(state.tool, program_.paths[sub_path->path].tool);
}

void States::pass(State& state, const Target& target) const {
    if (const auto* point = std::get_if<Point>(&target)) return state.pass(*point);
    if (const auto* point = std::get_if<MachinePoint>(&target)) return state.pass(*point);
    const State& change = changes_[std::get<SubPath>(target).path];
    state.position_mm.set(change.position_mm);
    state.orientation.set(change.orientation);
    state.feed_mm_min.set(change.feed_mm_min);
    state.feed_deg_min.set(change.feed_deg_min);
    state.feed_mm_rev.set(change.feed_mm_rev);
    state.work_offset.set(change.work_offset);
    state.tool.set(change.tool);
    state.process_on.set(change.process_on);
    state.abrasive_on.set(change.abrasive_on);
    state.at_machine_point.set(change.at_machine_point);
    state.active_modes.set(change.active_modes);
}

}  // namespace gsim::path
