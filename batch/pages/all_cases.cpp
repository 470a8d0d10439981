#include "batch/pages/all_cases.h"

#include <algorithm>

#include <fmt/format.h>

#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kRowsOfPart = 2000;

std::string page_of_part(std::size_t part) {
    return part == 0 ? std::string(kFrontPage) : fmt::format("runs-{}.html", part + 1);
}

std::size_t rows_in(const Night& night) {
    std::size_t rows = 0;
    for (const ProgramCases& program : night.programs) rows += program.cases.size();
    return rows;
}

std::size_t parts_of(const Night& night) {
    return std::max<std::size_t>((rows_in(night) + kRowsOfPart - 1) / kRowsOfPart, 1);
}

bool has_settings(const Night& night) {
    return std::any_of(night.cases.begin(), night.cases.end(),
                       [](const Case& of) { return of.settings != "{}"; });
}

std::vector<std::string> row_of_case(const Case& of, const std::string& page, bool with_settings) {
    const std::string address = address_of(of, page);
    const auto count = [&](std::int64_t number) {
        return number > 0 ? link(address, fmt::format("{}", number)) : std::string("0");
    };
    const bool both = of.before != nullptr && of.before->has_time() && of.now->has_time();
    std::vector<std::string> row{link(address, of.program), machine_named(of.machine)};
    if (with_settings) row.push_back(settings_in(of.settings));
    row.insert(
        row.end(),
        {outcome(*of.now), time_of(*of.now), of.before == nullptr ? std::string() : time_of(*of.before),
         both && of.before->time_s != of.now->time_s ? difference(of.before->time_s, of.now->time_s)
                                                     : std::string(),
         count(of.now->violations), count(of.now->collisions), count(of.now->process_findings),
         of.is_reused ? "found again" : "run anew"});
    return row;
}

/// Returns links to the other parts.
std::string links_to_parts(std::size_t parts, std::size_t part) {
    if (parts == 1) return {};
    std::string text = "<nav aria-label=\"Parts of the table\"><p>Part";
    for (std::size_t each = 0; each < parts; ++each) {
        const std::string number = fmt::format("{}", each + 1);
        text += ' ' + (each == part ? fmt::format("<strong>{}</strong>", number)
                                    : link(page_of_part(each), number));
    }
    return text + "</p></nav>\n";
}

}  // namespace

std::string cases_text(const Night& night, std::size_t part) {
    const bool with_settings = has_settings(night);
    std::vector<std::string_view> columns{"Program", "Machine"};
    if (with_settings) columns.emplace_back("Settings");
    columns.insert(columns.end(), {"Outcome", "Time, s", "Batch before, s", "Difference", "Of limits",
                                   "Collisions", "Of the process", "Run"});
    TableText table("All runs", columns);
    std::size_t row = 0;
    for (const ProgramCases& program : night.programs) {
        for (const std::size_t place : program.cases) {
            if (row++ / kRowsOfPart == part)
                table.add(row_of_case(night.cases[place], program.page, with_settings));
        }
    }
    const std::size_t parts = parts_of(night), rows = rows_in(night);
    const std::string links = links_to_parts(parts, part);
    const std::size_t first = part * kRowsOfPart, end = std::min(first + kRowsOfPart, rows);
    const std::string shown_rows =
        parts > 1 ? fmt::format("<p>{} to {} of {} runs.</p>\n", first + 1, end, rows) : std::string();
    return shown_rows + links + table.text() + links;
}

std::vector<std::pair<std::string, std::string>> further_pages(const Night& night) {
    std::vector<std::pair<std::string, std::string>> pages;
    for (std::size_t part = 1; part < parts_of(night); ++part) {
        std::string name = page_of_part(part);
        std::string page =
            whole_page(name, fmt::format("All runs of {}, part {}", plainly_named(night.latest), part + 1),
                       "<a href=\"index.html\">Front page</a>", cases_text(night, part));
        pages.emplace_back(std::move(name), std::move(page));
    }
    return pages;
}

}  // namespace gsim::batch
