#include <algorithm>
#include <array>
#include <variant>

#include <fmt/format.h>

#include "batch/plan/setting_file.h"
#include "batch/search/metrics.h"
#include "batch/search/search_plan.h"

namespace gsim::batch {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;

constexpr std::array<std::string_view, 4> kSearchKeys{"variants", "first", "population", "seed"};
constexpr std::array<std::string_view, 3> kLimitKeys{"metric", "min", "max"};
constexpr std::uint64_t kMaxVariants = 10'000'000;

class SearchReader {
  public:
    SearchReader(std::string_view text, const std::string& file, Plan plan)
        : error_(file), table_(base::parse_toml(error_, text)) {
        search_.plan = std::move(plan);
    }

    Result<SearchPlan> read() {
        read_objective();
        read_limits();
        read_search();
        check_settings();
        add_options();
        if (error_.text()) return tl::unexpected(*error_.text());
        search_.warnings = error_.warnings();
        return std::move(search_);
    }

  private:
    void fail(std::string_view key, const std::string& message) {
        const toml::node* node = table_.get(key);
        error_.report(node != nullptr ? node->source().begin : table_.source().begin, message);
    }

    void read_objective() {
        const toml::table* objective = table_["objective"].as_table();
        if (objective == nullptr || objective->empty())
            return fail("objective",
                        "a search requires [objective]: metrics and their weights, as in 'cycle_time_s = 1'");
        TomlSection section(error_, *objective, "[objective]", kMetrics);
        for (const auto& [key, node] : *objective) {
            const double weight = section.number(key.str(), 1, NumberRule::finite);
            if (weight == 0) section.fail(key.str(), "a weight of 0 has no effect");
            const std::string_view metric = base::renamed_key(section.title(), key.str()).value_or(key.str());
            search_.objective.push_back({std::string(metric), weight});
        }
    }

    void read_limits() {
        if (!table_.contains("limit")) return;
        const toml::array* list = table_["limit"].as_array();
        if (list == nullptr || !list->is_homogeneous(toml::node_type::table))
            return fail("limit", "'limit' must be an array of tables, each under [[limit]]");
        for (const toml::node& node : *list) {
            TomlSection section(error_, *node.as_table(), "[[limit]]", kLimitKeys);
            if (section.require("metric") == nullptr) continue;
            MetricLimit limit{.metric = std::string(read_metric(section))};
            if (section.has("min")) limit.min = section.number("min", 0, NumberRule::finite);
            if (section.has("max")) limit.max = section.number("max", 0, NumberRule::finite);
            if (!limit.min && !limit.max) section.fail("metric", "[[limit]] must have 'min', 'max' or both");
            if (limit.min && limit.max && *limit.min > *limit.max)
                section.fail("max", "'max' must not be less than 'min'");
            search_.limits.push_back(std::move(limit));
        }
    }

    /// Returns the value of 'metric', which may be the name of before.
    std::string_view read_metric(TomlSection& section) {
        const auto name = section.find("metric")->value<std::string_view>();
        const auto new_name = name ? base::renamed_key("[objective]", *name) : std::nullopt;
        if (!new_name) return kMetrics[section.choice("metric", 0, kMetrics)];
        error_.warn(section.where("metric"), base::deprecated_key_text(*name, *new_name));
        return *new_name;
    }

    void read_search() {
        const toml::table* table = table_["search"].as_table();
        if (table == nullptr) {
            if (table_.contains("search")) fail("search", "'search' must be a table");
            return;
        }
        TomlSection section(error_, *table, "[search]", kSearchKeys);
        search_.variants = read_integer(section, "variants", 1, kMaxVariants, search_.variants);
        search_.seed = read_integer(section, "seed", 1, kMaxVariants, search_.seed);
        if (section.has("first")) search_.first = read_integer(section, "first", 1, kMaxVariants, 1);
        if (section.has("population"))
            search_.population = read_integer(section, "population", 4, kMaxVariants, 4);
    }

    void check_settings() {
        if (search_.plan.settings.empty())
            return fail("setting",
                        "a search requires [[setting]]: the settings that may change, and their bounds");
        for (const Setting& setting : search_.plan.settings) {
            if (std::holds_alternative<Normal>(setting.domain) ||
                std::holds_alternative<Triangular>(setting.domain))
                fail("setting",
                     fmt::format(
                         "'{}': a search supports 'from' and 'to', 'values' or 'orders', not a distribution",
                         setting.keys.front()));
        }
    }

    bool needs(std::string_view metric) const {
        const auto matches_metric = [&](const auto& each) { return each.metric == metric; };
        return std::any_of(search_.objective.begin(), search_.objective.end(), matches_metric) ||
               std::any_of(search_.limits.begin(), search_.limits.end(), matches_metric);
    }

    /// Adds the options without which runs do not have the metrics.
    void add_options() {
        if (needs("joint_speed_share")) search_.plan.options["joint_speeds"] = true;
        if (needs("lower_bound_s")) search_.plan.options["lower_bound"] = true;
    }

    FirstError error_;
    toml::table table_;
    SearchPlan search_;
};

}  // namespace

Result<SearchPlan> read_search(std::string_view toml_text, const std::string& file_name) {
    return read_plan(toml_text, file_name, PlanUse::search).and_then([&](Plan plan) {
        return SearchReader(toml_text, file_name, std::move(plan)).read();
    });
}

}  // namespace gsim::batch
