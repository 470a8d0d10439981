#include "batch/work/run_row.h"

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::batch {

using nlohmann::json;

namespace {

json optional_json(std::optional<double> value) {
    return value ? json(*value) : json();
}

std::optional<double> parse_optional(const json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

/// Calls `take(name, member)` for each member that is a text, a number or a count.
template <typename Row, typename Visitor>
void for_each_row_field(Row& row, const Visitor& on_field) {
    on_field("number", row.number);
    on_field("status", row.outcome.status);
    on_field("cause", row.outcome.cause);
    on_field("message", row.outcome.message);
    on_field("file", row.outcome.file);
    on_field("line", row.outcome.line);
    on_field("machine", row.machine);
    on_field("controller", row.controller);
    on_field("cycle_time_s", row.times.cycle_s);
    on_field("rapid_s", row.times.rapid_s);
    on_field("feed_s", row.times.feed_s);
    on_field("dwell_s", row.times.dwell_s);
    on_field("rapid_mm", row.distances.rapid_mm);
    on_field("feed_mm", row.distances.feed_mm);
    on_field("process_on_mm", row.distances.process_on_mm);
    on_field("blocks", row.counts.blocks);
    on_field("moves", row.counts.moves);
    on_field("violations", row.counts.violations);
    on_field("collisions", row.counts.collisions);
    on_field("process_findings", row.counts.process_findings);
    on_field("warnings", row.counts.warnings);
    on_field("extents", row.extents);
    on_field("findings", row.findings);
    on_field("cpu_s", row.cpu_s);
    on_field("report", row.documents.report);
    on_field("picture", row.documents.picture);
    on_field("picture_error", row.documents.picture_error);
}

/// Does the same for those that may be missing.
template <typename Row, typename Visitor>
void for_each_optional(Row& row, const Visitor& on_field) {
    on_field("cycle_time_min_s", row.times.min_s);
    on_field("cycle_time_max_s", row.times.max_s);
    on_field("energy_j", row.energy_j);
    on_field("clearance_mm", row.clearance_mm);
    on_field("deviation_mm", row.deviation_mm);
    on_field("joint_speed_share", row.joint_speed_share);
    on_field("lower_bound_s", row.times.lower_bound_s);
}

}  // namespace

std::string print_row(const RunRow& row) {
    json line = json::object();
    for_each_row_field(row, [&](const char* name, const auto& value) { line[name] = value; });
    for_each_optional(row, [&](const char* name, const std::optional<double>& value) {
        line[name] = optional_json(value);
    });
    json& files = line["files"] = json::array();
    for (const ReadFile& file : row.files) files.push_back({file.name, file.sha256});
    return line.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<RunRow> read_row(std::string_view line) {
    try {
        const json read = text::parse_json<json>(line);
        RunRow row;
        for_each_row_field(row, [&](const char* name, auto& value) { read.at(name).get_to(value); });
        for_each_optional(row, [&](const char* name, std::optional<double>& value) {
            value = parse_optional(read.at(name));
        });
        for (const json& file : read.at("files")) row.files.push_back({file.at(0), file.at(1)});
        return row;
    } catch (const json::exception& error) {
        return Unexpected(fmt::format("not a row of a run: {}", error.what()));
    }
}

}  // namespace gsim::batch
