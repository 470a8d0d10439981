#include "codegen/post/machine_blocks.h"

#include <cstddef>
#include <string>

namespace gsim::codegen {

void MachineBlocks::retract(double z_mm) {
    axes_.forget_positions();
    if (post_.offsets.machine.empty() || z_increments() == axes_.length_increments(z_mm)) return;
    rapid({{'Z', z_mm}});
}

void MachineBlocks::move(const std::vector<std::map<char, double>>& steps) {
    axes_.forget_positions();
    for (const auto& step : steps) rapid(step);
}

void MachineBlocks::rapid(const std::map<char, double>& axes) {
    z_increments_ = z_increments();
    text_.begin();
    z_block_ = text_.begun();
    text_.code(post_.offsets.machine);
    modal_.forget_motion();
    modal_.write_motion(text_, MotionWord::rapid);
    for (std::size_t i = 0; i < axes_.axes().size(); ++i) {
        const char letter = axes_.axes()[i].letter;
        const auto value = axes.find(letter);
        if (value == axes.end()) continue;
        const std::int64_t printed_increments = axes_.increments(i, value->second);
        text_.word(letter, printed_increments, axes_.format(i));
        if (letter == 'Z') z_increments_ = printed_increments;
    }
    text_.end();
}

// Increments of 0 make the present position the intermediate point of such a word.
void MachineBlocks::move_to_reference(int number, const std::vector<std::map<char, double>>& steps) {
    axes_.forget_positions();
    modal_.forget_motion();
    const std::string& line = post_.references.go[static_cast<std::size_t>(number - 1)];
    for (const auto& step : steps) {
        fmt::memory_buffer words;
        for (std::size_t i = 0; i < axes_.axes().size(); ++i) {
            const char letter = axes_.axes()[i].letter;
            if (!step.contains(letter)) continue;
            if (words.size() > 0) words.push_back(' ');
            words.push_back(letter);
            axes_.format(i).append(words, 0);
        }
        PlaceholderValues placeholders = text_.placeholders();
        placeholders["axes"] = fmt::to_string(words);
        text_.block(line, placeholders);
    }
    text_.lines(post_.references.end);
}

}  // namespace gsim::codegen
