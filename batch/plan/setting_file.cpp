#include "batch/plan/setting_file.h"

#include <array>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "batch/work/edits.h"
#include "batch/work/run_options.h"

namespace gsim::batch {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using nlohmann::json;

constexpr std::array<std::string_view, 13> kSettingKeys{
    "key",  "keys", "values",    "from",  "to",    "steps", "distribution",
    "mean", "mode", "deviation", "scale", "shift", "orders"};
constexpr std::array<std::string_view, 3> kDistributions{"uniform", "normal", "triangular"};
constexpr std::uint64_t kMaxSteps = 100'000;
constexpr const char* kOrderKey = "path.order";

class SettingReader {
  public:
    SettingReader(FirstError& error, const toml::table& table, const ResolveFile& resolve_file)
        : error_(error),
          table_(table),
          section_(error, table, "[[setting]]", kSettingKeys),
          resolve_file_(resolve_file) {}

    std::optional<Setting> read() {
        read_keys();
        read_use();
        for (const std::string& key : setting_.keys) check_key(key);
        if (setting_.keys.empty()) return std::nullopt;
        read_domain();
        return std::move(setting_);
    }

  private:
    void read_keys() {
        if (section_.has("key") == section_.has("keys"))
            return section_.fail(
                "key", "[[setting]] must have a 'key', or a list of 'keys' that get the same value");
        if (section_.has("key")) {
            setting_.keys = {section_.text("key")};
            return;
        }
        const toml::array* list = table_.get("keys")->as_array();
        for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
            if (const auto* key = list->get(i)->as_string()) setting_.keys.push_back(key->get());
        }
        if (list == nullptr || list->empty() || setting_.keys.size() != list->size())
            section_.fail("keys", "'keys' must be a list of strings");
    }

    void read_use() {
        const bool scales = section_.flag("scale", false), shifts = section_.flag("shift", false);
        if (scales && shifts)
            section_.fail("shift", "a value must be a factor ('scale') or added ('shift'), not both");
        if (scales) setting_.use = SettingUse::factor;
        if (shifts) setting_.use = SettingUse::shift;
    }

    void check_key(const std::string& key) {
        if (const auto key_error = find_key_name_error(key)) return section_.fail("key", key_error->message);
        const bool is_file_setting =
            key.starts_with(kMachinePrefix) || key.starts_with(kCellPrefix) || key.starts_with(kRobotsPrefix);
        const bool is_feed = key.starts_with(kPathPrefix) && key.ends_with("feed_mm_min");
        if (setting_.use == SettingUse::factor && !is_file_setting && !is_feed)
            section_.fail("scale",
                          "'scale' applies only to feeds, and to values of a machine, cell or robots file");
        if (setting_.use == SettingUse::shift && !is_file_setting)
            section_.fail("shift", "'shift' applies only to values of a machine, cell or robots file");
        const bool has_order_values = section_.has("orders") || section_.has("values");
        if (key == kOrderKey ? !has_order_values : section_.has("orders"))
            section_.fail(
                "key", "'path.order' must have 'orders', the number of items to order, or lists as 'values'");
    }

    void read_domain() {
        if (section_.has("orders")) return read_orders();
        const bool has_values = section_.has("values");
        if (has_values == section_.has("from") && !(section_.has("distribution") && !has_values))
            return section_.fail("key",
                                 "[[setting]] must have 'values', or 'from' and 'to', or a 'distribution'");
        reject_unused(section_, has_values);
        for (const std::string& key : setting_.keys) {
            if (has_values || !key.starts_with(kOptionPrefix)) continue;
            if (const auto checked = check_option(key.substr(kOptionPrefix.size()), 1.5); !checked)
                return section_.fail("key", checked.error().message);
        }
        setting_.domain = has_values ? Domain(values()) : read_numbers(section_);
    }

    void read_orders() {
        reject(section_, {"values", "from", "to", "steps", "distribution", "mean", "mode", "deviation"},
               "'orders'");
        const double count = section_.number("orders", 2, NumberRule::count);
        if (count < 2 || count > static_cast<double>(kMaxOrdered))
            section_.fail("orders", fmt::format("'orders' must be from 2 to {}", kMaxOrdered));
        setting_.domain = Order{static_cast<std::size_t>(count)};
    }

    static void reject(TomlSection& section, std::initializer_list<const char*> keys,
                       const char* other_keys) {
        for (const char* key : keys) {
            if (section.has(key))
                section.fail(key, fmt::format("'{}' has no effect together with {}", key, other_keys));
        }
    }

    /// Rejects keys that have no effect next to the others.
    static void reject_unused(TomlSection& section, bool has_values) {
        if (has_values)
            return reject(section, {"from", "to", "steps", "distribution", "mean", "mode", "deviation"},
                          "'values'");
        if (section.has("steps"))
            return reject(section, {"distribution", "mean", "mode", "deviation"}, "'steps'");
        const std::size_t distribution = section.choice("distribution", 0, kDistributions);
        if (distribution == 1) return reject(section, {"from", "to", "mode"}, "'normal'");
        reject(section, {"mean", "deviation"}, "'from' and 'to'");
        if (distribution == 0) reject(section, {"mode"}, "'uniform'");
        section.require("from");
        section.require("to");
    }

    Choices values() {
        Choices choices;
        const toml::array* list = table_.get("values")->as_array();
        if (list == nullptr || list->empty()) {
            section_.fail("values", "'values' must be a list with at least one value");
            return choices;
        }
        for (const toml::node& node : *list) {
            if (auto value = parse_value(node)) choices.values.push_back(*std::move(value));
        }
        return choices;
    }

    /// Returns a value that is valid for all keys.
    std::optional<json> parse_value(const toml::node& node) {
        auto value = setting_.keys.front() == kOrderKey ? parse_number_list(node) : scalar_value(node);
        if (!value || (setting_.use != SettingUse::set && !value->is_number())) {
            error_.report(node.source().begin, setting_.use != SettingUse::set
                                                   ? "a factor, or an added value, must be a number"
                                                   : "a value must be a number, a string, or true or false");
            return std::nullopt;
        }
        for (const std::string& key : setting_.keys) {
            if (!key.starts_with(kOptionPrefix)) continue;
            const std::string name = key.substr(kOptionPrefix.size());
            if (const auto checked = check_option(name, *value); !checked) {
                error_.report(node.source().begin, checked.error().message);
            } else if (find_option(name)->kind == RunOption::Kind::file) {
                value = resolve_file_(value->get<std::string>());
            }
        }
        return value;
    }

    static std::optional<json> parse_number_list(const toml::node& node) {
        const toml::array* list = node.as_array();
        if (list == nullptr) return std::nullopt;
        json read_numbers = json::array();
        for (const toml::node& each : *list) {
            const auto* integer = each.as_integer();
            if (integer == nullptr || integer->get() < 0) return std::nullopt;
            read_numbers.push_back(static_cast<std::uint64_t>(integer->get()));
        }
        return read_numbers;
    }

    Domain read_numbers(TomlSection& section) {
        const double from = section.number("from", 0, NumberRule::finite);
        const double to = section.number("to", from, NumberRule::finite);
        if (section.has("from") && section.require("to") == nullptr) return Choices{};
        if (to < from) section.fail("to", "'to' must not be less than 'from'");
        if (section.has("steps"))
            return evenly_spaced(from, to, read_integer(section, "steps", 2, kMaxSteps, 2));
        switch (section.choice("distribution", 0, kDistributions)) {
            case 1: return normal(section);
            case 2: {
                const double mode = section.number("mode", (from + to) / 2, NumberRule::finite);
                if (mode < from || mode > to) section.fail("mode", "'mode' must be between 'from' and 'to'");
                return Triangular{from, to, mode};
            }
            default: return Uniform{from, to};
        }
    }

    static Domain normal(TomlSection& section) {
        if (section.require("mean") == nullptr || section.require("deviation") == nullptr) return Choices{};
        return Normal{section.number("mean", 0, NumberRule::finite),
                      section.number("deviation", 0, NumberRule::not_negative)};
    }

    static Domain evenly_spaced(double from, double to, std::uint64_t steps) {
        Choices choices;
        for (std::uint64_t step = 0; step < steps; ++step)
            choices.values.emplace_back(from + (to - from) * static_cast<double>(step) /
                                                   static_cast<double>(steps - 1));
        return choices;
    }

    FirstError& error_;
    const toml::table& table_;
    TomlSection section_;
    const ResolveFile& resolve_file_;
    Setting setting_{.keys = {}, .domain = Choices{}};
};

}  // namespace

std::optional<json> scalar_value(const toml::node& node) {
    if (const auto* text = node.as_string()) return json(text->get());
    if (const auto* integer = node.as_integer()) return json(integer->get());
    if (const auto* number = node.as_floating_point(); number != nullptr && std::isfinite(number->get()))
        return json(number->get());
    if (const auto* flag = node.as_boolean()) return json(flag->get());
    return std::nullopt;
}

std::uint64_t read_integer(TomlSection& section, std::string_view key, std::uint64_t min, std::uint64_t max,
                           std::uint64_t fallback) {
    const double value = section.number(key, static_cast<double>(fallback), NumberRule::not_negative);
    if (value == std::floor(value) && value >= static_cast<double>(min) && value <= static_cast<double>(max))
        return static_cast<std::uint64_t>(value);
    section.fail(key, fmt::format("'{}' must be an integer from {} to {}", key, min, max));
    return fallback;
}

std::optional<Setting> read_setting(FirstError& error, const toml::table& table,
                                    const ResolveFile& resolve_file) {
    return SettingReader(error, table, resolve_file).read();
}

}  // namespace gsim::batch
