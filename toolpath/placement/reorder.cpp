#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "toolpath/model/states.h"
#include "toolpath/placement/changes.h"

namespace gsim::path {

namespace {

using OrderError = tl::unexpected<TargetError>;

/// Returns the first point of a path, also of sub-paths that it begins with; null if it begins with no point.
const Point* first_point(const Program& program, std::size_t path) {
    const std::vector<Target>& targets = program.paths[path].targets;
    if (targets.empty()) return nullptr;
    if (const auto* sub_path_call = std::get_if<SubPath>(&targets.front()))
        return first_point(program, sub_path_call->path);
    return std::get_if<Point>(&targets.front());
}

/// Returns true if a path itself sets the feed of its first cut.
bool has_explicit_feed(const Program& program, std::size_t path, bool& known) {
    for (const Target& target : program.paths[path].targets) {
        if (const auto* sub_path_call = std::get_if<SubPath>(&target)) {
            if (!has_explicit_feed(program, sub_path_call->path, known)) return false;
        } else if (const auto* point = std::get_if<Point>(&target)) {
            known = known || point->feed_mm_min.has_value();
            const bool cuts = point->motion == MotionType::linear || point->motion == MotionType::circular;
            if (cuts && !known && !point->duration_s) return false;
        }
        if (known) return true;
    }
    return true;
}

/// Returns true if the action has no lasting effect, or one that States compares.
bool is_non_modal(const std::string& action) {
    constexpr std::array<std::string_view, 8> kWords{
        "stop", "optional_stop", "message ", "print ", "debug ", "log ", "rest", "exact_stop_once"};
    constexpr std::array<std::string_view, 8> kComparedActions{
        "waterjet_", "abrasive_", "spindle_", "speed ", "flood_on", "mist_on", "coolant_", "tool_change"};
    const auto matches_name = [&](std::string_view word) {
        return action == word || (word.ends_with(' ') && action.starts_with(word));
    };
    const auto has_prefix = [&](std::string_view word) { return action.starts_with(word); };
    return std::any_of(kWords.begin(), kWords.end(), matches_name) ||
           std::any_of(kComparedActions.begin(), kComparedActions.end(), has_prefix);
}

/// Returns the effect of a target that outlasts the path, and is not compared.
std::optional<Error> find_modal_error(const Target& target) {
    for (const std::string& action : target_actions(target)) {
        if (!is_non_modal(action))
            return fmt::format("'{}' may remain active, so that the order matters", action);
    }
    const auto* point = std::get_if<Point>(&target);
    if (point == nullptr) return std::nullopt;
    if (point->acceleration_mm_s2) return "an acceleration remains active, so that the order matters";
    if (point->feed_deg_min) return "a feed of rotary axes remains active, so that the order matters";
    return std::nullopt;
}

std::optional<TargetError> find_modal_action(const Program& program) {
    for (std::size_t path = 0; path < program.paths.size(); ++path) {
        for (std::size_t i = 0; i < program.paths[path].targets.size(); ++i) {
            if (auto error = find_modal_error(program.paths[path].targets[i]))
                return TargetError{{path, i}, error->message};
        }
    }
    return std::nullopt;
}

/// Returns true if an orientation sets the value of each rotary axis.
bool sets_all_rotary_axes(const std::optional<Orientation>& orientation, const MachineSpace& space) {
    if (space.rotary_count() == 0) return true;
    if (!orientation) return false;
    const auto* rotary = std::get_if<RotaryAxes>(&*orientation);
    for (std::size_t i = 0; rotary != nullptr && i < space.rotary_count(); ++i) {
        if (!rotary->contains(space.rotary_axis(i).letter)) return false;
    }
    return true;
}

/// Returns true if the same is running: a device that was never turned on is off.
bool is_equivalent(const Inherited<std::string>& one, const Inherited<std::string>& other) {
    const auto is_off = [](const Inherited<std::string>& each) {
        return !each.differs() && (!each.value() || each.value()->ends_with("_off"));
    };
    return one == other || (is_off(one) && is_off(other));
}

bool is_equivalent(const ActiveModes& one, const ActiveModes& other) {
    const bool spindle = is_equivalent(one.spindle, other.spindle);
    const bool spindle_unchanged = spindle && is_equivalent(one.spindle, Inherited<std::string>());
    return spindle && (spindle_unchanged || one.speed == other.speed) &&
           is_equivalent(one.flood, other.flood) && is_equivalent(one.mist, other.mist);
}

/// Compares what a sub-path inherits, except tool position and feed.
bool starts_equivalent(const State& one, const State& other) {
    return one.process_on == other.process_on && one.abrasive_on == other.abrasive_on &&
           is_equivalent(one.active_modes, other.active_modes) && one.frame == other.frame &&
           one.tool == other.tool && one.work_offset == other.work_offset &&
           one.at_machine_point == other.at_machine_point;
}

/// Returns why a target of the root cannot be at another position.
std::optional<Error> find_reorder_error(const Program& program, const Target& target,
                                        const MachineSpace& space) {
    const auto* sub_path_call = std::get_if<SubPath>(&target);
    if (sub_path_call == nullptr) return "only sub-paths can be reordered";
    const std::string& name = program.paths[sub_path_call->path].name;
    const Point* first = first_point(program, sub_path_call->path);
    if (first == nullptr || first->motion == MotionType::circular || first->motion == MotionType::none)
        return fmt::format("the sub-path '{}' must begin with a straight motion or a rapid", name);
    if (!sets_all_rotary_axes(first->orientation, space))
        return fmt::format("the first point of the sub-path '{}' needs an orientation with all rotary axes",
                           name);
    bool known = false;
    if (!has_explicit_feed(program, sub_path_call->path, known))
        return fmt::format("the sub-path '{}' needs a separate feed before it cuts", name);
    return std::nullopt;
}

}  // namespace

tl::expected<void, TargetError> reorder(Program& program, std::span<const std::size_t> order,
                                        const MachineSpace& space) {
    const std::vector<Target> targets = program.paths[program.root].targets;
    const auto make_error = [&](std::optional<std::size_t> target, std::string reason) {
        return OrderError(TargetError{{program.root, target}, std::move(reason)});
    };
    std::vector<std::size_t> all(targets.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (!std::is_permutation(order.begin(), order.end(), all.begin(), all.end()))
        return make_error(std::nullopt,
                          fmt::format("the order must contain each of 0 to {} once", targets.size() - 1));
    for (const std::size_t i : all) {
        if (auto error = find_reorder_error(program, targets[i], space)) return make_error(i, error->message);
    }
    if (auto error = find_modal_action(program)) return OrderError(*std::move(error));
    const States before(program);
    Program changed = program;
    for (std::size_t i = 0; i < order.size(); ++i) changed.paths[program.root].targets[i] = targets[order[i]];
    const States states_after(changed);
    for (const std::size_t i : all) {
        const std::size_t path = std::get<SubPath>(targets[i]).path;
        if (!starts_equivalent(before.entry(path), states_after.entry(path)))
            return make_error(i, fmt::format("the sub-path '{}' would begin with a different active state",
                                             program.paths[path].name));
    }
    program = std::move(changed);
    return {};
}

}  // namespace gsim::path
