#include "runtime/record/action_name.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace gsim::record {

namespace {

constexpr std::size_t kLongest = 200;

constexpr std::array<std::string_view, 16> kNoActions = {
    "message",    "print",       "print_open", "print_close", "debug",       "log",
    "log_open",   "log_append",  "log_close",  "probe_open",  "probe_close", "probe",
    "tool_table", "tool_number", "input",      "override"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kOwnNames = {
    {{"jet_on", "waterjet_on"}, {"jet_off", "waterjet_off"}}};

}  // namespace

std::string plain_name(std::string name) {
    if (name.size() > kLongest) name.resize(kLongest);
    std::replace_if(
        name.begin(), name.end(),
        [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return byte < 0x20 || byte == 0x7f;
        },
        ' ');
    return name;
}

std::optional<std::string> action_name(const simulation::Event& event) {
    if (std::find(kNoActions.begin(), kNoActions.end(), event.kind) != kNoActions.end()) return std::nullopt;
    for (const auto& [kind, name] : kOwnNames) {
        if (event.kind == kind) return std::string(name);
    }
    // The detail of an optional stop tells whether this run stopped, not what the program asks for.
    if (event.detail.empty() || event.kind == "optional_stop") return plain_name(event.kind);
    return plain_name(fmt::format("{} {}", event.kind, event.detail));
}

}  // namespace gsim::record
