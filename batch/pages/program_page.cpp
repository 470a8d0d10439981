#include "batch/pages/program_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "batch/pages/case_text.h"
#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kMaxCases = 1000;  // of the table

std::string cases_table(const NightlyReport& report, const ProgramCases& program) {
    HtmlTable table("Machines and settings", {"Machine", "Settings", "Outcome", "Time, s",
                                              "Previous batch, s", "Findings", "First error"});
    const std::size_t count = std::min(program.cases.size(), kMaxCases);
    for (std::size_t i = 0; i < count; ++i) {
        const Case& of = report.cases[program.cases[i]];
        const std::string machine = machine_label(of.machine);
        table.add(
            {of.has_details ? fmt::format("<a href=\"#case-{}\">{}</a>", of.position + 1, machine) : machine,
             settings_text(of.settings), outcome(*of.now), time_text(*of.now),
             of.before == nullptr ? std::string() : time_text(*of.before),
             fmt::format("{}", of.now->findings()), first_error(*of.now)});
    }
    std::string text = table.text();
    if (count < program.cases.size())
        text += fmt::format("<p>{} more are not shown here.</p>\n", program.cases.size() - count);
    return text;
}

}  // namespace

std::string program_page(const NightlyReport& report, const ProgramCases& program,
                         const std::vector<CaseDetails>& details) {
    std::string body = fmt::format("<p>As of {}.</p>\n", batch_label(report.latest));
    if (program.cases.size() > 1) body += cases_table(report, program);
    for (const CaseDetails& each : details) body += case_text(report, each);
    if (details.size() < program.cases.size())
        body += fmt::format("<p>{} more are shown only as a row above.</p>\n",
                            program.cases.size() - details.size());
    return full_page(program.page, program.program, "<a href=\"index.html\">All programs</a>", body);
}

}  // namespace gsim::batch
