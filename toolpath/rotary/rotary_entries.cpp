#include "toolpath/rotary/rotary_entries.h"

namespace gsim::path {

namespace {

/// Values that the users of one path pass on.
struct Entry {
    std::optional<AxisValues> rotary;
    bool is_set = false;

    void merge(const std::optional<AxisValues>& other) {
        if (!is_set) {
            rotary = other;
        } else if (rotary && (!other || *rotary != *other)) {
            rotary.reset();
        }
        is_set = true;
    }
};

}  // namespace

std::vector<std::optional<AxisValues>> rotary_entries(const Program& program, const States& states,
                                                      const std::vector<RotarySchedule>& turns) {
    std::vector<Entry> entries(program.paths.size());
    for (const std::size_t path : states.topological_order()) {
        std::optional<AxisValues> now = entries[path].rotary;
        const std::vector<Target>& targets = program.paths[path].targets;
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const std::optional<AxisValues> exit_state =
                turns[path].is_known(i) ? std::optional(turns[path].at(i)) : now;
            if (const auto* sub_path = std::get_if<SubPath>(&targets[i])) {
                entries[sub_path->path].merge(now);
                const AxisValues* between = turns[path].between_repeats(i);
                if (sub_path->repeats > 1)
                    entries[sub_path->path].merge(between != nullptr ? std::optional(*between) : exit_state);
            }
            const AxisValues* unwound_position = turns[path].unwinding(i);
            now = unwound_position != nullptr ? std::optional(*unwound_position) : exit_state;
        }
    }
    std::vector<std::optional<AxisValues>> rotary;
    rotary.reserve(entries.size());
    for (Entry& entry : entries) rotary.push_back(std::move(entry.rotary));
    return rotary;
}

}  // namespace gsim::path
