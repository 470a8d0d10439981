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
#include "batch/pages/run_book.h"
#include "batch/pages/site.h"

namespace gsim::batch {

namespace {

using Done = tl::expected<void, std::string>;
using Fault = tl::unexpected<std::string>;

constexpr std::size_t kMostViews = 200;  // each has a megabyte and more

/// Views are chosen in the order in which users read them in the morning.
std::unordered_set<std::size_t> chosen_for_views(const Night& night, const Changes& changes) {
    std::unordered_set<std::size_t> chosen;
    const auto choose = [&](std::size_t place) {
        if (chosen.size() < kMostViews && night.cases[place].has_details) chosen.insert(place);
    };
    for (const auto* places : {&changes.newly_failing, &changes.mended, &changes.other_times,
                               &changes.other_findings, &changes.fresh})
        std::for_each(places->begin(), places->end(), choose);
    for (std::size_t i = 0; i < night.cases.size(); ++i) {
        const Case& of = night.cases[i];
        if (of.now != nullptr && !of.now->is_clean()) choose(i);
    }
    return chosen;
}

/// Writer of all pages of one nightly report.
class PagesWriter {
  public:
    PagesWriter(const Night& night, RunBook& book, Site& site, const PagesOptions& options)
        : night_(night), book_(book), site_(site), options_(options) {
        if (options.views) views_.emplace(options.folder, *options.views);
    }

    /// Pages that the front page links to are written before it, and removed after it.
    Done write() {
        const auto changes = find_changes(night_, book_);
        if (!changes) return Fault(changes.error());
        if (views_) chosen_ = chosen_for_views(night_, *changes);
        for (const ProgramCases& program : night_.programs) {
            if (auto written = write_program(program); !written) return written;
        }
        for (const auto& [name, page] : further_pages(night_)) {
            if (auto put = site_.put(name, page); !put) return put;
        }
        return write_front(*changes).and_then([&] { return site_.remove_others(); }).and_then([&] {
            return remove_views(options_.folder, views_ ? &*views_ : nullptr);
        });
    }

  private:
    Done write_program(const ProgramCases& program) {
        std::vector<CaseDetails> all;
        for (const std::size_t place : program.cases) {
            const Case& of = night_.cases[place];
            if (!of.has_details) continue;
            auto now = book_.read(of.now->id);
            if (!now) return Fault(now.error());
            auto reasons = reasons_of(of);
            if (!reasons) return Fault(reasons.error());
            CaseDetails details{&of, *std::move(now), *std::move(reasons)};
            if (chosen_.contains(place)) add_view(details);
            all.push_back(std::move(details));
        }
        return site_.put(program.page, program_page(night_, program, all));
    }

    void add_view(CaseDetails& details) {
        auto view = views_->make(*details.of->now, details.now);
        (view ? details.view : details.why_no_view) = view ? *view : view.error();
    }

    Done write_front(const Changes& changes) {
        Whys whys;
        for (const auto* places :
             {&changes.newly_failing, &changes.mended, &changes.other_times, &changes.other_findings}) {
            for (std::size_t i = 0; i < std::min(places->size(), kMostListed); ++i) {
                const std::size_t place = (*places)[i];
                const auto reasons = reasons_of(night_.cases[place]);
                if (!reasons) return Fault(reasons.error());
                whys[place] = reasons_text(*reasons);
            }
        }
        return site_.put(kFrontPage, front_page(night_, changes, whys));
    }

    tl::expected<std::vector<std::string>, std::string> reasons_of(const Case& of) {
        if (of.before == nullptr || of.before == of.now) return {};
        const auto before = book_.read(of.before->id);
        if (!before) return Fault(before.error());
        const auto now = book_.read(of.now->id);
        if (!now) return Fault(now.error());
        return why_anew(*before, *now);
    }

    const Night& night_;
    RunBook& book_;
    Site& site_;
    const PagesOptions& options_;
    std::optional<Views> views_;
    std::unordered_set<std::size_t> chosen_;  // cases of which there are pages of finished runs
};

}  // namespace

Done write_pages(Database& results, const PagesOptions& options) {
    // The transaction reads one state, even if a batch is still running. Later no transaction is needed: runs
    // do not change, and writers must not wait for pages.
    if (auto begun = results.execute("BEGIN"); !begun) return begun;
    const auto night = read_night(results, options.since);
    auto ended = results.execute("COMMIT");
    if (!night) return Fault(night.error());
    if (!ended) return ended;
    auto book = RunBook::open(results);
    if (!book) return Fault(book.error());
    auto site = Site::open(options.folder);
    if (!site) return Fault(site.error());
    return PagesWriter(*night, *book, *site, options).write();
}

}  // namespace gsim::batch
