#include "calibrate/times/recorded_run.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "calibrate/text/list.h"
#include "calibrate/times/passage_times.h"

namespace gsim::calibrate {

namespace {

/// Columns of a list.
struct Columns {
    std::size_t program = 0;
    std::optional<std::size_t> time;
    std::optional<std::size_t> record;
    std::string extension;  ///< Ending that names of programs lack.

    std::size_t last() const { return std::max({program, time.value_or(0), record.value_or(0)}); }
};

Result<Columns> find_columns(const Cells& heading) {
    struct Names {
        std::string_view program, time, extension;
    };
    for (const auto& [program, time, extension] :
         {Names{"program", "time_s", ""}, Names{"name", "cycle_time_s", ".ngc"}}) {
        const auto at = find_column(heading, program), time_column = find_column(heading, time);
        const auto record = find_column(heading, "record");
        if (at && (time_column || record)) return Columns{*at, time_column, record, std::string(extension)};
    }
    return Unexpected("line 1: it must name the columns, including 'program' and 'time_s' (or 'record')");
}

Result<RecordedRun> parse_run(const Cells& cells, const Columns& columns, const std::string& folder) {
    if (cells.size() <= columns.last()) return Unexpected("a column is missing");
    if (cells[columns.program].empty()) return Unexpected("the name of the program is missing");
    const std::string_view time = columns.time ? cells[*columns.time] : "";
    const std::string_view record = columns.record ? cells[*columns.record] : "";
    const auto in_folder = [&](const std::string& name) {
        return name.starts_with('/') || folder.empty() ? name : folder + "/" + name;
    };
    RecordedRun run;
    run.program = in_folder(std::string(cells[columns.program]) + columns.extension);
    if (!record.empty()) run.record = in_folder(std::string(record));
    if (time.empty() && !record.empty()) return run;
    run.time_s = parse_number(time).value_or(0);
    if (!(run.time_s > 0)) return Unexpected(fmt::format("'{}' must be a time greater than 0 s", time));
    return run;
}

}  // namespace

Result<std::vector<RecordedRun>> read_recorded_runs(std::string_view list, const std::string& folder) {
    std::vector<RecordedRun> runs;
    Columns columns;
    const auto heading = [&](const Cells& cells) {
        return find_columns(cells).map([&](Columns found) { columns = std::move(found); });
    };
    const auto row = [&](const Cells& cells) {
        return parse_run(cells, columns, folder).map([&](RecordedRun run) {
            runs.push_back(std::move(run));
        });
    };
    return read_list(list, heading, row).map([&] { return std::move(runs); });
}

std::vector<RecordedRun> select_runs(std::span<const RecordedRun> runs,
                                     std::span<const std::size_t> indices) {
    std::vector<RecordedRun> selected;
    for (const std::size_t index : indices) selected.push_back(runs[index]);
    return selected;
}

Result<void> add_record(std::string_view text, const RecordFormat& record_format, RecordedRun& run) {
    auto samples = read_motion_record(text, record_format);
    if (!samples) return tl::unexpected(samples.error());
    const auto span = motion_span(*samples);
    if (!span) return Unexpected("it contains no motion");
    run.samples = *std::move(samples);
    if (!(run.time_s > 0)) run.time_s = span->end_s - span->start_s;
    return {};
}

}  // namespace gsim::calibrate
