#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "batch/plan/plan.h"
#include "batch/plan/setting_file.h"
#include "batch/work/path_job.h"
#include "batch/work/run_options.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using base::FirstError;
using base::TomlSection;
using nlohmann::json;

// The last three belong to a search (read_search()), which the same plan may contain.
constexpr std::array<std::string_view, 11> kPlanKeys{"programs",  "machines", "controllers", "reports",
                                                     "pictures",  "options",  "sampling",    "setting",
                                                     "objective", "limit",    "search"};
constexpr std::array<std::string_view, 3> kSamplingKeys{"kind", "runs", "seed"};
constexpr std::array<std::string_view, 4> kSamplingNames{"grid", "random", "latin-hypercube", "sobol"};
constexpr std::array kSamplingKinds{Sampling::grid, Sampling::random, Sampling::latin_hypercube,
                                    Sampling::sobol};
constexpr std::uint64_t kMaxRuns = 100'000'000;

class PlanReader {
  public:
    PlanReader(std::string_view text, const std::string& file, PlanUse use)
        : use_(use),
          error_(file),
          folder_(fs::path(file).parent_path()),
          table_(base::parse_toml(error_, text)) {
        plan_.name = file;
    }

    Result<Plan> read() {
        if (!error_.text()) read_plan();
        if (error_.text()) return tl::unexpected(*error_.text());
        return std::move(plan_);
    }

  private:
    void read_plan() {
        TomlSection section(error_, table_, "the plan", kPlanKeys);
        read_programs(section);
        read_machines(section);
        plan_.stored_documents.report = section.flag("reports", false);
        plan_.stored_documents.picture = section.flag("pictures", false);
        if (const toml::table* options = section.table("options")) read_options(*options);
        if (section.has("setting")) {
            const ResolveFile resolve_file = [this](const std::string& name) {
                return this->resolve_file(name);
            };
            for (const toml::table* table : section.tables("setting")) {
                if (auto setting = read_setting(error_, *table, resolve_file))
                    plan_.settings.push_back(*std::move(setting));
            }
        }
        read_controllers(section);
        if (auto sampling = section.section("sampling", "[sampling]", kSamplingKeys))
            read_sampling(*sampling);
        check_path_options(section);
        check_design(section);
    }

    /// Reads the texts of a list, or a single text.
    std::vector<std::string> read_texts(TomlSection& section, const toml::table& table,
                                        std::string_view key) {
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
        section.fail(key, fmt::format("'{}' must be a list of strings", key));
        return {};
    }

    /// Resolves a name in the folder of the plan; a name without such a file stays a name.
    std::string resolve_file(const std::string& name) const {
        const fs::path path = folder_ / name;
        std::error_code ignored;
        return fs::exists(path, ignored) ? path.lexically_normal().string() : name;
    }

    void read_programs(TomlSection& section) {
        if (section.require("programs") == nullptr) return;
        for (const std::string& name : read_texts(section, table_, "programs")) {
            auto found = find_programs(name, folder_);
            if (!found) return section.fail("programs", found.error().message);
            add_programs(plan_, *found);
        }
    }

    void read_machines(TomlSection& section) {
        if (!section.has("machines")) return;
        plan_.machines = read_texts(section, table_, "machines");
        for (std::string& name : plan_.machines) name = resolve_file(name);
    }

    void read_options(const toml::table& options) {
        for (const auto& [key, node] : options) {
            const std::string name(key.str());
            auto value = scalar_value(node);
            if (const auto checked = check_option(name, value.value_or(json())); !checked) {
                error_.report(key.source().begin, checked.error().message);
                continue;
            }
            const bool is_file = find_option(name)->kind == RunOption::Kind::file;
            plan_.options[name] = is_file ? json(resolve_file(value->get<std::string>())) : *value;
        }
    }

    void read_controllers(TomlSection& section) {
        if (!section.has("controllers")) return;
        Choices models;
        for (const std::string& name : read_texts(section, table_, "controllers"))
            models.values.emplace_back(name);
        plan_.settings.push_back({.keys = {"machine.controller.model"}, .domain = std::move(models)});
    }

    void read_sampling(TomlSection& section) {
        plan_.design.sampling = kSamplingKinds[section.choice("kind", 0, kSamplingNames)];
        plan_.design.seed = read_integer(section, "seed", 1, kMaxRuns, 1);
        if (plan_.design.sampling == Sampling::grid) {
            if (section.has("runs"))
                section.fail(
                    "runs",
                    "a grid has one run for each combination of its values; 'runs' requires another 'kind'");
            return;
        }
        if (section.require("runs") != nullptr)
            plan_.design.runs = read_integer(section, "runs", 1, kMaxRuns, 1);
    }

    /// A search defines itself what is tried.
    void check_search(TomlSection& section) {
        if (section.has("sampling"))
            section.fail("sampling",
                         "a search selects its variants itself ([search]); [sampling] has no effect");
        if (section.has("controllers"))
            section.fail("controllers",
                         "a search supports one controller; to select among several, add a [[setting]] of "
                         "'machine.controller.model' with 'values'");
    }

    /// Options without effect are errors.
    void check_path_options(TomlSection& section) {
        if (std::any_of(plan_.programs.begin(), plan_.programs.end(), is_path_file)) return;
        for (const char* option : {"post", "path_frame", "rotary_as_given"}) {
            if (plan_.options.contains(option))
                section.fail(
                    "options",
                    fmt::format("'{}' applies to paths (.path.json, .path.lua), and no program is a path",
                                option));
        }
    }

    void check_design(TomlSection& section) {
        if (use_ == PlanUse::search) check_search(section);
        double size = 1;
        std::set<std::string> keys;
        for (const Setting& setting : plan_.settings) {
            for (const std::string& key : setting.keys) {
                if (!keys.insert(key).second)
                    return section.fail(
                        "setting",
                        fmt::format("'{}' is set twice ('controllers' is machine.controller.model)", key));
            }
            const auto* choices = std::get_if<Choices>(&setting.domain);
            if (use_ == PlanUse::batch && plan_.design.sampling == Sampling::grid && choices == nullptr)
                return section.fail("setting", fmt::format("'{}' has no list of values or steps, which a "
                                                           "grid requires; use another 'kind' of [sampling]",
                                                           setting.keys.front()));
            if (choices != nullptr && use_ == PlanUse::batch)
                size *= static_cast<double>(choices->values.size());
        }
        if (plan_.design.sampling != Sampling::grid) size = static_cast<double>(plan_.design.runs);
        size *= static_cast<double>(plan_.programs.size() * plan_.machines.size());
        const double values = plan_.design.sampling == Sampling::grid
                                  ? 0
                                  : static_cast<double>(plan_.design.runs * plan_.settings.size());
        if (values > static_cast<double>(kMaxRuns))
            section.fail("setting", fmt::format("the settings have {:.3g} values; at most {} are supported",
                                                values, kMaxRuns));
        if (size > static_cast<double>(kMaxRuns))
            section.fail("setting",
                         fmt::format("the plan has {:.3g} runs; at most {} are supported", size, kMaxRuns));
    }

    PlanUse use_;
    FirstError error_;
    fs::path folder_;
    toml::table table_;
    Plan plan_;
};

}  // namespace

Result<Plan> read_plan(std::string_view toml_text, const std::string& file_name, PlanUse use) {
    return PlanReader(toml_text, file_name, use).read();
}

}  // namespace gsim::batch
