#include "codegen/post/offset_blocks.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gsim::codegen {

void OffsetBlocks::preset(std::string_view word, std::span<const double> values) {
    text_.begin();
    text_.code(word);
    axes_.write(text_, values);
    text_.end();
}

void OffsetBlocks::select(const std::string& name) {
    if (active_ == name) return;
    active_ = name;
    axes_.forget_positions();
    PlaceholderValues placeholders = text_.placeholders();
    placeholders["system"] = name;
    text_.block(post_.offsets.system, placeholders);
}

/// Returns the index for G10, from 1.
std::string OffsetBlocks::system_index(const std::string& system) const {
    const std::vector<std::string>& systems = post_.offsets.systems;
    return fmt::format("{}", std::find(systems.begin(), systems.end(), system) - systems.begin() + 1);
}

void OffsetBlocks::set_origin(const std::string& name, const std::array<double, 3>& origin_mm) {
    PlaceholderValues placeholders = text_.placeholders();
    placeholders["index"] = system_index(name);
    for (std::size_t i = 0; i < origin_mm.size(); ++i)
        placeholders[std::string(1, static_cast<char>('x' + i))] = axes_.length_text(origin_mm[i]);
    text_.block(post_.offsets.set, placeholders);
}

/// Writes only the named axes of X, Y and Z.
void OffsetBlocks::rapid_block(std::string_view letters, const std::array<double, 3>& xyz_mm) {
    text_.begin();
    modal_.forget_motion();
    modal_.write_motion(text_, MotionWord::rapid);
    for (const char letter : letters) {
        const double mm = xyz_mm[static_cast<std::size_t>(letter - 'X')];
        text_.word(letter, axes_.length_increments(mm), axes_.length());
    }
    text_.end();
}

void OffsetBlocks::touch(const std::string& system, const ProbeTouch& touch) {
    rapid_block("XY", touch.from_mm);
    rapid_block("Z", touch.from_mm);
    PlaceholderValues& placeholders = text_.placeholders();
    const PlaceholderValues before = placeholders;
    placeholders["axis"] = std::string(1, touch.axis);
    placeholders["number"] = fmt::format("{}", touch.axis - 'X' + 1);
    placeholders["to"] = axes_.length_text(touch.to_mm);
    placeholders["surface"] = axes_.length_text(touch.contact_mm);
    placeholders["feed"] = feed_.text(touch.feed_mm_min);
    placeholders["index"] = system_index(system);
    placeholders["system"] = system;
    text_.lines(post_.touch);
    placeholders = before;
    rapid_block({&touch.axis, 1}, touch.from_mm);
    axes_.forget_positions();
    feed_.forget_value();
}

}  // namespace gsim::codegen
