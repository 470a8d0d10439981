#include "batch/store/outputs.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/json.h"
#include "base/text/xml_text.h"
#include "engine/diagnostic.h"
#include "engine/findings.h"

namespace gsim::batch {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxCauseLength = 60;  // characters of a message in the summary

/// Calls `on_row` with the statement at each row of a query.
template <typename Visitor>
Result<void> for_each_row(Database& results, std::string_view query, const Visitor& on_row) {
    auto rows = results.prepare(query);
    if (!rows) return Unexpected(rows.error());
    while (true) {
        const auto row = rows->step();
        if (!row) return Unexpected(row.error());
        if (!*row) return {};
        if (!on_row(*rows)) return Unexpected("it cannot be written");
    }
}

std::string quoted_csv(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
    return fmt::format("{}\r\n", text::joined(cells, ","));
}

bool is_json_column(const std::string& column) {
    return column == "settings" || column == "options" || column == "extents" || column == "findings";
}

json column_value(const Statement& row, int column) {
    if (row.is_null(column)) return {};
    if (row.is_integer(column)) return row.integer(column);
    if (row.is_number(column)) return row.number(column);
    const std::string text(row.text(column));
    if (!is_json_column(row.name(column))) return text;
    json value = text::try_parse_json<json>(text);
    return value.is_discarded() ? json(text) : value;
}

std::string_view machine_name(std::string_view machine) {
    return machine.empty() ? std::string_view("built-in machine") : machine;
}

std::string junit_case(const Statement& row) {
    const std::string settings(row.text(6));
    std::string name(row.text(1));
    if (settings != "{}") name += " " + settings;
    const std::string head =
        fmt::format(R"(    <testcase classname="{}" name="{}" time="{:.3f}")",
                    text::xml_text(machine_name(row.text(0))), text::xml_text(name), row.number(5));
    if (row.text(2) == "completed" && row.text(3).empty()) return head + "/>\n";
    return fmt::format("{}>\n      <failure type=\"{}\" message=\"{}\">{}{}</failure>\n    </testcase>\n",
                       head, text::xml_text(row.text(3).empty() ? row.text(2) : row.text(3)),
                       text::xml_text(row.text(4)), text::xml_text(row.text(7)),
                       row.integer(8) > 0 ? fmt::format(":{}", row.integer(8)) : std::string());
}

engine::Severity parse_severity(const std::string& word) {
    if (word == "error") return engine::Severity::error;
    return word == "warning" ? engine::Severity::warning : engine::Severity::note;
}

engine::Diagnostic parse_diagnostic(const json& finding) {
    const auto text = [&](const char* key) {
        return finding[key].is_string() ? finding[key].get<std::string>() : "";
    };
    const auto count = [&](const char* key) {
        return finding[key].is_number_unsigned() ? finding[key].get<std::uint32_t>() : 0U;
    };
    return {.severity = parse_severity(text("severity")),
            .code = text("code"),
            .file = text("file"),
            .line = count("line"),
            .column = count("column"),
            .end_column = count("end_column"),
            .text = text("text"),
            .hint = text("hint"),
            .excerpt = {}};
}

std::string truncated(std::string_view message) {
    if (message.size() <= kMaxCauseLength) return std::string(message);
    std::size_t end = kMaxCauseLength;
    while (end > 0 && (static_cast<unsigned char>(message[end]) & 0xC0U) == 0x80U)
        --end;  // within a character
    return std::string(message.substr(0, end)) + "...";
}

}  // namespace

Result<void> write_csv(Database& results, std::string_view query, const Sink& sink) {
    const auto columns = results.prepare(query);
    if (!columns) return Unexpected(columns.error());
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(columns->columns()));
    for (int column = 0; column < columns->columns(); ++column)
        names.push_back(quoted_csv(columns->name(column)));
    if (!sink(csv_line(names))) return Unexpected("it cannot be written");
    return for_each_row(results, query, [&](const Statement& row) {
        std::vector<std::string> cells;
        cells.reserve(static_cast<std::size_t>(row.columns()));
        for (int column = 0; column < row.columns(); ++column) {
            // SQLite prints only 15 digits as text.
            cells.push_back(row.is_number(column) ? fmt::format("{}", row.number(column))
                                                  : quoted_csv(row.text(column)));
        }
        return sink(csv_line(cells));
    });
}

Result<void> write_json_lines(Database& results, std::string_view query, const Sink& sink) {
    return for_each_row(results, query, [&](const Statement& row) {
        nlohmann::ordered_json line;
        for (int column = 0; column < row.columns(); ++column)
            line[row.name(column)] = column_value(row, column);
        return sink(line.dump(-1, ' ', false, json::error_handler_t::replace) + '\n');
    });
}

Result<void> write_junit(Database& results, const Sink& sink) {
    if (!sink("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"gsim-batch\">\n"))
        return Unexpected("it cannot be written");
    struct JunitSuite {
        std::string machine;
        std::int64_t runs = 0, failed = 0;
    };
    std::vector<JunitSuite> suites;
    auto count_text = for_each_row(
        results,
        "SELECT machine, count(*), sum(status <> 'completed' OR cause <> '') FROM latest GROUP BY machine",
        [&](const Statement& row) {
            suites.push_back({std::string(row.text(0)), row.integer(1), row.integer(2)});
            return true;
        });
    if (!count_text) return count_text;
    auto cases = results.prepare(
        "SELECT machine, program, status, cause, message, cpu_s, settings, file, line FROM latest WHERE "
        "machine = ?");
    if (!cases) return Unexpected(cases.error());
    for (const JunitSuite& suite : suites) {
        if (!sink(fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n",
                              text::xml_text(machine_name(suite.machine)), suite.runs, suite.failed)))
            return Unexpected("it cannot be written");
        cases->bind(1, suite.machine);
        while (true) {
            const auto row = cases->step();
            if (!row) return Unexpected(row.error());
            if (!*row) break;
            if (!sink(junit_case(*cases))) return Unexpected("it cannot be written");
        }
        sink("  </testsuite>\n");
    }
    return sink("</testsuites>\n") ? Result<void>() : Unexpected("it cannot be written");
}

Result<void> write_sarif(Database& results, const Sink& sink) {
    std::vector<engine::Diagnostic> diagnostics;
    std::set<std::tuple<std::string, std::uint32_t, std::uint32_t, std::string, std::string>> known;
    auto gathered = for_each_row(
        results, "SELECT findings FROM latest WHERE findings <> '[]'", [&](const Statement& row) {
            for (const json& finding : text::parse_json<json>(std::string(row.text(0)))) {
                engine::Diagnostic diagnostic = parse_diagnostic(finding);
                if (known
                        .emplace(diagnostic.file, diagnostic.line, diagnostic.column, diagnostic.code,
                                 diagnostic.text)
                        .second)
                    diagnostics.push_back(std::move(diagnostic));
            }
            return true;
        });
    if (!gathered) return gathered;
    return sink(engine::findings_sarif(diagnostics)) ? Result<void>() : Unexpected("it cannot be written");
}

Result<std::string> summary(Database& results) {
    std::string text;
    const auto machines =
        for_each_row(results, "SELECT machine, controller, runs, failed, cycle_time_s FROM machines",
                     [&](const Statement& row) {
                         text += fmt::format("{:<40} {:<16} {:>8} runs {:>8} failed {:>14.3f} s\n",
                                             machine_name(row.text(0)), row.text(1), row.integer(2),
                                             row.integer(3), row.number(4));
                         return true;
                     });
    if (!machines) return Unexpected(machines.error());
    bool has_heading = false;
    const auto causes = for_each_row(
        results, "SELECT runs, status, cause, message, example FROM causes", [&](const Statement& row) {
            if (!has_heading) text += "\n    runs  status      cause\n";
            has_heading = true;
            text += fmt::format("{:>8}  {:<10}  {:<24} {} ({})\n", row.integer(0), row.text(1), row.text(2),
                                truncated(row.text(3)), row.text(4));
            return true;
        });
    if (!causes) return Unexpected(causes.error());
    return text;
}

}  // namespace gsim::batch
