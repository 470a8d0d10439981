#include "batch/store/searches.h"

namespace gsim::batch {

namespace {

constexpr const char* kSqlNow = "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')";

}  // namespace

Result<std::int64_t> begin_search(Database& results, const std::string& plan, const std::string& objective,
                                  std::uint64_t seed) {
    auto add = results.prepare(
        std::string("INSERT INTO search (plan, objective, seed, began_at) VALUES (?, ?, ?, ") + kSqlNow +
        ") RETURNING id");
    if (!add) return Unexpected(add.error());
    add->bind(1, plan).bind(2, objective).bind(3, static_cast<std::int64_t>(seed));
    const auto row = add->step();
    if (!row) return Unexpected(row.error());
    const std::int64_t search = add->integer(0);
    return add->run().map([&] { return search; });
}

Result<void> add_trials(Database& results, std::int64_t search, std::span<const TrialRow> rows) {
    auto add = results.prepare(
        "INSERT OR IGNORE INTO search_run (search, number, run, generation, value, violation) VALUES (?, ?, "
        "?, ?, ?, "
        "?)");
    if (!add) return Unexpected(add.error());
    if (auto begun = results.execute("BEGIN IMMEDIATE"); !begun) return begun;
    for (const TrialRow& row : rows) {
        add->bind(1, search)
            .bind(2, static_cast<std::int64_t>(row.number))
            .bind(3, row.run)
            .bind(4, static_cast<std::int64_t>(row.generation))
            .bind(5, row.value)
            .bind(6, std::optional(row.violation));
        if (auto done = add->run(); !done) {
            static_cast<void>(results.execute("ROLLBACK"));
            return done;
        }
    }
    return results.execute("COMMIT");
}

Result<void> end_search(Database& results, std::int64_t search, std::uint64_t best) {
    auto end =
        results.prepare(std::string("UPDATE search SET ended_at = ") + kSqlNow + ", best = ? WHERE id = ?");
    if (!end) return Unexpected(end.error());
    end->bind(1, static_cast<std::int64_t>(best)).bind(2, search);
    return end->run();
}

}  // namespace gsim::batch
