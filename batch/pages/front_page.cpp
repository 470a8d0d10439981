#include "batch/pages/front_page.h"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

#include "batch/pages/all_cases.h"
#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kMostNamed = 50;  // programs that fail for one cause

std::string plan_named(const BatchFacts& batch) {
    return batch.plan.empty() ? std::string("programs by the command line") : shown(batch.plan);
}

std::string state_of(const BatchFacts& batch) {
    if (batch.whole) return fmt::format("all {}", batch.jobs);
    return fmt::format("<span class=\"bad\">{} of {}</span>: the batch was cut off, or is under way",
                       batch.runs, batch.jobs);
}

std::string head_text(const Night& night) {
    const BatchFacts& latest = night.latest;
    double time_s = 0;
    for (const Case& each : night.cases) {
        if (each.now != nullptr && each.now->has_time()) time_s += each.now->time_s;
    }
    return list_of(
        {{"Batch", fmt::format("{}", latest.id)},
         {"Plan", plan_named(latest)},
         {"Began", moment(latest.began_at)},
         {"Ended", latest.ended_at.empty() ? std::string("not yet, or cut off") : moment(latest.ended_at)},
         {"Version", shown(latest.version)},
         {"Programs", fmt::format("{}", night.programs.size())},
         {"Runs", state_of(latest)},
         {"Without a fault", fmt::format("{}", latest.runs - latest.failed)},
         {"Failed",
          latest.failed > 0 ? fmt::format("<span class=\"bad\">{}</span>", latest.failed) : std::string("0")},
         {"Run anew", fmt::format("{}", latest.runs - latest.reused)},
         {"Found again", fmt::format("{}", latest.reused)},
         {"Time of all", seconds(time_s) + " s"}});
}

/// Lists of changes, one after the other.
class ChangesText {
  public:
    ChangesText(const Night& night, const Changes& changes, const Whys& whys)
        : night_(night), changes_(changes), whys_(whys) {
        for (const ProgramCases& program : night.programs) pages_[program.program] = program.page;
    }

    std::string text() const {
        if (!night_.before) return "<h2>What has changed</h2>\n<p>There is no batch before this one.</p>\n";
        std::string text = fmt::format("<h2>What has changed since {}</h2>\n", named(*night_.before));
        if (night_.before->plan != night_.latest.plan)
            text += fmt::format("<p>That batch was of another plan: {}.</p>\n", plan_named(*night_.before));
        if (!night_.before->whole)
            text += fmt::format("<p>Of that batch there are {} of {} runs.</p>\n", night_.before->runs,
                                night_.before->jobs);
        if (night_.before->version != night_.latest.version)
            text += fmt::format("<p>gsim itself is another one: {}, before {}.</p>\n",
                                shown(night_.latest.version), shown(night_.before->version));
        return text + counts() + newly_failing() + mended() + other_times() + other_findings() + fresh() +
               gone();
    }

  private:
    std::string counts() const {
        std::string text = "<ul>\n";
        const auto add = [&](const std::vector<std::size_t>& places, std::string_view anchor,
                             std::string_view what) {
            text += places.empty()
                        ? fmt::format("<li>0 {}</li>\n", what)
                        : fmt::format("<li><a href=\"#{}\">{} {}</a></li>\n", anchor, places.size(), what);
        };
        add(changes_.newly_failing, "newly-failing", "newly failing");
        add(changes_.mended, "mended", "mended");
        add(changes_.other_times, "times", "with another time");
        add(changes_.other_findings, "findings", "with another cause or other findings");
        add(changes_.fresh, "new", "new");
        add(changes_.gone, "gone", "gone");
        return text + fmt::format("<li>{} as before</li>\n</ul>\n", changes_.same);
    }

    /// Returns a list with its heading: `cells` returns the cells after program and machine.
    template <typename Cells>
    std::string list(const std::vector<std::size_t>& places, std::string_view anchor, std::string_view title,
                     std::vector<std::string_view> columns, const Cells& cells) const {
        if (places.empty()) return {};
        columns.insert(columns.begin(), {"Program", "Machine"});
        TableText table(title, columns);
        for (std::size_t i = 0; i < std::min(places.size(), kMostListed); ++i) {
            const Case& of = night_.cases[places[i]];
            std::vector<std::string> row{linked(of), machine_of(of)};
            for (std::string& cell : cells(of, places[i])) row.push_back(std::move(cell));
            table.add(row);
        }
        std::string text = fmt::format("<h3 id=\"{}\">{}</h3>\n", anchor, title) + table.text();
        if (places.size() > kMostListed)
            text += fmt::format("<p>{} more are left out here.</p>\n", places.size() - kMostListed);
        return text;
    }

    std::string newly_failing() const {
        return list(changes_.newly_failing, "newly-failing", "Newly failing",
                    {"Outcome", "First fault", "Run anew for"}, [&](const Case& of, std::size_t place) {
                        return std::vector{outcome(*of.now), first_fault(*of.now), why(place)};
                    });
    }

    std::string mended() const {
        return list(changes_.mended, "mended", "Mended", {"Before", "First fault before", "Run anew for"},
                    [&](const Case& of, std::size_t place) {
                        return std::vector{outcome(*of.before), first_fault(*of.before), why(place)};
                    });
    }

    std::string other_times() const {
        return list(changes_.other_times, "times", "With another time",
                    {"Before, s", "Now, s", "Difference", "Run anew for"},
                    [&](const Case& of, std::size_t place) {
                        return std::vector{time_of(*of.before), time_of(*of.now),
                                           difference(of.before->time_s, of.now->time_s), why(place)};
                    });
    }

    std::string other_findings() const {
        return list(changes_.other_findings, "findings", "With another cause or other findings",
                    {"Before", "Now", "Findings before", "Findings now", "First fault", "Run anew for"},
                    [&](const Case& of, std::size_t place) {
                        return std::vector{outcome(*of.before),
                                           outcome(*of.now),
                                           fmt::format("{}", of.before->findings()),
                                           fmt::format("{}", of.now->findings()),
                                           first_fault(*of.now),
                                           why(place)};
                    });
    }

    std::string fresh() const {
        return list(changes_.fresh, "new", "New", {"Outcome", "Time, s"}, [](const Case& of, std::size_t) {
            return std::vector{outcome(*of.now), time_of(*of.now)};
        });
    }

    /// In an incomplete batch they may still be run.
    std::string gone() const {
        return list(changes_.gone, "gone", night_.latest.whole ? "Gone" : "Gone, or not run yet",
                    {"Outcome before", "Time before, s"}, [](const Case& of, std::size_t) {
                        return std::vector{outcome(*of.before), time_of(*of.before)};
                    });
    }

    std::string linked(const Case& of) const {
        const auto page = pages_.find(of.program);
        if (page == pages_.end()) return shown(of.program);
        return link(of.now == nullptr ? page->second : address_of(of, page->second), of.program);
    }

    static std::string machine_of(const Case& of) {
        const std::string settings = settings_in(of.settings);
        return machine_named(of.machine) + (settings.empty() ? "" : "<br/>" + settings);
    }

    std::string why(std::size_t place) const {
        const auto found = whys_.find(place);
        return found == whys_.end() ? std::string() : found->second;
    }

    const Night& night_;
    const Changes& changes_;
    const Whys& whys_;
    std::unordered_map<std::string, std::string> pages_;
};

/// Cases that fail for one cause.
struct FailingCases {
    std::size_t runs = 0;
    const RunFacts* example = nullptr;
    std::vector<const ProgramCases*> programs = {};
    std::vector<const Case*> first_cases = {};  ///< The first of each program.
};

std::string list_of_programs(const FailingCases& failing) {
    std::string text = "<ul>\n";
    for (std::size_t i = 0; i < std::min(failing.programs.size(), kMostNamed); ++i) {
        const Case& first = *failing.first_cases[i];
        text += fmt::format("<li>{}: {}</li>\n",
                            link(address_of(first, failing.programs[i]->page), failing.programs[i]->program),
                            first_fault(*first.now));
    }
    if (failing.programs.size() > kMostNamed)
        text += fmt::format("<li>{} more</li>\n", failing.programs.size() - kMostNamed);
    return text + "</ul>\n";
}

std::string failing_text(const Night& night) {
    std::map<std::pair<std::string, std::string>, FailingCases> by_cause;
    for (const ProgramCases& program : night.programs) {
        for (const std::size_t place : program.cases) {
            const Case& of = night.cases[place];
            if (of.now->is_clean()) continue;
            FailingCases& failing = by_cause[{of.now->status, of.now->cause}];
            ++failing.runs;
            failing.example = of.now;
            if (!failing.programs.empty() && failing.programs.back() == &program) continue;
            failing.programs.push_back(&program);
            failing.first_cases.push_back(&of);
        }
    }
    std::string text = "<h2>What fails</h2>\n";
    if (by_cause.empty()) return text + "<p>Nothing fails.</p>\n";
    std::vector<const FailingCases*> causes;
    causes.reserve(by_cause.size());
    for (const auto& [cause, failing] : by_cause) causes.push_back(&failing);
    std::stable_sort(causes.begin(), causes.end(),
                     [](const auto* a, const auto* b) { return a->runs > b->runs; });
    for (const FailingCases* failing : causes)
        text += fmt::format(
            "<h3>{}, {} of {}</h3>\n{}", outcome(*failing->example), counted(failing->runs, "run", "runs"),
            counted(failing->programs.size(), "program", "programs"), list_of_programs(*failing));
    return text;
}

}  // namespace

std::string front_page(const Night& night, const Changes& changes, const Whys& whys) {
    const BatchFacts& latest = night.latest;
    const std::string plan = latest.plan.empty() ? std::string() : latest.plan + ", ";
    return whole_page(kFrontPage, "Check of " + plan + plainly_named(latest), "",
                      head_text(night) + ChangesText(night, changes, whys).text() + failing_text(night) +
                          "<h2>All runs</h2>\n" + cases_text(night, 0));
}

}  // namespace gsim::batch
