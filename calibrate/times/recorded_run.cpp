#include "calibrate/times/recorded_run.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "calibrate/text/list.h"
#include "calibrate/times/passages.h"

namespace gsim::calibrate {

namespace {

/// Columns of a list.
struct Columns {
    std::size_t program = 0;
    std::optional<std::size_t> time;
    std::optional<std::size_t> record;
    std::string ending;  ///< Ending that names of programs lack.

    std::size_t last() const { return std::max({program, time.value_or(0), record.value_or(0)}); }
};

tl::expected<Columns, std::string> columns_of(const Cells& heading) {
    struct Names {
        std::string_view program, time, ending;
    };
    for (const auto& [program, time, ending] :
         {Names{"program", "time_s", ""}, Names{"name", "cycle_time_s", ".ngc"}}) {
        const auto at = column_of(heading, program), when = column_of(heading, time);
        const auto record = column_of(heading, "record");
        if (at && (when || record)) return Columns{*at, when, record, std::string(ending)};
    }
    return tl::unexpected<std::string>(
        "line 1: it should name the columns, 'program' and 'time_s' (or 'record') among them");
}

tl::expected<RecordedRun, std::string> run_in(const Cells& cells, const Columns& columns,
                                              const std::string& folder) {
    if (cells.size() <= columns.last()) return tl::unexpected<std::string>("a column is missing");
    if (cells[columns.program].empty())
        return tl::unexpected<std::string>("the name of the program is missing");
    const std::string_view time = columns.time ? cells[*columns.time] : "";
    const std::string_view record = columns.record ? cells[*columns.record] : "";
    const auto from_folder = [&](const std::string& name) {
        return name.starts_with('/') || folder.empty() ? name : folder + "/" + name;
    };
    RecordedRun run;
    run.program = from_folder(std::string(cells[columns.program]) + columns.ending);
    if (!record.empty()) run.record = from_folder(std::string(record));
    if (time.empty() && !record.empty()) return run;
    run.time_s = number_in(time).value_or(0);
    if (!(run.time_s > 0)) return tl::unexpected(fmt::format("'{}' should be a time above 0 s", time));
    return run;
}

}  // namespace

tl::expected<std::vector<RecordedRun>, std::string> read_recorded_runs(std::string_view list,
                                                                       const std::string& folder) {
    std::vector<RecordedRun> runs;
    Columns columns;
    const auto heading = [&](const Cells& cells) {
        return columns_of(cells).map([&](Columns found) { columns = std::move(found); });
    };
    const auto row = [&](const Cells& cells) {
        return run_in(cells, columns, folder).map([&](RecordedRun run) { runs.push_back(std::move(run)); });
    };
    return read_list(list, heading, row).map([&] { return std::move(runs); });
}

std::vector<RecordedRun> runs_at(std::span<const RecordedRun> runs, std::span<const std::size_t> places) {
    std::vector<RecordedRun> chosen;
    for (const std::size_t place : places) chosen.push_back(runs[place]);
    return chosen;
}

tl::expected<void, std::string> add_record(std::string_view text, const RecordForm& form, RecordedRun& run) {
    auto samples = read_motion_record(text, form);
    if (!samples) return tl::unexpected(samples.error());
    const auto span = motion_span(*samples);
    if (!span) return tl::unexpected<std::string>("nothing moves in it");
    run.samples = *std::move(samples);
    if (!(run.time_s > 0)) run.time_s = span->end_s - span->start_s;
    return {};
}

}  // namespace gsim::calibrate
