// Blocks that set the position of the machine and the reference of positions, and blocks that move to
// positions of the machine.

#include <algorithm>

#include "codegen/post/gcode_writer.h"

namespace gsim::codegen {

void GcodeWriter::preset(std::string_view word, std::span<const double> values) {
    begin_block();
    code(word);
    axis_words(values);
    end_block();
}

void GcodeWriter::set_position(std::span<const double> values) {
    for (std::size_t i = 0; i < axes_.size(); ++i) at_[i] = set_position(i, values[i]);
}

void GcodeWriter::set_active_offset(const std::string& name) {
    system_ = name;
}

void GcodeWriter::work_offset(const std::string& name) {
    if (system_ == name) return;
    system_ = name;
    std::fill(at_.begin(), at_.end(), kUnknown);
    PlaceholderValues placeholders = placeholders_;
    placeholders["system"] = name;
    begin_block();
    code(fill_template(post_.offsets.system, placeholders));
    end_block();
}

std::string GcodeWriter::length_text(double mm) const {
    fmt::memory_buffer number;
    length_.append(number, length_.units(in_unit(mm)));
    return fmt::to_string(number);
}

// Returns the index for G10, from 1.
std::string GcodeWriter::system_index(const std::string& system) const {
    const std::vector<std::string>& systems = post_.offsets.systems;
    return fmt::format("{}", std::find(systems.begin(), systems.end(), system) - systems.begin() + 1);
}

void GcodeWriter::set_work_offset(const std::string& name, const std::array<double, 3>& origin_mm) {
    PlaceholderValues placeholders = placeholders_;
    placeholders["index"] = system_index(name);
    for (std::size_t i = 0; i < origin_mm.size(); ++i)
        placeholders[std::string(1, static_cast<char>('x' + i))] = length_text(origin_mm[i]);
    begin_block();
    code(fill_template(post_.offsets.set, placeholders));
    end_block();
}

// Writes only the named axes of X, Y and Z.
void GcodeWriter::rapid_block(std::string_view letters, const std::array<double, 3>& xyz_mm) {
    begin_block();
    motion_ = kNoMotion;
    motion_word(0);
    for (const char letter : letters)
        word(letter, length_.units(in_unit(xyz_mm[static_cast<std::size_t>(letter - 'X')])), length_);
    end_block();
}

void GcodeWriter::touch(const std::string& system, const WrittenTouch& touch) {
    rapid_block("XY", touch.from_mm);
    rapid_block("Z", touch.from_mm);
    fmt::memory_buffer feed;
    feed_.append(feed, std::max<std::int64_t>(1, feed_.units(in_unit(touch.feed_mm_min))));
    const PlaceholderValues before = placeholders_;
    placeholders_["axis"] = std::string(1, touch.axis);
    placeholders_["number"] = fmt::format("{}", touch.axis - 'X' + 1);
    placeholders_["to"] = length_text(touch.to_mm);
    placeholders_["surface"] = length_text(touch.contact_mm);
    placeholders_["feed"] = fmt::to_string(feed);
    placeholders_["index"] = system_index(system);
    placeholders_["system"] = system;
    lines(post_.touch);
    placeholders_ = before;
    rapid_block({&touch.axis, 1}, touch.from_mm);
    std::fill(at_.begin(), at_.end(), kUnknown);
    feed_units_ = kUnknown;
}

void GcodeWriter::retract(double z_mm) {
    std::fill(at_.begin(), at_.end(), kUnknown);
    if (post_.offsets.machine.empty() || machine_z_ == length_.units(in_unit(z_mm))) return;
    machine_block({{'Z', z_mm}});
}

void GcodeWriter::machine_rapids(const std::vector<std::map<char, double>>& steps) {
    std::fill(at_.begin(), at_.end(), kUnknown);
    for (const auto& step : steps) machine_block(step);
}

void GcodeWriter::machine_block(const std::map<char, double>& axes) {
    const std::int64_t z_before = machine_z_;
    begin_block();
    code(post_.offsets.machine);
    motion_ = kNoMotion;
    motion_word(0);
    machine_z_ = z_before;
    for (const WrittenAxis& axis : axes_) {
        const auto value = axes.find(axis.letter);
        if (value == axes.end()) continue;
        const DecimalFormat& format = axis.rotary ? deg_ : length_;
        const std::int64_t printed_units = format.units(axis.rotary ? value->second : in_unit(value->second));
        word(axis.letter, printed_units, format);
        if (axis.letter == 'Z') machine_z_ = printed_units;
    }
    end_block();
}

// Increments of 0 make the present position the intermediate point of such a word.
void GcodeWriter::move_to_reference(int number, const std::vector<std::map<char, double>>& steps) {
    std::fill(at_.begin(), at_.end(), kUnknown);
    motion_ = kNoMotion;
    const std::string& line = post_.references.go[static_cast<std::size_t>(number - 1)];
    for (const auto& step : steps) {
        fmt::memory_buffer words;
        for (const WrittenAxis& axis : axes_) {
            if (!step.contains(axis.letter)) continue;
            if (words.size() > 0) words.push_back(' ');
            words.push_back(axis.letter);
            (axis.rotary ? deg_ : length_).append(words, 0);
        }
        PlaceholderValues placeholders = placeholders_;
        placeholders["axes"] = fmt::to_string(words);
        begin_block();
        code(fill_template(line, placeholders));
        end_block();
    }
    lines(post_.references.end);
}

}  // namespace gsim::codegen
