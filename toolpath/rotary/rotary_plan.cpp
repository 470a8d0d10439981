#include "toolpath/rotary/rotary_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "toolpath/rotary/rotary_candidates.h"

namespace gsim::path {

namespace {

constexpr double kUnreachable = std::numeric_limits<double>::infinity();
constexpr double kTurnTolerance_deg = 1e-6;
// Cost of a turn on the spot beyond its angle: little with the jet off, more than any turn while cutting.
constexpr double kIdleStopCost_deg = 1;
constexpr double kCuttingStopCost_deg = 1e7;
// Weight of the first point of a path, which has no predecessor; axes near home can turn in both directions.
constexpr double kHomeWeight = 1e-3;
// Cost that keeps the start of a sub-path within half a turn of home, so that the axes can reach it by the
// short turn from anywhere.
constexpr double kFarEntryWeight = 1e9;
constexpr int kMaxUnwoundRepeats =
    1000;  // repeats that are separate calls, because the axes unwind in between

// Search through one path: the candidates of each target, and the predecessor of each.
class Search {
  public:
    explicit Search(std::size_t rotary_count) : rotary_count_(rotary_count) {}

    /// Returns the possible axis values; empty before the first target that sets them.
    const std::vector<AxisValues>& now() const { return joint_values_; }
    /// Counts a target at the beginning that leaves the axes as they are.
    void pass() { ++unknown_; }

    void begin(std::vector<AxisValues> candidates, const AxisValues& home, bool must_be_near_home) {
        costs_.clear();
        costs_.reserve(candidates.size());
        for (const AxisValues& each : candidates) {
            const double share = must_be_near_home && is_far(home, each) ? kFarEntryWeight : kHomeWeight;
            costs_.push_back(share * turn_between(home, each));
        }
        const std::vector<std::uint8_t> from(candidates.size(), 0);
        add_layer(std::move(candidates), from);
    }

    /// Advances to the candidates of the next target; before, the axes may turn on the spot. Returns false if
    /// no candidate can be reached by the short turn that cutting demands.
    bool step(std::vector<AxisValues> candidates, bool cutting, double stop_cost) {
        relax_turns_in_place(stop_cost);
        std::vector<double> next(candidates.size(), kUnreachable);
        std::vector<std::uint8_t> from(candidates.size(), 0);
        for (std::size_t k = 0; k < joint_values_.size(); ++k) {
            const double max =
                cutting ? min_rotation(joint_values_[k], candidates) + kTurnTolerance_deg : kUnreachable;
            for (std::size_t m = 0; m < candidates.size(); ++m) {
                const double turn = turn_between(joint_values_[k], candidates[m]);
                if (turn > max || costs_[k] + turn >= next[m]) continue;
                next[m] = costs_[k] + turn;
                from[m] = static_cast<std::uint8_t>(k);
            }
        }
        costs_ = std::move(next);
        add_layer(std::move(candidates), from);
        return *std::min_element(costs_.begin(), costs_.end()) < kUnreachable;
    }

    /// Ends a sub-path with one candidate, which leaves the axes at the first of these values; to the others
    /// they may turn on the spot.
    void leave(std::vector<AxisValues> values) {
        values_.resize(values_.size() - rotary_count_);
        for (const AxisValues& each : values) values_.insert(values_.end(), each.begin(), each.end());
        from_.resize(from_.size() + values.size() - 1, 0);
        costs_.resize(values.size(), kUnreachable);
        joint_values_ = std::move(values);
    }

    RotarySchedule result() const;

  private:
    static bool is_far(const AxisValues& home, const AxisValues& values) {
        return home.size() > 0 && (values - home).cwiseAbs().maxCoeff() > 180 + kTurnTolerance_deg;
    }

    static double min_rotation(const AxisValues& from, const std::vector<AxisValues>& candidates) {
        double min = kUnreachable;
        for (const AxisValues& each : candidates) min = std::min(min, min_turn_between(from, each));
        return min;
    }

    void add_layer(std::vector<AxisValues> candidates, const std::vector<std::uint8_t>& from) {
        layer_begins_.push_back(from_.size());
        from_.insert(from_.end(), from.begin(), from.end());
        for (const AxisValues& each : candidates) values_.insert(values_.end(), each.begin(), each.end());
        joint_values_ = std::move(candidates);
    }

    void relax_turns_in_place(double stop_cost) {
        const std::vector<double> before = costs_;
        for (std::size_t k = 0; k < before.size(); ++k) {
            auto from = static_cast<std::uint8_t>(k);
            for (std::size_t j = 0; j < before.size(); ++j) {
                const double cost = before[j] + stop_cost + turn_between(joint_values_[j], joint_values_[k]);
                if (j == k || cost >= costs_[k]) continue;
                costs_[k] = cost;
                from = static_cast<std::uint8_t>(j);
            }
            in_place_predecessor_.push_back(from);
        }
    }

    AxisValues value(std::size_t layer, std::size_t candidate) const {
        AxisValues values(static_cast<Eigen::Index>(rotary_count_));
        const std::size_t begin = (layer_begins_[layer] + candidate) * rotary_count_;
        std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(begin), rotary_count_, values.begin());
        return values;
    }

    std::size_t rotary_count_;
    std::size_t unknown_ = 0;
    std::vector<AxisValues> joint_values_;
    std::vector<double> costs_;              // of each of joint_values_
    std::vector<std::size_t> layer_begins_;  // start of each target's candidates
    std::vector<double> values_;             // of all candidates
    std::vector<std::uint8_t> from_;         // which candidate before leads here
    std::vector<std::uint8_t>
        in_place_predecessor_;  // which candidate of the same target turns to this one on the spot
};

RotarySchedule Search::result() const {
    RotarySchedule turns(rotary_count_);
    turns.unknown = unknown_;
    if (layer_begins_.empty()) return turns;
    turns.values.resize(layer_begins_.size() * rotary_count_);
    auto at = static_cast<std::size_t>(std::min_element(costs_.begin(), costs_.end()) - costs_.begin());
    for (std::size_t layer = layer_begins_.size(); layer-- > 0;) {
        const AxisValues values = value(layer, at);
        std::copy(values.begin(), values.end(),
                  turns.values.begin() + static_cast<std::ptrdiff_t>(layer * rotary_count_));
        if (layer == 0) break;
        const std::size_t departure_candidate = from_[layer_begins_[layer] + at];
        at = in_place_predecessor_[layer_begins_[layer - 1] + departure_candidate];
        if (at != departure_candidate)
            turns.unwindings.push_back({unknown_ + layer - 1, value(layer - 1, departure_candidate)});
    }
    std::reverse(turns.unwindings.begin(), turns.unwindings.end());
    return turns;
}

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

    tl::expected<std::vector<RotarySchedule>, Error> run() {
        const std::vector<std::size_t>& order = states_.topological_order();
        for (auto path = order.rbegin(); path != order.rend(); ++path) {
            if (auto error = plan(*path)) return tl::unexpected(*error);
        }
        return std::move(turns_);
    }

  private:
    using OptionalError = std::optional<Error>;

    OptionalError plan(std::size_t path) {
        Search search(space_.rotary_count());
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

    OptionalError enter(Search& search, State& state, const SubPath& sub_path, const TargetId& id) {
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
                return Error{id,
                             "the sub-path cannot be repeated: the rotary axes would have to unwind each "
                             "time before its first point, and have no room for that"};
            }
        }
        repeat_unwindings_.push_back({*id.target, unwound_position});
        return std::nullopt;
    }

    // Keeps the axes as they are, whatever their values.
    OptionalError keep_position(Search& search, const State& state, const TargetId& id) {
        if (!search.now().empty()) return advance(search, state, false, search.now(), id);
        search.pass();
        return std::nullopt;
    }

    // Turns the axes that the point names.
    OptionalError go_to(Search& search, const State& state, const MachinePoint& point, const TargetId& id) {
        std::size_t named = 0;
        for (std::size_t i = 0; i < space_.rotary_count(); ++i)
            named += point.axes.contains(space_.rotary_axis(i).letter) ? 1 : 0;
        if (named == 0 && space_.rotary_count() > 0) return keep_position(search, state, id);
        std::vector<AxisValues> from = search.now();
        if (from.empty() && named < space_.rotary_count()) {
            return Error{id,
                         fmt::format("{} says of some rotary axes where they stand there, and nothing before "
                                     "it does of the others; begin with a point that has an orientation",
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

    OptionalError go_to(Search& search, const State& state, const Point& point, const TargetId& id) {
        const bool cutting = cuts(point, state);
        if (space_.rotary_count() == 0) {
            if (point.orientation && !std::holds_alternative<ToolAxis>(*point.orientation)) {
                auto none = candidates(search, point, *point.orientation);
                if (!none) return Error{id, none.error()};
            }
            return advance(search, state, cutting, {AxisValues(0)}, id);
        }
        const bool is_unchanged = !point.orientation && !search.now().empty() && !state.orientation.differs();
        if (is_unchanged) return advance(search, state, cutting, search.now(), id);
        const std::optional<Orientation> orientation =
            point.orientation ? point.orientation : state.orientation.value();
        if (!orientation) return Error{id, missing_orientation_message(state)};
        auto found = candidates(search, point, *orientation);
        if (!found) return Error{id, found.error()};
        return advance(search, state, cutting, std::move(*found), id);
    }

    static std::string missing_orientation_message(const State& state) {
        if (state.orientation.differs() && state.at_machine_point.value() == true) {
            return "the point needs an orientation: the fixed or reference point before it has turned the "
                   "rotary axes";
        }
        if (state.orientation.differs()) {
            return "the first point of this sub-path needs an orientation: the places that use it hand over "
                   "different ones";
        }
        return "the point needs an orientation: the machine has rotary axes, and no point before says where "
               "they stand";
    }

    tl::expected<std::vector<AxisValues>, std::string> candidates(const Search& search, const Point& point,
                                                                  const Orientation& orientation) const {
        const std::vector<AxisValues> home{space_.home_rotary()};
        return rotary_candidates(space_, point.position_mm, orientation,
                                 search.now().empty() ? home : search.now(), options_.is_literal);
    }

    OptionalError advance(Search& search, const State& state, bool cutting, std::vector<AxisValues> next,
                          const TargetId& id) const {
        if (search.now().empty()) {
            search.begin(std::move(next), space_.home_rotary(), id.path != program_.root);
            return std::nullopt;
        }
        const bool jet_off = jet_ && state.process_on.value() == false;
        if (search.step(std::move(next), cutting, jet_off ? kIdleStopCost_deg : kCuttingStopCost_deg)) {
            return std::nullopt;
        }
        return Error{id,
                     "out of reach: while the tool cuts, the rotary axes cannot go the short way from the "
                     "point before within their ranges"};
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

AxisValues RotarySchedule::at(std::size_t target) const {
    AxisValues found(static_cast<Eigen::Index>(count_));
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>((target - unknown) * count_), count_,
                found.begin());
    return found;
}

const AxisValues* RotarySchedule::find(const std::vector<Unwinding>& list, std::size_t target) {
    const auto found = std::lower_bound(
        list.begin(), list.end(), target,
        [](const Unwinding& each, std::size_t requested) { return each.target < requested; });
    return found != list.end() && found->target == target ? &found->to : nullptr;
}

const AxisValues* RotarySchedule::unwinding(std::size_t target) const {
    return find(unwindings, target);
}

const AxisValues* RotarySchedule::between_repeats(std::size_t target) const {
    return find(between, target);
}

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

tl::expected<std::vector<RotarySchedule>, Error> plan_rotary(const Program& program,
                                                             const MachineSpace& space, const States& states,
                                                             const RotaryOptions& options) {
    return Planner(program, space, states, options).run();
}

}  // namespace gsim::path
