#include "batch/pages/pages.h"

#include <algorithm>

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

/// Makes all pages of one night.
class PagesWriter {
  public:
    PagesWriter(const Night& night, RunBook& book, Site& site) : night_(night), book_(book), site_(site) {}

    /// What the front page leads to is there before it is.
    Done write() {
        for (const ProgramCases& program : night_.programs) {
            if (auto written = write_program(program); !written) return written;
        }
        for (const auto& [name, page] : further_pages(night_)) {
            if (auto put = site_.put(name, page); !put) return put;
        }
        return write_front().and_then([&] { return site_.remove_others(); });
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
            all.push_back({&of, *std::move(now), *std::move(reasons)});
        }
        return site_.put(program.page, program_page(night_, program, all));
    }

    Done write_front() {
        const auto changes = find_changes(night_, book_);
        if (!changes) return Fault(changes.error());
        Whys whys;
        for (const auto* places :
             {&changes->newly_failing, &changes->mended, &changes->other_times, &changes->other_findings}) {
            for (std::size_t i = 0; i < std::min(places->size(), kMostListed); ++i) {
                const std::size_t place = (*places)[i];
                const auto reasons = reasons_of(night_.cases[place]);
                if (!reasons) return Fault(reasons.error());
                whys[place] = reasons_text(*reasons);
            }
        }
        return site_.put(kFrontPage, front_page(night_, *changes, whys));
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
};

}  // namespace

Done write_pages(Database& results, const std::string& folder, std::int64_t since) {
    // All that is read is of one moment, also where a batch goes on meanwhile.
    if (auto begun = results.execute("BEGIN"); !begun) return begun;
    const auto write = [&]() -> Done {
        const auto night = read_night(results, since);
        if (!night) return Fault(night.error());
        auto book = RunBook::open(results);
        if (!book) return Fault(book.error());
        auto site = Site::open(folder);
        if (!site) return Fault(site.error());
        return PagesWriter(*night, *book, *site).write();
    };
    Done written = write();
    const auto ended = results.execute("COMMIT");
    return written ? ended : written;
}

}  // namespace gsim::batch
