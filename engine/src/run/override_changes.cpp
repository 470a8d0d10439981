#include "engine/src/run/override_changes.h"

#include <algorithm>
#include <array>

#include "base/text/format.h"
#include "base/toml/toml_section.h"

namespace gsim::engine {

namespace {

using base::NumberRule;
using motion::OverrideChange;
using motion::Overrides;
using motion::OverrideSchedule;
using std::string_view_literals::operator""sv;

constexpr std::array kOverrideFileKeys{"override"sv};
constexpr std::array kChangeKeys{"at_s"sv, "feed_percent"sv, "rapid_percent"sv, "spindle_percent"sv};

/// The values of one override that a controller accepts.
struct PercentRange {
    double min = 0;
    double max = 0;
    std::vector<double> steps = {};

    bool accepts(double percent) const {
        if (!steps.empty()) return std::find(steps.begin(), steps.end(), percent) != steps.end();
        return percent >= min && percent <= max;
    }
    std::string text() const {
        if (steps.empty()) return fmt::format("from {:g} to {:g} %", min, max);
        std::string all;
        for (const double step : steps) {
            const char* separator = all.empty() ? "" : step == steps.back() ? " or " : ", ";
            text::append_format(all, "{}{:g}", separator, step);
        }
        return all + " %";
    }
};

/// One of the three overrides: its names, its member in Overrides, and the values that a controller accepts.
struct Kind {
    std::string_view option;
    std::string_view key;
    std::optional<double> OverrideOptions::*percent;
    double Overrides::*share;
    PercentRange (*allowed)(const rrs::OverrideRules&);
};

constexpr std::array kOverrideKinds{
    Kind{"--feed-override", "feed_percent", &OverrideOptions::feed_percent, &Overrides::feed,
         [](const rrs::OverrideRules& r) {
             return PercentRange{r.feed_min_percent, r.feed_max_percent};
         }},
    Kind{"--rapid-override", "rapid_percent", &OverrideOptions::rapid_percent, &Overrides::rapid,
         [](const rrs::OverrideRules& r) {
             return PercentRange{0, r.rapid_max_percent, r.rapid_percents};
         }},
    Kind{"--spindle-override", "spindle_percent", &OverrideOptions::spindle_percent, &Overrides::spindle,
         [](const rrs::OverrideRules& r) {
             return PercentRange{r.spindle_min_percent, r.spindle_max_percent};
         }},
};

/// Returns an error if the controller rejects a value.
std::optional<gsim::Error> find_override_error(const Kind& kind, double percent,
                                               const rrs::ControllerRules& controller) {
    const rrs::PlannerCapabilities& planner = controller.capabilities();
    if (!planner.speed_factor_word.empty() && percent != 100)
        return fmt::format("the planner \"{}\" supports no override; {} in the program sets its speed factor",
                           planner.name, planner.speed_factor_word);
    const PercentRange allowed = kind.allowed(controller.overrides);
    if (!allowed.accepts(percent))
        return fmt::format("the controller {} supports {}", controller.model, allowed.text());
    if (percent <= 0 && kind.share == &Overrides::spindle)
        return "motion synchronized with a spindle at 0 % would never end";
    return {};
}

class ChangesReader {
  public:
    ChangesReader(base::FirstError& error, const Overrides& first, const rrs::ControllerRules& controller)
        : error_(error), controller_(controller), changes_{{0, first}} {}

    std::vector<OverrideChange> read(const toml::table& root) {
        base::TomlSection file(error_, root, "the overrides file", kOverrideFileKeys);
        for (const toml::table* table : file.tables("override")) read_change(*table);
        if (changes_.size() > 1 && changes_.front() == OverrideChange{}) changes_.erase(changes_.begin());
        return std::move(changes_);
    }

  private:
    void read_change(const toml::table& table) {
        base::TomlSection section(error_, table, "[[override]]", kChangeKeys);
        section.require("at_s");
        OverrideChange change = changes_.back();
        change.at_s = section.number("at_s", 0, NumberRule::not_negative);
        bool turns = false;
        for (const Kind& kind : kOverrideKinds) turns = read_share(section, kind, change.to) || turns;
        if (!turns)
            section.fail(
                "at_s",
                "[[override]] changes nothing: it must have feed_percent, rapid_percent or spindle_percent");
        if (change.at_s == 0 && is_first_) {
            changes_.back() = change;
        } else if (change.at_s > changes_.back().at_s) {
            changes_.push_back(change);
        } else {
            section.fail("at_s", fmt::format("'at_s' is {:g}; it must be greater than the one above, {:g}",
                                             change.at_s, changes_.back().at_s));
        }
        is_first_ = false;
    }

    bool read_share(base::TomlSection& section, const Kind& kind, Overrides& to) {
        if (!section.has(kind.key)) return false;
        const double percent = section.number(kind.key, 100, NumberRule::not_negative);
        if (const auto error = find_override_error(kind, percent, controller_))
            section.fail(kind.key, fmt::format("'{}' is {:g}: {}", kind.key, percent, error->message));
        to.*kind.share = percent / 100;
        return true;
    }

    base::FirstError& error_;
    const rrs::ControllerRules& controller_;
    std::vector<OverrideChange> changes_;
    bool is_first_ = true;
};

}  // namespace

Result<OverrideSchedule> read_override_changes(std::string_view toml_text, std::string_view file_name,
                                               const Overrides& first,
                                               const rrs::ControllerRules& controller) {
    base::FirstError error(file_name);
    const toml::table root = base::parse_toml(error, toml_text);
    std::vector<OverrideChange> changes = ChangesReader(error, first, controller).read(root);
    const Overrides& last = changes.back().to;
    if (last.feed <= 0 || last.rapid <= 0) {
        error.report(root.source().end,
                     "the last [[override]] stops the machine (0 %): the run would never end");
    }
    if (error.text()) return tl::unexpected(*error.text());
    return OverrideSchedule(std::move(changes));
}

Result<OverrideSchedule> read_overrides(const os::Files& files, const OverrideOptions& options,
                                        const rrs::ControllerRules& controller) {
    Overrides first;
    for (const Kind& kind : kOverrideKinds) {
        const auto& percent = options.*kind.percent;
        if (!percent) continue;
        if (const auto error = find_override_error(kind, *percent, controller))
            return Unexpected(fmt::format("{} {:g}: {}", kind.option, *percent, error->message));
        if (*percent <= 0) {
            return Unexpected(
                fmt::format("{} 0 would stop the machine indefinitely; a file of changes (--overrides) may "
                            "stop it for a time",
                            kind.option));
        }
        first.*kind.share = *percent / 100;
    }
    if (!options.file.empty()) {
        const auto text = files.read_text(options.file, os::NameSource::command_line);
        if (!text) return tl::unexpected(text.error());
        return read_override_changes(*text, options.file, first, controller);
    }
    if (options.is_default()) return OverrideSchedule();
    return OverrideSchedule({{0, first}});
}

}  // namespace gsim::engine
