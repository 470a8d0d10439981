#include "batch/pages/pages.h"

#include <algorithm>
#include <unordered_set>
#include <utility>
#include <vector>

#include "batch/pages/all_cases.h"
#include "batch/pages/case_text.h"
#include "batch/pages/changes.h"
#include "batch/pages/front_page.h"
#include "batch/pages/program_page.h"
#include "batch/pages/run_history.h"
#include "batch/pages/site.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kMaxViews = 200;  // each has a megabyte and more

/// Views are chosen in the order in which users read them in the morning.
std::unordered_set<std::size_t> select_views(const NightlyReport& report, const Changes& changes) {
    std::unordered_set<std::size_t> selected;
    const auto choose = [&](std::size_t position) {
        if (selected.size() < kMaxViews && report.cases[position].has_details) selected.insert(position);
    };
    for (const auto* positions : {&changes.newly_failing, &changes.fixed, &changes.changed_times,
                                  &changes.changed_findings, &changes.added})
        std::for_each(positions->begin(), positions->end(), choose);
    for (std::size_t i = 0; i < report.cases.size(); ++i) {
        const Case& of = report.cases[i];
        if (of.now != nullptr && !of.now->is_clean()) choose(i);
    }
    return selected;
}

/// Writer of all pages of one nightly report.
class PagesWriter {
  public:
    PagesWriter(const NightlyReport& report, RunHistory& run_history, Site& site, const PagesOptions& options)
        : report_(report), run_history_(run_history), site_(site), options_(options) {
        if (options.views) views_.emplace(options.folder, *options.views);
    }

    /// Pages that the front page links to are written before it, and removed after it.
    Result<void> write() {
        const auto changes = find_changes(report_, run_history_);
        if (!changes) return Unexpected(changes.error());
        if (views_) selected_ = select_views(report_, *changes);
        for (const ProgramCases& program : report_.programs) {
            if (auto written = write_program(program); !written) return written;
        }
        for (const auto& [name, page] : additional_pages(report_)) {
            if (auto save = site_.save(name, page); !save) return save;
        }
        return write_front(*changes).and_then([&] { return site_.remove_stale_pages(); }).and_then([&] {
            return remove_views(options_.folder, views_ ? &*views_ : nullptr);
        });
    }

  private:
    Result<void> write_program(const ProgramCases& program) {
        std::vector<CaseDetails> all;
        for (const std::size_t position : program.cases) {
            const Case& of = report_.cases[position];
            if (!of.has_details) continue;
            auto now = run_history_.read(of.now->id);
            if (!now) return Unexpected(now.error());
            auto reasons = find_rerun_reasons(of);
            if (!reasons) return Unexpected(reasons.error());
            CaseDetails details{&of, *std::move(now), *std::move(reasons)};
            if (selected_.contains(position)) add_view(details);
            all.push_back(std::move(details));
        }
        return site_.save(program.page, program_page(report_, program, all));
    }

    void add_view(CaseDetails& details) {
        auto view = views_->make(*details.of->now, details.now);
        (view ? details.view : details.view_error) = view ? *view : view.error().message;
    }

    Result<void> write_front(const Changes& changes) {
        ReasonsByCase reasons_by_case;
        for (const auto* positions :
             {&changes.newly_failing, &changes.fixed, &changes.changed_times, &changes.changed_findings}) {
            for (std::size_t i = 0; i < std::min(positions->size(), kMaxListed); ++i) {
                const std::size_t position = (*positions)[i];
                const auto reasons = find_rerun_reasons(report_.cases[position]);
                if (!reasons) return Unexpected(reasons.error());
                reasons_by_case[position] = reasons_text(*reasons);
            }
        }
        return site_.save(kFrontPage, front_page(report_, changes, reasons_by_case));
    }

    Result<std::vector<std::string>> find_rerun_reasons(const Case& of) {
        if (of.before == nullptr || of.before == of.now) return {};
        const auto before = run_history_.read(of.before->id);
        if (!before) return Unexpected(before.error());
        const auto now = run_history_.read(of.now->id);
        if (!now) return Unexpected(now.error());
        return rerun_reasons(*before, *now);
    }

    const NightlyReport& report_;
    RunHistory& run_history_;
    Site& site_;
    const PagesOptions& options_;
    std::optional<Views> views_;
    std::unordered_set<std::size_t> selected_;  // cases of which there are pages of finished runs
};

}  // namespace

Result<void> write_pages(Database& results, const PagesOptions& options) {
    // The transaction reads one state, even if a batch is still running. Later no transaction is needed: runs
    // do not change, and writers must not wait for pages.
    if (auto begun = results.execute("BEGIN"); !begun) return begun;
    const auto report = read_nightly_report(results, options.since);
    auto ended = results.execute("COMMIT");
    if (!report) return Unexpected(report.error());
    if (!ended) return ended;
    auto run_history = RunHistory::open(results);
    if (!run_history) return Unexpected(run_history.error());
    auto site = Site::open(options.folder);
    if (!site) return Unexpected(site.error());
    return PagesWriter(*report, *run_history, *site, options).write();
}

}  // namespace gsim::batch
