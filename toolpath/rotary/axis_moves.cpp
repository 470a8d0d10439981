#include "toolpath/rotary/axis_moves.h"

#include <variant>

#include "toolpath/placement/set_up.h"
#include "toolpath/rotary/move_generator.h"

namespace gsim::path {

namespace {

// Writes one call, or one for each repeat if the axes unwind in between.
std::optional<TargetError> call(const SubPath& sub_path, std::size_t target, const RotarySchedule& turns,
                                const State& exit_state, MoveGenerator& move_generator, MoveSink& sink) {
    const AxisValues* to = turns.between_repeats(target);
    if (to == nullptr) {
        sink.call(sub_path);
    } else {
        for (int i = 0; i < sub_path.repeats; ++i) {
            move_generator.set_rotary(turns.at(target));
            auto error = i > 0 ? move_generator.unwind(target, to, exit_state) : std::nullopt;
            if (error) return error;
            sink.call({sub_path.path, 1});
        }
    }
    move_generator.return_from(target);
    return std::nullopt;
}

}  // namespace

tl::expected<void, TargetError> AxisMoves::run(std::size_t path, MoveSink& sink) const {
    PathSetup set_up(program_, states_, path, options_.tool_change_stops, jet_, sink);
    MoveGenerator move_generator(space_, turns_[path], options_, jet_, path, path != program_.root,
                                 entries_[path], set_up, sink);
    State state = states_.entry(path);
    const std::vector<Target>& targets = program_.paths[path].targets;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        sink.begin({path, i});
        if (auto error = set_up.before(i, state)) return tl::unexpected(*error);
        states_.set_up(state, path, targets[i]);
        if (const auto* point = std::get_if<Point>(&targets[i])) {
            if (auto error = move_generator.go_to(*point, i, state)) return tl::unexpected(*error);
        } else if (const auto* machine_point = std::get_if<MachinePoint>(&targets[i])) {
            if (auto error = move_generator.go_to(*machine_point, i, state)) return tl::unexpected(*error);
        }
        states_.pass(state, targets[i]);
        if (const auto* sub_path_call = std::get_if<SubPath>(&targets[i])) {
            if (auto error = call(*sub_path_call, i, turns_[path], state, move_generator, sink))
                return tl::unexpected(*error);
        }
        if (auto error = move_generator.unwind(i, turns_[path].unwinding(i), state))
            return tl::unexpected(*error);
    }
    if (path == program_.root) return {};
    if (auto error = set_up.finish(state)) return tl::unexpected(*error);
    return {};
}

}  // namespace gsim::path
