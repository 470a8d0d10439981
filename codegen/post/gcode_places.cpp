// Blocks that say where the machine stands, what positions are counted in, and that lead to places of the
// machine.

#include <algorithm>

#include "codegen/post/gcode_writer.h"

namespace gsim::codegen {

void GcodeWriter::here(std::string_view word, std::span<const double> values) {
    begin_block();
    code(word);
    axis_words(values);
    end_block();
}

void GcodeWriter::stand(std::span<const double> values) {
    for (std::size_t i = 0; i < axes_.size(); ++i) at_[i] = stand_at(i, values[i]);
}

void GcodeWriter::begin_in(const std::string& name) {
    system_ = name;
}

void GcodeWriter::work_offset(const std::string& name) {
    if (system_ == name) return;
    system_ = name;
    std::fill(at_.begin(), at_.end(), kUnknown);
    Places places = places_;
    places["system"] = name;
    begin_block();
    code(filled(post_.offsets.system, places));
    end_block();
}

void GcodeWriter::set_work_offset(const std::string& name, const std::array<double, 3>& origin_mm) {
    const std::vector<std::string>& systems = post_.offsets.systems;
    Places places = places_;
    places["index"] =
        fmt::format("{}", std::find(systems.begin(), systems.end(), name) - systems.begin() + 1);
    for (std::size_t i = 0; i < origin_mm.size(); ++i) {
        fmt::memory_buffer number;
        length_.append(number, length_.units(in_unit(origin_mm[i])));
        places[std::string(1, static_cast<char>('x' + i))] = fmt::to_string(number);
    }
    begin_block();
    code(filled(post_.offsets.set, places));
    end_block();
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
        const std::int64_t printed = format.units(axis.rotary ? value->second : in_unit(value->second));
        word(axis.letter, printed, format);
        if (axis.letter == 'Z') machine_z_ = printed;
    }
    end_block();
}

// By increments of 0: the point on the way that such a word names is where the tool stands.
void GcodeWriter::go_to_reference(int number, const std::vector<std::map<char, double>>& steps) {
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
        Places places = places_;
        places["axes"] = fmt::to_string(words);
        begin_block();
        code(filled(line, places));
        end_block();
    }
    lines(post_.references.end);
}

}  // namespace gsim::codegen
