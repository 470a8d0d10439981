#include "machine/model/stop_keys.h"

#include <array>

#include "base/text/format.h"
#include "base/toml/toml_section.h"

namespace gsim::machine {

namespace {

using base::TomlSection;
using base::TomlWriter;

using rrs::StopRule;

// Names of StopRule in its order.
constexpr std::array<std::string_view, 3> kRules{"always", "on-change", "never"};

constexpr std::array<std::string_view, 47> kWords{
    "G10 L1", "G10 L2", "G10 L2 other", "G28.1", "G30.1", "G43",   "G43.1", "G43.2", "G44", "G49",
    "G52",    "G92",    "G92.1",        "G92.2", "G92.3", "M0",    "M1",    "M3",    "M4",  "M5",
    "M6",     "M7",     "M8",           "M9",    "M10",   "M11",   "M19",   "M48",   "M49", "M50",
    "M51",    "M52",    "M53",          "M60",   "M61",   "M64",   "M65",   "M66",   "M68", "S",
    "T",      "DEBUG",  "LOG",          "MSG",   "PRINT", "POPEN", "PCLOS"};

std::string_view rule_name(StopRule rule) {
    return kRules[static_cast<std::size_t>(rule)];
}

}  // namespace

std::span<const std::string_view> stop_words() {
    return kWords;
}

void read_stops(TomlSection& controller, rrs::StandstillRules& standstill) {
    auto section = controller.section(kStopsKey, "[controller.stops]", kWords);
    if (!section) return;
    for (const std::string_view word : kWords) {
        if (section->has(word))
            standstill.stops.insert_or_assign(std::string(word),
                                              static_cast<StopRule>(section->choice(word, 0, kRules)));
    }
}

void print_stops(TomlWriter& out, const rrs::StandstillRules& standstill, const rrs::StandstillRules& base) {
    std::vector<std::string> entries;
    for (const auto& [word, rule] : standstill.stops) {
        const auto before = base.stops.find(word);
        if (before != base.stops.end() && before->second == rule) continue;
        entries.push_back(
            fmt::format("{} = {}", base::toml_string(word), base::toml_string(rule_name(rule))));
    }
    if (!entries.empty()) out.line(kStopsKey, fmt::format("{{ {} }}", text::joined(entries, ", ")));
}

}  // namespace gsim::machine
