#include "batch/pages/front_page.h"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

#include "batch/pages/all_cases.h"
#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kMaxListedPrograms = 50;  // programs that fail for one cause

std::string plan_label(const BatchSummary& batch) {
    return batch.plan.empty() ? std::string("programs from the command line") : escape_html(batch.plan);
}

std::string run_count_text(const BatchSummary& batch) {
    if (batch.complete) return fmt::format("all {}", batch.jobs);
    return fmt::format("<span class=\"bad\">{} of {}</span>: the batch was interrupted, or is running",
                       batch.runs, batch.jobs);
}

std::string summary_text(const NightlyReport& report) {
    const BatchSummary& latest = report.latest;
    double time_s = 0;
    for (const Case& each : report.cases) {
        if (each.now != nullptr && each.now->has_time()) time_s += each.now->time_s;
    }
    return definition_list(
        {{"Batch", fmt::format("{}", latest.id)},
         {"Plan", plan_label(latest)},
         {"Started", time_markup(latest.started_at)},
         {"Ended",
          latest.ended_at.empty() ? std::string("not yet, or interrupted") : time_markup(latest.ended_at)},
         {"Version", escape_html(latest.version)},
         {"Programs", fmt::format("{}", report.programs.size())},
         {"Runs", run_count_text(latest)},
         {"Without errors", fmt::format("{}", latest.runs - latest.failed)},
         {"Failed",
          latest.failed > 0 ? fmt::format("<span class=\"bad\">{}</span>", latest.failed) : std::string("0")},
         {"New runs", fmt::format("{}", latest.runs - latest.reused)},
         {"Reused", fmt::format("{}", latest.reused)},
         {"Total time", seconds(time_s) + " s"}});
}

/// Lists of changes, in order.
class ChangesText {
  public:
    ChangesText(const NightlyReport& report, const Changes& changes, const ReasonsByCase& reasons_by_case)
        : report_(report), changes_(changes), reasons_by_case_(reasons_by_case) {
        for (const ProgramCases& program : report.programs) pages_[program.program] = program.page;
    }

    std::string text() const {
        if (!report_.before) return "<h2>Changes</h2>\n<p>There is no earlier batch.</p>\n";
        std::string text = fmt::format("<h2>Changes since {}</h2>\n", batch_label(*report_.before));
        if (report_.before->plan != report_.latest.plan)
            text += fmt::format("<p>That batch used another plan: {}.</p>\n", plan_label(*report_.before));
        if (!report_.before->complete)
            text += fmt::format("<p>That batch has {} of {} runs.</p>\n", report_.before->runs,
                                report_.before->jobs);
        if (report_.before->version != report_.latest.version)
            text += fmt::format("<p>The version of gsim has changed: {}, before {}.</p>\n",
                                escape_html(report_.latest.version), escape_html(report_.before->version));
        return text + counts() + newly_failing() + fixed() + changed_times() + changed_findings() + added() +
               removed();
    }

  private:
    std::string counts() const {
        std::string text = "<ul>\n";
        const auto add = [&](const std::vector<std::size_t>& positions, std::string_view anchor,
                             std::string_view what) {
            text += positions.empty()
                        ? fmt::format("<li>0 {}</li>\n", what)
                        : fmt::format("<li><a href=\"#{}\">{} {}</a></li>\n", anchor, positions.size(), what);
        };
        add(changes_.newly_failing, "newly-failing", "newly failing");
        add(changes_.fixed, "fixed", "fixed");
        add(changes_.changed_times, "times", "with a different time");
        add(changes_.changed_findings, "findings", "with a different cause or different findings");
        add(changes_.added, "new", "new");
        add(changes_.removed, "removed", "removed");
        return text + fmt::format("<li>{} unchanged</li>\n</ul>\n", changes_.same);
    }

    /// Returns a list with its heading: `cells` returns the cells that follow program and machine.
    template <typename Cells>
    std::string list(const std::vector<std::size_t>& positions, std::string_view anchor,
                     std::string_view title, std::vector<std::string_view> columns,
                     const Cells& cells) const {
        if (positions.empty()) return {};
        columns.insert(columns.begin(), {"Program", "Machine"});
        HtmlTable table(title, columns);
        for (std::size_t i = 0; i < std::min(positions.size(), kMaxListed); ++i) {
            const Case& of = report_.cases[positions[i]];
            std::vector<std::string> row{case_link(of), machine_cell(of)};
            for (std::string& cell : cells(of, positions[i])) row.push_back(std::move(cell));
            table.add(row);
        }
        std::string text = fmt::format("<h3 id=\"{}\">{}</h3>\n", anchor, title) + table.text();
        if (positions.size() > kMaxListed)
            text += fmt::format("<p>{} more are not shown here.</p>\n", positions.size() - kMaxListed);
        return text;
    }

    std::string newly_failing() const {
        return list(changes_.newly_failing, "newly-failing", "Newly failing",
                    {"Outcome", "First error", "Reason for the new run"},
                    [&](const Case& of, std::size_t position) {
                        return std::vector{outcome(*of.now), first_error(*of.now), reason(position)};
                    });
    }

    std::string fixed() const {
        return list(changes_.fixed, "fixed", "Fixed",
                    {"Before", "Previous first error", "Reason for the new run"},
                    [&](const Case& of, std::size_t position) {
                        return std::vector{outcome(*of.before), first_error(*of.before), reason(position)};
                    });
    }

    std::string changed_times() const {
        return list(changes_.changed_times, "times", "With a different time",
                    {"Before, s", "Now, s", "Difference", "Reason for the new run"},
                    [&](const Case& of, std::size_t position) {
                        return std::vector{time_text(*of.before), time_text(*of.now),
                                           difference(of.before->time_s, of.now->time_s), reason(position)};
                    });
    }

    std::string changed_findings() const {
        return list(
            changes_.changed_findings, "findings", "With a different cause or different findings",
            {"Before", "Now", "Findings before", "Findings now", "First error", "Reason for the new run"},
            [&](const Case& of, std::size_t position) {
                return std::vector{outcome(*of.before),
                                   outcome(*of.now),
                                   fmt::format("{}", of.before->findings()),
                                   fmt::format("{}", of.now->findings()),
                                   first_error(*of.now),
                                   reason(position)};
            });
    }

    std::string added() const {
        return list(changes_.added, "new", "New", {"Outcome", "Time, s"}, [](const Case& of, std::size_t) {
            return std::vector{outcome(*of.now), time_text(*of.now)};
        });
    }

    /// In an incomplete batch they may still be run.
    std::string removed() const {
        return list(changes_.removed, "removed",
                    report_.latest.complete ? "Removed" : "Removed, or not run yet",
                    {"Outcome before", "Time before, s"}, [](const Case& of, std::size_t) {
                        return std::vector{outcome(*of.before), time_text(*of.before)};
                    });
    }

    std::string case_link(const Case& of) const {
        const auto page = pages_.find(of.program);
        if (page == pages_.end()) return escape_html(of.program);
        return link(of.now == nullptr ? page->second : case_address(of, page->second), of.program);
    }

    static std::string machine_cell(const Case& of) {
        const std::string settings = settings_text(of.settings);
        return machine_label(of.machine) + (settings.empty() ? "" : "<br/>" + settings);
    }

    std::string reason(std::size_t position) const {
        const auto found = reasons_by_case_.find(position);
        return found == reasons_by_case_.end() ? std::string() : found->second;
    }

    const NightlyReport& report_;
    const Changes& changes_;
    const ReasonsByCase& reasons_by_case_;
    std::unordered_map<std::string, std::string> pages_;
};

/// Cases that fail for one cause.
struct FailingCases {
    std::size_t runs = 0;
    const RunSummary* example = nullptr;
    std::vector<const ProgramCases*> programs = {};
    std::vector<const Case*> first_cases = {};  ///< The first of each program.
};

std::string program_list(const FailingCases& failing) {
    std::string text = "<ul>\n";
    for (std::size_t i = 0; i < std::min(failing.programs.size(), kMaxListedPrograms); ++i) {
        const Case& first = *failing.first_cases[i];
        text +=
            fmt::format("<li>{}: {}</li>\n",
                        link(case_address(first, failing.programs[i]->page), failing.programs[i]->program),
                        first_error(*first.now));
    }
    if (failing.programs.size() > kMaxListedPrograms)
        text += fmt::format("<li>{} more</li>\n", failing.programs.size() - kMaxListedPrograms);
    return text + "</ul>\n";
}

std::string failing_text(const NightlyReport& report) {
    std::map<std::pair<std::string, std::string>, FailingCases> cases_by_cause;
    for (const ProgramCases& program : report.programs) {
        for (const std::size_t position : program.cases) {
            const Case& of = report.cases[position];
            if (of.now->is_clean()) continue;
            FailingCases& failing = cases_by_cause[{of.now->status, of.now->cause}];
            ++failing.runs;
            failing.example = of.now;
            if (!failing.programs.empty() && failing.programs.back() == &program) continue;
            failing.programs.push_back(&program);
            failing.first_cases.push_back(&of);
        }
    }
    std::string text = "<h2>Failures</h2>\n";
    if (cases_by_cause.empty()) return text + "<p>No failures.</p>\n";
    std::vector<const FailingCases*> causes;
    causes.reserve(cases_by_cause.size());
    for (const auto& [cause, failing] : cases_by_cause) causes.push_back(&failing);
    std::stable_sort(causes.begin(), causes.end(),
                     [](const auto* a, const auto* b) { return a->runs > b->runs; });
    for (const FailingCases* failing : causes)
        text += fmt::format(
            "<h3>{}, {} of {}</h3>\n{}", outcome(*failing->example), count_text(failing->runs, "run", "runs"),
            count_text(failing->programs.size(), "program", "programs"), program_list(*failing));
    return text;
}

}  // namespace

std::string front_page(const NightlyReport& report, const Changes& changes,
                       const ReasonsByCase& reasons_by_case) {
    const BatchSummary& latest = report.latest;
    const std::string plan = latest.plan.empty() ? std::string() : latest.plan + ", ";
    return full_page(kFrontPage, "Check of " + plan + plain_batch_label(latest), "",
                     summary_text(report) + ChangesText(report, changes, reasons_by_case).text() +
                         failing_text(report) + "<h2>All runs</h2>\n" + cases_text(report, 0));
}

}  // namespace gsim::batch
