#include "grammar/dialect.h"

#include <fmt/format.h>

namespace gsim::grammar {

namespace {

constexpr std::size_t kIndexedCodes = 6000;  // codes_x10 up to G599.9

std::size_t slot(char letter, std::int32_t code_x10) {
    return (letter == 'M' ? kIndexedCodes : 0) + static_cast<std::size_t>(code_x10);
}

}  // namespace

std::string_view name(Group group) {
    switch (group) {
        case Group::none: return "non-modal";
        case Group::motion: return "motion";
        case Group::plane: return "plane";
        case Group::units: return "units";
        case Group::distance: return "distance mode";
        case Group::feed_mode: return "feed mode";
        case Group::cutter_compensation: return "cutter compensation";
        case Group::tool_length: return "tool length";
        case Group::cycle: return "canned cycles";
        case Group::return_level: return "return level of cycles";
        case Group::scaling: return "scaling";
        case Group::mirror: return "mirror image";
        case Group::rotation: return "part rotation";
        case Group::work_frame: return "work coordinate system";
        case Group::path_mode: return "path mode";
        case Group::polar: return "polar programming";
        case Group::zone: return "programmable zone";
        case Group::macro: return "modal macro call";
        case Group::spindle_mode: return "spindle speed mode";
        case Group::acceleration: return "acceleration mode";
        case Group::stop: return "program stop";
        case Group::spindle: return "spindle";
        case Group::tool_change: return "tool change";
        case Group::jet: return "jet";
        case Group::abrasive: return "abrasive";
        case Group::subprogram: return "subprograms";
        case Group::override_switch: return "override switch";
    }
    return "";
}

Dialect::Dialect(std::string_view name, std::string_view title, std::span<const Code> codes)
    : name_(name), title_(title), codes_(codes), index_(2 * kIndexedCodes, 0) {
    for (std::size_t row = 0; row < codes_.size(); ++row) {
        index_[slot(codes_[row].letter, codes_[row].code_x10)] = static_cast<std::uint16_t>(row + 1);
    }
}

const Code* Dialect::find(char letter, std::int32_t code_x10) const {
    if (code_x10 < 0 || code_x10 >= static_cast<std::int32_t>(kIndexedCodes)) return nullptr;
    const std::uint16_t row = index_[slot(letter, code_x10)];
    return row == 0 ? nullptr : &codes_[row - 1U];
}

std::string code_name(const Code& code) {
    const int whole = code.code_x10 / 10;
    const int part = code.code_x10 % 10;
    return part == 0 ? fmt::format("{}{}", code.letter, whole)
                     : fmt::format("{}{}.{}", code.letter, whole, part);
}

std::string lua_name(const Code& code) {
    const int whole = code.code_x10 / 10;
    const int part = code.code_x10 % 10;
    return part == 0 ? fmt::format("{}{}", code.letter, whole)
                     : fmt::format("{}{}_{}", code.letter, whole, part);
}

}  // namespace gsim::grammar
