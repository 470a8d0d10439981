#include "runtime/record/action_name.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/text/utf8.h"

namespace gsim::record {

namespace {

constexpr std::size_t kMaxNameLength = 200;

// Results of a probe are in the positions that follow; a tool table that is read again is as it was.
constexpr std::array<std::string_view, 2> kNoActions = {"probe", "tool_table"};

// The detail of these events is the word that switches the process here.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kSpecialNames = {
    {{"jet_on", "waterjet_on"},
     {"jet_off", "waterjet_off"},
     {"plasma_on", "plasma_on"},
     {"plasma_off", "plasma_off"},
     {"laser_on", "laser_on"},
     {"laser_off", "laser_off"}}};

}  // namespace

std::string number_text(double value) {
    std::string text = fmt::format("{:.9f}", value);
    text.resize(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string sanitized_name(std::string_view name) {
    constexpr std::uint32_t kFirstPrintable = 0x20;
    constexpr std::uint32_t kDeleteCharacter = 0x7f;
    std::string plain;
    while (!name.empty()) {
        const text::Character first = text::first_character(name);
        const std::size_t bytes = std::max<std::size_t>(first.bytes, 1);
        if (plain.size() + bytes > kMaxNameLength) break;
        if (first.bytes == 0) {
            plain += '?';
        } else if (first.code < kFirstPrintable || first.code == kDeleteCharacter) {
            plain += ' ';
        } else {
            plain += name.substr(0, bytes);
        }
        name.remove_prefix(bytes);
    }
    return plain;
}

std::optional<std::string> action_name(const simulation::Event& event) {
    if (std::find(kNoActions.begin(), kNoActions.end(), event.kind) != kNoActions.end()) return std::nullopt;
    for (const auto& [kind, name] : kSpecialNames) {
        if (event.kind == kind) return std::string(name);
    }
    // The detail of an optional stop says whether this run stopped, not what the program requests.
    if (event.detail.empty() || event.kind == "optional_stop") return sanitized_name(event.kind);
    return sanitized_name(fmt::format("{} {}", event.kind, event.detail));
}

}  // namespace gsim::record
