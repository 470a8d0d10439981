#include "toolpath/rotary/rotary_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "toolpath/rotary/rotary_candidates.h"
#include "toolpath/rotary/rotary_search.h"

namespace gsim::path {

namespace {

// Cost of a turn on the spot beyond its angle: little with the jet off, more than any turn while cutting.
constexpr double kIdleStopCost_deg = 1;
constexpr double kCuttingStopCost_deg = 1e7;
constexpr int kMaxUnwoundRepeats =
    1000;  // repeats that are separate calls, because the axes unwind in between

class Planner {
  public:
    Planner(const Program& program, const MachineSpace& space, const States& states,
            const RotaryOptions& options)
        : program_(program),
          space_(space),
          states_(states),
          options_(options),
          jet_(has_jet(program)),
          turns_(program.paths.size(), RotarySchedule(space.rotary_count())),
          entries_(program.paths.size()) {}

    tl::expected<std::vector<RotarySchedule>, TargetError> run() {
        const std::vector<std::size_t>& order = states_.topological_order();
        for (auto path = order.rbegin(); path != order.rend(); ++path) {
            if (auto error = plan(*path)) return tl::unexpected(*error);
        }
        return std::move(turns_);
    }

  private:
    using OptionalError = std::optional<TargetError>;

    OptionalError plan(std::size_t path) {
        RotarySearch search(space_.rotary_count());
        State state = states_.entry(path);
        const std::vector<Target>& targets = program_.paths[path].targets;
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const auto* sub_path = std::get_if<SubPath>(&targets[i]);
            const auto* machine_point = std::get_if<MachinePoint>(&targets[i]);
            auto error = sub_path != nullptr ? enter(search, state, *sub_path, {path, i})
                         : machine_point != nullptr
                             ? go_to(search, state, *machine_point, {path, i})
                             : go_to(search, state, std::get<Point>(targets[i]), {path, i});
            if (error) return error;
            states_.pass(state, targets[i]);
        }
        turns_[path] = search.result();
        turns_[path].between = std::exchange(repeat_unwindings_, {});
        entries_[path] = path_entry(path);
        return std::nullopt;
    }

    // Returns nullopt for a path that leaves the axes as they are.
    std::optional<AxisValues> path_entry(std::size_t path) const {
        const std::vector<Target>& targets = program_.paths[path].targets;
        const std::size_t first = turns_[path].unknown;
        if (first == targets.size()) return std::nullopt;
        const auto* sub_path = std::get_if<SubPath>(&targets[first]);
        return sub_path != nullptr ? entries_[sub_path->path] : turns_[path].at(first);
    }

    bool cuts(const Point& point, const State& before) const {
        return is_cutting(point, before, jet_) && !options_.is_literal;
    }
    // Returns true if a sub-path begins with a motion at which the tool cuts.
    bool begins_cutting(const SubPath& sub_path_call, const State& before) const {
        const Target& first = program_.paths[sub_path_call.path].targets.front();
        if (const auto* inner = std::get_if<SubPath>(&first)) return begins_cutting(*inner, before);
        const auto* point = std::get_if<Point>(&first);
        return point != nullptr && cuts(*point, before);
    }
    AxisValues path_exit(std::size_t path) const {
        return turns_[path].at(program_.paths[path].targets.size() - 1);
    }

    OptionalError enter(RotarySearch& search, State& state, const SubPath& sub_path, const TargetId& id) {
        const bool cutting = begins_cutting(sub_path, state);
        const std::optional<AxisValues>& entry = entries_[sub_path.path];
        if (!entry) return keep_position(search, state, id);
        const AxisValues exit = path_exit(sub_path.path);
        if (auto error = advance(search, state, cutting, {*entry}, id)) return error;
        if (sub_path.repeats > 1) {
            if (auto error = check_repeats(state, sub_path, id)) return error;
        }
        std::vector<AxisValues> exit_state{exit};
        add_full_turns(space_, exit, exit, exit_state);
        search.leave(std::move(exit_state));
        return std::nullopt;
    }

    // Checks that the axes also return to the start of the sub-path by the short turn, if it starts while the
    // tool cuts.
    OptionalError check_repeats(const State& before, const SubPath& sub_path, const TargetId& id) {
        const AxisValues& entry = *entries_[sub_path.path];
        const AxisValues exit = path_exit(sub_path.path);
        State next_state = before;
        states_.pass(next_state, Target(sub_path));
        const bool is_shortest_turn =
            turn_between(exit, entry) <= min_turn_between(exit, entry) + kTurnTolerance_deg;
        if (is_shortest_turn || !begins_cutting(sub_path, next_state)) return std::nullopt;
        AxisValues unwound_position = entry;
        for (Eigen::Index i = 0; i < unwound_position.size(); ++i) {
            unwound_position[i] += std::remainder(exit[i] - entry[i], 360.0);
            const machine::Axis& axis = space_.rotary_axis(static_cast<std::size_t>(i));
            if (unwound_position[i] < axis.min || unwound_position[i] > axis.max ||
                sub_path.repeats > kMaxUnwoundRepeats) {
                return TargetError{id,
                                   "the sub-path cannot be repeated: the rotary axes would have to unwind "
                                   "each time before its first point, but their ranges are too small"};
            }
        }
        repeat_unwindings_.push_back({*id.target, unwound_position});
        return std::nullopt;
    }

    // Keeps the axes as they are, whatever their values.
    OptionalError keep_position(RotarySearch& search, const State& state, const TargetId& id) {
        if (!search.now().empty()) return advance(search, state, false, search.now(), id);
        search.pass();
        return std::nullopt;
    }

    // Turns the axes that the point names.
    OptionalError go_to(RotarySearch& search, const State& state, const MachinePoint& point,
                        const TargetId& id) {
        std::size_t named = 0;
        for (std::size_t i = 0; i < space_.rotary_count(); ++i)
            named += point.axes.contains(space_.rotary_axis(i).letter) ? 1 : 0;
        if (named == 0 && space_.rotary_count() > 0) return keep_position(search, state, id);
        std::vector<AxisValues> from = search.now();
        if (from.empty() && named < space_.rotary_count()) {
            return TargetError{id,
                               fmt::format("{} defines the positions of only some rotary axes, and the "
                                           "others are undefined; begin with a point that has an orientation",
                                           point_title(point))};
        }
        if (from.empty()) from.push_back(space_.home_rotary());
        std::vector<AxisValues> next;
        for (AxisValues& each : from) {
            for (std::size_t i = 0; i < space_.rotary_count(); ++i) {
                const auto value = point.axes.find(space_.rotary_axis(i).letter);
                if (value != point.axes.end()) each[static_cast<Eigen::Index>(i)] = value->second;
            }
            if (std::find(next.begin(), next.end(), each) == next.end()) next.push_back(each);
        }
        return advance(search, state, false, std::move(next), id);
    }

    OptionalError go_to(RotarySearch& search, const State& state, const Point& point, const TargetId& id) {
        const bool cutting = cuts(point, state);
        if (space_.rotary_count() == 0) {
            if (point.orientation && !std::holds_alternative<ToolAxis>(*point.orientation)) {
                auto none = candidates(search, point, *point.orientation);
                if (!none) return TargetError{id, none.error().message};
            }
            return advance(search, state, cutting, {AxisValues(0)}, id);
        }
        const bool is_unchanged = !point.orientation && !search.now().empty() && !state.orientation.differs();
        if (is_unchanged) return advance(search, state, cutting, search.now(), id);
        const std::optional<Orientation> orientation =
            point.orientation ? point.orientation : state.orientation.value();
        if (!orientation) return TargetError{id, missing_orientation_message(state)};
        auto found = candidates(search, point, *orientation);
        if (!found) return TargetError{id, found.error().message};
        return advance(search, state, cutting, std::move(*found), id);
    }

    static std::string missing_orientation_message(const State& state) {
        if (state.orientation.differs() && state.at_machine_point.value() == true) {
            return "the point needs an orientation: the fixed or reference point before it has turned the "
                   "rotary axes";
        }
        if (state.orientation.differs()) {
            return "the first point of this sub-path needs an orientation: the uses of the sub-path have "
                   "different ones";
        }
        return "the point needs an orientation: the machine has rotary axes, and no previous point defines "
               "their positions";
    }

    Result<std::vector<AxisValues>> candidates(const RotarySearch& search, const Point& point,
                                               const Orientation& orientation) const {
        const std::vector<AxisValues> home{space_.home_rotary()};
        return rotary_candidates(space_, point.position_mm, orientation,
                                 search.now().empty() ? home : search.now(), options_.is_literal);
    }

    OptionalError advance(RotarySearch& search, const State& state, bool cutting,
                          std::vector<AxisValues> next, const TargetId& id) const {
        if (search.now().empty()) {
            search.begin(std::move(next), space_.home_rotary(), id.path != program_.root);
            return std::nullopt;
        }
        const bool jet_off = jet_ && state.process_on.value() == false;
        if (search.step(std::move(next), cutting, jet_off ? kIdleStopCost_deg : kCuttingStopCost_deg)) {
            return std::nullopt;
        }
        return TargetError{id,
                           "out of reach: while the tool cuts, the rotary axes cannot move in the shorter "
                           "direction from the previous point within their ranges"};
    }

    const Program& program_;
    const MachineSpace& space_;
    const States& states_;
    const RotaryOptions& options_;
    bool jet_;
    std::vector<RotarySchedule> turns_;
    std::vector<std::optional<AxisValues>> entries_;            // at the start of each path
    std::vector<RotarySchedule::Unwinding> repeat_unwindings_;  // of the path being planned
};

}  // namespace

bool has_jet(const Program& program) {
    for (const Path& path : program.paths) {
        for (const Target& target : path.targets) {
            const std::vector<std::string>& actions = target_actions(target);
            if (std::find(actions.begin(), actions.end(), "waterjet_on") != actions.end()) return true;
        }
    }
    return false;
}

bool is_cutting(const Point& point, const State& before, bool program_has_jet) {
    if (point.motion == MotionType::rapid) return false;
    return !program_has_jet || before.process_on.value() != false;
}

tl::expected<std::vector<RotarySchedule>, TargetError> plan_rotary(const Program& program,
                                                                   const MachineSpace& space,
                                                                   const States& states,
                                                                   const RotaryOptions& options) {
    return Planner(program, space, states, options).run();
}

}  // namespace gsim::path
