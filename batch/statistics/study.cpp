#include "batch/statistics/study.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::batch {

namespace {

using nlohmann::json;

struct Run {
    std::string status, cause;
    json settings;
    double time_s = 0;

    bool is_clean() const { return status == "completed" && cause.empty(); }
};

using Runs = std::vector<Run>;

/// Returns runs by program and machine, in the order of their jobs.
Result<std::map<std::pair<std::string, std::string>, Runs>> read_runs(Database& results) {
    auto rows = results.prepare("SELECT program, machine, status, cause, settings, cycle_time_s FROM latest");
    if (!rows) return Unexpected(rows.error());
    std::map<std::pair<std::string, std::string>, Runs> runs;
    while (true) {
        const auto row = rows->step();
        if (!row) return Unexpected(row.error());
        if (!*row) return runs;
        runs[{std::string(rows->text(0)), std::string(rows->text(1))}].push_back(
            {std::string(rows->text(2)), std::string(rows->text(3)),
             text::try_parse_json<json>(std::string(rows->text(4))), rows->number(5)});
    }
}

/// Returns a setting as a number: a number itself, a factor ("x 1.1") or an addend ("+ 1.1").
std::optional<double> setting_number(const json& value) {
    if (value.is_number()) return value.get<double>();
    if (value.is_boolean()) return value.get<bool>() ? 1.0 : 0.0;
    const auto* text = value.get_ptr<const std::string*>();
    if (text == nullptr || (!text->starts_with("x ") && !text->starts_with("+ "))) return std::nullopt;
    const json factor = text::try_parse_json<json>(text->substr(2));
    return factor.is_number() ? std::optional(factor.get<double>()) : std::nullopt;
}

Sensitivity compute_sensitivity(const Runs& completed) {
    std::map<std::string, std::vector<double>> columns;
    std::vector<double> times_s;
    for (const Run& run : completed) {
        times_s.push_back(run.time_s);
        for (const auto& [name, value] : run.settings.items()) {
            if (const auto number = setting_number(value)) columns[name].push_back(*number);
        }
    }
    std::vector<std::string> names;
    std::vector<std::vector<double>> settings;
    for (auto& [name, column] : columns) {
        if (column.size() != times_s.size()) continue;  // a text in some of them
        // Keys that get the same values are one setting.
        if (const auto same = std::find(settings.begin(), settings.end(), column); same != settings.end()) {
            names[static_cast<std::size_t>(same - settings.begin())] += " = " + name;
            continue;
        }
        names.push_back(name);
        settings.push_back(std::move(column));
    }
    return regress(names, settings, times_s);
}

Study make_study(const std::string& program, const std::string& machine, const Runs& runs) {
    Study study{.program = program, .machine = machine, .runs = runs.size()};
    std::map<std::string, std::uint64_t> causes;
    Runs completed;
    for (const Run& run : runs) {
        if (!run.is_clean()) {
            ++study.failed;
            ++causes[run.cause.empty() ? run.status : run.cause];
        }
        // A run past limits or with a collision has a time as well.
        if (run.status == "completed" || run.status == "violations") completed.push_back(run);
    }
    study.failed_share = proportion_interval(study.failed, study.runs);
    study.causes.assign(causes.begin(), causes.end());
    std::sort(study.causes.begin(), study.causes.end(),
              [](const auto& a, const auto& b) { return a.second > b.second; });
    for (const Run& run : completed) study.times_s.push_back(run.time_s);
    if (!study.times_s.empty()) study.time = summarize(study.times_s);
    study.sensitivity = compute_sensitivity(completed);
    return study;
}

/// Numbers the runs of a source among those with equal inputs, so that copies are paired one by one.
std::string numbered_query(std::string_view source) {
    return fmt::format(
        "(SELECT program, machine, options, settings, status, cause, cycle_time_s, row_number() OVER "
        "(PARTITION "
        "BY program, machine, options, settings ORDER BY job) AS place FROM {})",
        source);
}

std::string pairs_query(std::string_view first, std::string_view second, std::string_view condition) {
    return fmt::format(
        "SELECT a.status = 'completed' AND a.cause = '', b.status = 'completed' AND b.cause = '', "
        "a.cycle_time_s, b.cycle_time_s FROM {} a JOIN {} b ON a.program = b.program AND a.settings = "
        "b.settings "
        "AND a.place = b.place AND {}",
        numbered_query(first), numbered_query(second), condition);
}

Result<Comparison> compare(Statement& pairs, std::string first, std::string second) {
    Comparison comparison{.first = std::move(first), .second = std::move(second)};
    std::vector<double> differences_s;
    while (true) {
        const auto row = pairs.step();
        if (!row) return Unexpected(row.error());
        if (!*row) break;
        ++comparison.pairs;
        const bool first_is_clean = pairs.integer(0) != 0, second_is_clean = pairs.integer(1) != 0;
        comparison.fails_first += !first_is_clean && second_is_clean ? 1 : 0;
        comparison.fails_second += first_is_clean && !second_is_clean ? 1 : 0;
        if (!first_is_clean || !second_is_clean) continue;
        const double difference_s = pairs.number(3) - pairs.number(2);
        comparison.faster += difference_s < 0 ? 1 : 0;
        comparison.slower += difference_s > 0 ? 1 : 0;
        comparison.first_s += pairs.number(2);
        comparison.second_s += pairs.number(3);
        differences_s.push_back(difference_s);
    }
    if (!differences_s.empty()) comparison.difference_s = summarize(std::move(differences_s));
    return comparison;
}

}  // namespace

Result<std::vector<Study>> read_studies(Database& results) {
    return read_runs(results).map([](const auto& all) {
        std::vector<Study> studies;
        for (const auto& [names, runs] : all) {
            if (runs.size() > 1) studies.push_back(make_study(names.first, names.second, runs));
        }
        return studies;
    });
}

Result<std::vector<Comparison>> compare_machines(Database& results) {
    auto machines = results.prepare("SELECT machine FROM latest GROUP BY machine ORDER BY min(job)");
    if (!machines) return Unexpected(machines.error());
    std::vector<std::string> names;
    while (true) {
        const auto row = machines->step();
        if (!row) return Unexpected(row.error());
        if (!*row) break;
        names.emplace_back(machines->text(0));
    }
    std::vector<Comparison> comparisons;
    for (std::size_t i = 1; i < names.size(); ++i) {
        auto pairs = results.prepare(
            pairs_query("latest", "latest", "a.options = b.options AND a.machine = ? AND b.machine = ?"));
        if (!pairs) return Unexpected(pairs.error());
        pairs->bind(1, names[0]).bind(2, names[i]);
        auto comparison = compare(*pairs, names[0], names[i]);
        if (!comparison) return Unexpected(comparison.error());
        comparisons.push_back(*std::move(comparison));
    }
    return comparisons;
}

Result<Comparison> compare_batches(Database& results, std::int64_t before) {
    auto batches = results.prepare(
        "SELECT max(id), coalesce(?, (SELECT max(id) FROM batch WHERE id < (SELECT max(id) FROM batch))) "
        "FROM batch");
    if (!batches) return Unexpected(batches.error());
    if (before > 0) {
        batches->bind(1, before);
    } else {
        batches->bind_null(1);
    }
    if (const auto row = batches->step(); !row || !*row)
        return Unexpected(row ? fmt::format("'{}' contains no batch", results.file()) : row.error().message);
    const std::int64_t latest = batches->integer(0), other = batches->integer(1);
    if (other <= 0 || other >= latest)
        return Unexpected(fmt::format("'{}' contains no earlier batch to compare with", results.file()));
    // The same program on the same machine is compared, even if their texts have changed.
    auto pairs =
        results.prepare(pairs_query("(SELECT run.*, batch_run.job FROM batch_run JOIN run ON run.id = "
                                    "batch_run.run WHERE batch_run.batch = ?)",
                                    "latest", "a.machine = b.machine"));
    if (!pairs) return Unexpected(pairs.error());
    pairs->bind(1, other);
    return compare(*pairs, fmt::format("batch {}", other), fmt::format("batch {}", latest));
}

}  // namespace gsim::batch
