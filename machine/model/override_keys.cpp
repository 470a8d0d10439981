#include "machine/model/override_keys.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/toml/toml_section.h"

namespace gsim::machine {

namespace {

using base::NumberRule;
using base::TomlSection;
using base::TomlWriter;

using rrs::OverrideRules;

struct OverrideNumber {
    std::string_view key;
    double OverrideRules::*value;
    NumberRule rule;
};

constexpr std::string_view kRapidPercentsKey = "rapid_percents";
constexpr std::string_view kProbeFeedKey = "feed_of_probes";

constexpr std::array kOverrideNumbers{
    OverrideNumber{"feed_min_percent", &OverrideRules::feed_min_percent, NumberRule::not_negative},
    OverrideNumber{"feed_max_percent", &OverrideRules::feed_max_percent, NumberRule::positive},
    OverrideNumber{"rapid_max_percent", &OverrideRules::rapid_max_percent, NumberRule::percent},
    OverrideNumber{"spindle_min_percent", &OverrideRules::spindle_min_percent, NumberRule::not_negative},
    OverrideNumber{"spindle_max_percent", &OverrideRules::spindle_max_percent, NumberRule::positive},
    OverrideNumber{"planned_feed_percent", &OverrideRules::planned_feed_percent, NumberRule::positive},
    OverrideNumber{"delay_s", &OverrideRules::delay_s, NumberRule::not_negative},
};

constexpr auto kOverrideKeys = [] {
    std::array<std::string_view, kOverrideNumbers.size() + 2> keys{kRapidPercentsKey, kProbeFeedKey};
    std::size_t end = 2;
    for (const OverrideNumber& percent : kOverrideNumbers) keys[end++] = percent.key;
    return keys;
}();

/// Reads rising values above 0 and up to 100.
std::vector<double> read_rapid_percents(TomlSection& section, const std::vector<double>& fallback) {
    if (!section.has(kRapidPercentsKey)) return fallback;
    const toml::array* array = section.require(kRapidPercentsKey)->as_array();
    std::vector<double> percents;
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
        const double min = percents.empty() ? 0 : percents.back();
        const auto value = (*array)[i].is_number() ? (*array)[i].value<double>() : std::nullopt;
        if (!value || !(*value > min && *value <= 100)) {
            array = nullptr;
        } else {
            percents.push_back(*value);
        }
    }
    if (array != nullptr) return percents;
    section.fail(
        kRapidPercentsKey,
        fmt::format("'{}' must be an array of ascending numbers, above 0 and up to 100", kRapidPercentsKey));
    return fallback;
}

void check_range(TomlSection& section, std::string_view key, double min, double max) {
    if (min <= max) return;
    section.fail(key, fmt::format("'{}' is {}, above the maximum of {}", key, min, max));
}

}  // namespace

void read_overrides(TomlSection& controller, OverrideRules& overrides) {
    auto section = controller.section(kOverridesKey, "[controller.overrides]", kOverrideKeys);
    if (!section) return;
    for (const auto& [key, value, rule] : kOverrideNumbers)
        overrides.*value = section->number(key, overrides.*value, rule);
    overrides.rapid_percents = read_rapid_percents(*section, overrides.rapid_percents);
    overrides.override_probe_feed = section->flag(kProbeFeedKey, overrides.override_probe_feed);
    check_range(*section, "feed_min_percent", overrides.feed_min_percent, overrides.feed_max_percent);
    check_range(*section, "spindle_min_percent", overrides.spindle_min_percent,
                overrides.spindle_max_percent);
}

void print_overrides(TomlWriter& out, const OverrideRules& now, const OverrideRules& base) {
    std::vector<std::string> entries;
    for (const auto& [key, value, rule] : kOverrideNumbers) {
        if (now.*value != base.*value)
            entries.push_back(fmt::format("{} = {}", key, base::toml_number(now.*value)));
    }
    if (now.rapid_percents != base.rapid_percents) {
        std::vector<std::string> percents;
        for (const double percent : now.rapid_percents) percents.push_back(base::toml_number(percent));
        entries.push_back(fmt::format("{} = [{}]", kRapidPercentsKey, text::joined(percents, ", ")));
    }
    if (now.override_probe_feed != base.override_probe_feed)
        entries.push_back(fmt::format("{} = {}", kProbeFeedKey, now.override_probe_feed));
    if (!entries.empty()) out.line(kOverridesKey, fmt::format("{{ {} }}", text::joined(entries, ", ")));
}

}  // namespace gsim::machine
