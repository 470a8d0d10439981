#include "batch/pages/run_history.h"

#include <utility>

#include <fmt/format.h>

namespace gsim::batch {

namespace {

std::optional<double> optional_number(const Statement& row, int column) {
    return row.is_null(column) ? std::nullopt : std::optional(row.number(column));
}

RunDetails run_details_from_row(const Statement& row) {
    const auto text = [&](int column) { return std::string(row.text(column)); };
    return {
        .key = text(23),
        .program = text(0),
        .machine = text(1),
        .program_sha256 = text(2),
        .machine_sha256 = text(3),
        .machine_name = text(4),
        .controller = text(5),
        .version = text(6),
        .run_at = text(7),
        .options = text(8),
        .settings = text(9),
        .extents = text(10),
        .findings = text(11),
        .energy_j = optional_number(row, 14),
        .times = {.min_s = optional_number(row, 12),
                  .max_s = optional_number(row, 13),
                  .rapid_s = row.number(15),
                  .feed_s = row.number(16),
                  .dwell_s = row.number(17)},
        .distances = {.rapid_mm = row.number(18), .feed_mm = row.number(19), .process_on_mm = row.number(20)},
        .counts = {.blocks = static_cast<std::uint64_t>(row.integer(21)),
                   .moves = static_cast<std::uint64_t>(row.integer(22))}};
}

}  // namespace

Result<RunHistory> RunHistory::open(Database& results) {
    auto run = results.prepare(
        "SELECT program, machine, program_sha256, machine_sha256, machine_name, controller, version, ran_at, "
        "options, settings, extents, findings, cycle_time_min_s, cycle_time_max_s, energy_j, rapid_s, "
        "feed_s, dwell_s, "
        "rapid_mm, "
        "feed_mm, process_on_mm, blocks, moves, key FROM run WHERE id = ?");
    if (!run) return tl::unexpected(run.error());
    auto files = results.prepare(
        "SELECT file, sha256 FROM run_input JOIN input ON input.id = run_input.input WHERE run = ? ORDER BY "
        "file");
    if (!files) return tl::unexpected(files.error());
    auto picture = results.prepare("SELECT svg FROM picture WHERE run = ?");
    if (!picture) return tl::unexpected(picture.error());
    return RunHistory(*std::move(run), *std::move(files), *std::move(picture));
}

Result<RunDetails> RunHistory::read(std::int64_t run) {
    run_.bind(1, run);
    const auto row = run_.step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return Unexpected(fmt::format("run {} is not in the results", run));
    RunDetails complete = run_details_from_row(run_);
    if (const auto done = run_.run(); !done) return tl::unexpected(done.error());
    picture_.bind(1, run);
    const auto picture = picture_.step();
    if (!picture) return tl::unexpected(picture.error());
    if (*picture) complete.picture_svg = picture_.text(0);
    if (const auto done = picture_.run(); !done) return tl::unexpected(done.error());
    files_.bind(1, run);
    while (true) {
        const auto file = files_.step();
        if (!file) return tl::unexpected(file.error());
        if (!*file) return complete;
        complete.files.push_back({std::string(files_.text(0)), std::string(files_.text(1))});
    }
}

}  // namespace gsim::batch
