#include "batch/work/run_row.h"

#include <fmt/format.h>

#include "base/text/json.h"

namespace gsim::batch {

using nlohmann::json;

namespace {

json optional_json(std::optional<double> value) {
    return value ? json(*value) : json();
}

std::optional<double> optional_in(const json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

/// Calls `take(name, member)` for each member that is a text, a number or a count.
template <typename Row, typename Take>
void for_each_row_field(Row& row, const Take& take) {
    take("number", row.number);
    take("status", row.status);
    take("cause", row.cause);
    take("message", row.message);
    take("file", row.file);
    take("line", row.line);
    take("machine", row.machine);
    take("controller", row.controller);
    take("cycle_time_s", row.cycle_time_s);
    take("rapid_s", row.rapid_s);
    take("feed_s", row.feed_s);
    take("dwell_s", row.dwell_s);
    take("rapid_mm", row.rapid_mm);
    take("feed_mm", row.feed_mm);
    take("jet_on_mm", row.jet_on_mm);
    take("blocks", row.blocks);
    take("moves", row.moves);
    take("violations", row.violations);
    take("collisions", row.collisions);
    take("process_findings", row.process_findings);
    take("warnings", row.warnings);
    take("extents", row.extents);
    take("findings", row.findings);
    take("cpu_s", row.cpu_s);
    take("report", row.report);
    take("picture", row.picture);
    take("picture_fault", row.picture_fault);
}

/// Does the same for those that may be missing.
template <typename Row, typename Take>
void for_each_optional(Row& row, const Take& take) {
    take("least_s", row.least_s);
    take("most_s", row.most_s);
    take("energy_j", row.energy_j);
    take("clearance_mm", row.clearance_mm);
    take("deviation_mm", row.deviation_mm);
    take("joint_speed_share", row.joint_speed_share);
    take("lower_bound_s", row.lower_bound_s);
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

tl::expected<RunRow, std::string> read_row(std::string_view line) {
    try {
        const json read = text::parse_json<json>(line);
        RunRow row;
        for_each_row_field(row, [&](const char* name, auto& value) { read.at(name).get_to(value); });
        for_each_optional(
            row, [&](const char* name, std::optional<double>& value) { value = optional_in(read.at(name)); });
        for (const json& file : read.at("files")) row.files.push_back({file.at(0), file.at(1)});
        return row;
    } catch (const json::exception& error) {
        return tl::unexpected(fmt::format("no row of a run: {}", error.what()));
    }
}

}  // namespace gsim::batch
