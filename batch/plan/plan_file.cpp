#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <set>

#include <fmt/format.h>

#include "base/toml/toml_section.h"
#include "batch/plan/plan.h"
#include "batch/work/edits.h"
#include "batch/work/run_options.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using nlohmann::json;

constexpr std::array<std::string_view, 7> kPlanKeys{"programs", "machines", "controllers", "reports",
                                                    "options",  "sampling", "setting"};
constexpr std::array<std::string_view, 3> kSamplingKeys{"kind", "runs", "seed"};
constexpr std::array<std::string_view, 4> kSamplings{"grid", "random", "latin-hypercube", "sobol"};
constexpr std::array<std::string_view, 10> kSettingKeys{
    "key", "values", "from", "to", "steps", "distribution", "mean", "mode", "deviation", "scale"};
constexpr std::array<std::string_view, 3> kDistributions{"uniform", "normal", "triangular"};
constexpr std::uint64_t kMostSteps = 100'000;
constexpr std::uint64_t kMostRuns = 100'000'000;

/// A plain value as JSON; nothing where it is none.
std::optional<json> plain(const toml::node& node) {
    if (const auto* text = node.as_string()) return json(text->get());
    if (const auto* whole = node.as_integer()) return json(whole->get());
    if (const auto* number = node.as_floating_point(); number != nullptr && std::isfinite(number->get()))
        return json(number->get());
    if (const auto* flag = node.as_boolean()) return json(flag->get());
    return std::nullopt;
}

class PlanReader {
  public:
    PlanReader(std::string_view text, const std::string& file)
        : error_(file), folder_(fs::path(file).parent_path()), table_(base::parse_toml(error_, text)) {
        plan_.name = file;
    }

    tl::expected<Plan, std::string> read() {
        if (!error_.text()) read_plan();
        if (error_.text()) return tl::unexpected(*error_.text());
        return std::move(plan_);
    }

  private:
    void read_plan() {
        TomlSection section(error_, table_, "the plan", kPlanKeys);
        read_programs(section);
        read_machines(section);
        plan_.keeps_reports = section.flag("reports", false);
        if (const toml::table* options = section.table("options")) read_options(*options);
        if (section.has("setting")) {
            for (const toml::table* setting : section.tables("setting")) read_setting(*setting);
        }
        read_controllers(section);
        if (auto sampling = section.section("sampling", "[sampling]", kSamplingKeys))
            read_sampling(*sampling);
        check_design(section);
    }

    /// The texts of a list, or one by itself.
    std::vector<std::string> texts(TomlSection& section, const toml::table& table, std::string_view key) {
        std::vector<std::string> found;
        const toml::node* node = table.get(key);
        if (node == nullptr) return found;
        if (const auto* one = node->as_string()) return {one->get()};
        if (const toml::array* list = node->as_array()) {
            for (const toml::node& each : *list) {
                if (const auto* text = each.as_string()) found.push_back(text->get());
            }
            if (found.size() == list->size() && !found.empty()) return found;
        }
        section.fail(key, fmt::format("'{}' must be a list of texts", key));
        return {};
    }

    /// From the folder of the plan; a name that is no file there stays one.
    std::string file_of(const std::string& name) const {
        const fs::path path = folder_ / name;
        std::error_code ignored;
        return fs::exists(path, ignored) ? path.lexically_normal().string() : name;
    }

    void read_programs(TomlSection& section) {
        if (section.require("programs") == nullptr) return;
        for (const std::string& name : texts(section, table_, "programs")) {
            auto found = find_programs(name, folder_);
            if (!found) return section.fail("programs", found.error());
            add_programs(plan_, *found);
        }
    }

    void read_machines(TomlSection& section) {
        if (!section.has("machines")) return;
        plan_.machines = texts(section, table_, "machines");
        for (std::string& name : plan_.machines) name = file_of(name);
    }

    void read_options(const toml::table& options) {
        for (const auto& [key, node] : options) {
            const std::string name(key.str());
            auto value = plain(node);
            if (const auto checked = check_option(name, value.value_or(json())); !checked) {
                error_.report(key.source().begin, checked.error());
                continue;
            }
            const bool is_file = find_option(name)->kind == RunOption::Kind::file;
            plan_.options[name] = is_file ? json(file_of(value->get<std::string>())) : *value;
        }
    }

    void read_controllers(TomlSection& section) {
        if (!section.has("controllers")) return;
        Choices models;
        for (const std::string& name : texts(section, table_, "controllers"))
            models.values.emplace_back(name);
        plan_.settings.push_back({.key = "machine.controller.model", .domain = std::move(models)});
    }

    void read_sampling(TomlSection& section) {
        plan_.design.sampling = static_cast<Sampling>(section.choice("kind", 0, kSamplings));
        plan_.design.seed = whole(section, "seed", 1, kMostRuns, 1);
        if (plan_.design.sampling == Sampling::grid) {
            if (section.has("runs"))
                section.fail("runs",
                             "a grid has as many runs as its values make; 'runs' is of another 'kind'");
            return;
        }
        if (section.require("runs") != nullptr) plan_.design.runs = whole(section, "runs", 1, kMostRuns, 1);
    }

    std::uint64_t whole(TomlSection& section, std::string_view key, std::uint64_t least, std::uint64_t most,
                        std::uint64_t fallback) {
        const double value = section.number(key, static_cast<double>(fallback), NumberRule::not_negative);
        if (value == std::floor(value) && value >= static_cast<double>(least) &&
            value <= static_cast<double>(most))
            return static_cast<std::uint64_t>(value);
        section.fail(key, fmt::format("'{}' must be a whole number from {} to {}", key, least, most));
        return fallback;
    }

    void read_setting(const toml::table& table) {
        TomlSection section(error_, table, "[[setting]]", kSettingKeys);
        Setting setting{
            .key = section.text("key"), .domain = Choices{}, .is_factor = section.flag("scale", false)};
        if (setting.key.empty()) return;
        if (const std::string fault = fault_of_key(setting.key); !fault.empty())
            return section.fail("key", fault);
        if (setting.is_factor && !setting.key.starts_with(kOfMachine) && !setting.key.starts_with(kOfCell))
            return section.fail("scale", "factors are of values that a machine or cell file has");
        const bool has_values = section.has("values");
        if (has_values == section.has("from") && !(section.has("distribution") && !has_values))
            return section.fail("key", "[[setting]] has 'values', or 'from' and 'to', or a 'distribution'");
        refuse_unused(section, has_values);
        if (!has_values && setting.key.starts_with(kOfRun)) {
            if (const auto checked = check_option(setting.key.substr(kOfRun.size()), 1.5); !checked)
                return section.fail("key", checked.error());
        }
        setting.domain = has_values ? Domain(values(section, table, setting)) : numbers(section);
        plan_.settings.push_back(std::move(setting));
    }

    /// Keys that say nothing beside the others.
    static void refuse_unused(TomlSection& section, bool has_values) {
        const auto refuse = [&](std::initializer_list<const char*> keys, const char* beside) {
            for (const char* key : keys) {
                if (section.has(key))
                    section.fail(key, fmt::format("'{}' says nothing beside {}", key, beside));
            }
        };
        if (has_values)
            return refuse({"from", "to", "steps", "distribution", "mean", "mode", "deviation"}, "'values'");
        if (section.has("steps")) return refuse({"distribution", "mean", "mode", "deviation"}, "'steps'");
        const std::size_t distribution = section.choice("distribution", 0, kDistributions);
        if (distribution == 1) return refuse({"from", "to", "mode"}, "'normal'");
        refuse({"mean", "deviation"}, "'from' and 'to'");
        if (distribution == 0) refuse({"mode"}, "'uniform'");
        section.require("from");
        section.require("to");
    }

    Choices values(TomlSection& section, const toml::table& table, const Setting& setting) {
        Choices choices;
        const toml::array* list = table.get("values")->as_array();
        if (list == nullptr || list->empty()) {
            section.fail("values", "'values' must be a list of one at least");
            return choices;
        }
        for (const toml::node& node : *list) {
            auto value = plain(node);
            if (!value || (setting.is_factor && !value->is_number())) {
                error_.report(node.source().begin,
                              setting.is_factor ? "a factor must be a number"
                                                : "a value must be a number, a text, or true or false");
                continue;
            }
            if (const std::string name = setting.key.substr(kOfRun.size()); setting.key.starts_with(kOfRun)) {
                if (const auto checked = check_option(name, *value); !checked)
                    error_.report(node.source().begin, checked.error());
            }
            const RunOption* option =
                setting.key.starts_with(kOfRun) ? find_option(setting.key.substr(kOfRun.size())) : nullptr;
            if (option != nullptr && option->kind == RunOption::Kind::file && value->is_string())
                value = file_of(value->get<std::string>());
            choices.values.push_back(*std::move(value));
        }
        return choices;
    }

    Domain numbers(TomlSection& section) {
        const double from = section.number("from", 0, NumberRule::finite);
        const double to = section.number("to", from, NumberRule::finite);
        if (section.has("from") && section.require("to") == nullptr) return Choices{};
        if (to < from) section.fail("to", "'to' must not be less than 'from'");
        if (section.has("steps")) return even(from, to, whole(section, "steps", 2, kMostSteps, 2));
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

    static Domain even(double from, double to, std::uint64_t steps) {
        Choices choices;
        for (std::uint64_t step = 0; step < steps; ++step)
            choices.values.emplace_back(from + (to - from) * static_cast<double>(step) /
                                                   static_cast<double>(steps - 1));
        return choices;
    }

    void check_design(TomlSection& section) {
        double size = 1;
        std::set<std::string> keys;
        for (const Setting& setting : plan_.settings) {
            if (!keys.insert(setting.key).second)
                return section.fail(
                    "setting", fmt::format("'{}' is set twice ('controllers' is machine.controller.model)",
                                           setting.key));
            const auto* choices = std::get_if<Choices>(&setting.domain);
            if (plan_.design.sampling == Sampling::grid && choices == nullptr)
                return section.fail(
                    "setting",
                    fmt::format("'{}' has no list of values or steps, as a grid needs; take another "
                                "'kind' of [sampling]",
                                setting.key));
            if (choices != nullptr) size *= static_cast<double>(choices->values.size());
        }
        if (plan_.design.sampling != Sampling::grid) size = static_cast<double>(plan_.design.runs);
        size *= static_cast<double>(plan_.programs.size() * plan_.machines.size());
        const double values = plan_.design.sampling == Sampling::grid
                                  ? 0
                                  : static_cast<double>(plan_.design.runs * plan_.settings.size());
        if (values > static_cast<double>(kMostRuns))
            section.fail("setting",
                         fmt::format("these are {:.3g} values of settings; {} may be", values, kMostRuns));
        if (size > static_cast<double>(kMostRuns))
            section.fail("setting", fmt::format("these are {:.3g} runs; {} may be", size, kMostRuns));
    }

    FirstError error_;
    fs::path folder_;
    toml::table table_;
    Plan plan_;
};

}  // namespace

tl::expected<Plan, std::string> read_plan(std::string_view toml_text, const std::string& file_name) {
    return PlanReader(toml_text, file_name).read();
}

}  // namespace gsim::batch
