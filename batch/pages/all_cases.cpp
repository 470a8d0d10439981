#include "batch/pages/all_cases.h"

#include <algorithm>

#include <fmt/format.h>

#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kRowsPerPage = 2000;

std::string part_page_name(std::size_t part) {
    return part == 0 ? std::string(kFrontPage) : fmt::format("runs-{}.html", part + 1);
}

std::size_t count_rows(const NightlyReport& report) {
    std::size_t rows = 0;
    for (const ProgramCases& program : report.programs) rows += program.cases.size();
    return rows;
}

std::size_t count_parts(const NightlyReport& report) {
    return std::max<std::size_t>((count_rows(report) + kRowsPerPage - 1) / kRowsPerPage, 1);
}

bool has_settings(const NightlyReport& report) {
    return std::any_of(report.cases.begin(), report.cases.end(),
                       [](const Case& of) { return of.settings != "{}"; });
}

std::vector<std::string> case_row(const Case& of, const std::string& page, bool with_settings) {
    const std::string address = case_address(of, page);
    const auto count = [&](std::int64_t number) {
        return number > 0 ? link(address, fmt::format("{}", number)) : std::string("0");
    };
    const bool has_both_times = of.before != nullptr && of.before->has_time() && of.now->has_time();
    std::vector<std::string> row{link(address, of.program), machine_label(of.machine)};
    if (with_settings) row.push_back(settings_text(of.settings));
    row.insert(
        row.end(),
        {outcome(*of.now), time_text(*of.now), of.before == nullptr ? std::string() : time_text(*of.before),
         has_both_times && of.before->time_s != of.now->time_s ? difference(of.before->time_s, of.now->time_s)
                                                               : std::string(),
         count(of.now->violations), count(of.now->collisions), count(of.now->process_findings),
         of.is_reused ? "reused" : "new run"});
    return row;
}

/// Returns links to the other parts.
std::string part_links(std::size_t parts, std::size_t part) {
    if (parts == 1) return {};
    std::string text = "<nav aria-label=\"Parts of the table\"><p>Part";
    for (std::size_t each = 0; each < parts; ++each) {
        const std::string number = fmt::format("{}", each + 1);
        text += ' ' + (each == part ? fmt::format("<strong>{}</strong>", number)
                                    : link(part_page_name(each), number));
    }
    return text + "</p></nav>\n";
}

}  // namespace

std::string cases_text(const NightlyReport& report, std::size_t part) {
    const bool with_settings = has_settings(report);
    std::vector<std::string_view> columns{"Program", "Machine"};
    if (with_settings) columns.emplace_back("Settings");
    columns.insert(columns.end(), {"Outcome", "Time, s", "Previous batch, s", "Difference",
                                   "Limit violations", "Collisions", "Process errors", "Run"});
    HtmlTable table("All runs", columns);
    std::size_t row = 0;
    for (const ProgramCases& program : report.programs) {
        for (const std::size_t position : program.cases) {
            if (row++ / kRowsPerPage == part)
                table.add(case_row(report.cases[position], program.page, with_settings));
        }
    }
    const std::size_t parts = count_parts(report), rows = count_rows(report);
    const std::string links = part_links(parts, part);
    const std::size_t first = part * kRowsPerPage, end = std::min(first + kRowsPerPage, rows);
    const std::string row_range =
        parts > 1 ? fmt::format("<p>{} to {} of {} runs.</p>\n", first + 1, end, rows) : std::string();
    return row_range + links + table.text() + links;
}

std::vector<std::pair<std::string, std::string>> additional_pages(const NightlyReport& report) {
    std::vector<std::pair<std::string, std::string>> pages;
    for (std::size_t part = 1; part < count_parts(report); ++part) {
        std::string name = part_page_name(part);
        std::string page = full_page(
            name, fmt::format("All runs of {}, part {}", plain_batch_label(report.latest), part + 1),
            "<a href=\"index.html\">Front page</a>", cases_text(report, part));
        pages.emplace_back(std::move(name), std::move(page));
    }
    return pages;
}

}  // namespace gsim::batch
