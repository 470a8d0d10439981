#include "batch/pages/history_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

constexpr double kWidth_px = 640, kHeight_px = 150, kSide_px = 12, kTop_px = 14, kBottom_px = 24;

/// Coordinates in the picture.
class Axes {
  public:
    Axes(const Night& night, const Case& of) : batches_(static_cast<double>(night.batches.size())) {
        for (const PastRun& past : of.history) {
            if (!past.run->has_time()) continue;
            least_s_ = has_times_ ? std::min(least_s_, past.run->time_s) : past.run->time_s;
            most_s_ = has_times_ ? std::max(most_s_, past.run->time_s) : past.run->time_s;
            has_times_ = true;
        }
    }

    bool has_times() const { return has_times_; }
    double least_s() const { return least_s_; }
    double most_s() const { return most_s_; }
    double x(std::size_t batch) const {
        const double share = batches_ > 1 ? static_cast<double>(batch) / (batches_ - 1) : 0.5;
        return kSide_px + share * (kWidth_px - 2 * kSide_px);
    }
    double y(double time_s) const {
        const double span_s = most_s_ - least_s_;
        const double share = span_s > 0 ? (time_s - least_s_) / span_s : 0.5;
        return kHeight_px - kBottom_px - 8 - share * (kHeight_px - kTop_px - kBottom_px - 16);
    }

  private:
    double batches_;
    bool has_times_ = false;
    double least_s_ = 0, most_s_ = 0;
};

std::string mark_of(const Night& night, const PastRun& past, const Axes& axes) {
    const bool has_time = past.run->has_time();
    const double x = axes.x(past.batch), y = has_time ? axes.y(past.run->time_s) : kHeight_px - kBottom_px;
    const BatchFacts& batch = night.batches[past.batch];
    const std::string title =
        fmt::format("<title>batch {}, {}: {}{}</title>", batch.id, shown(batch.began_at.substr(0, 10)),
                    past.run->is_clean() ? std::string() : shown(past.run->status) + ' ',
                    has_time ? seconds(past.run->time_s) + " s" : std::string("no time"));
    if (past.run->is_clean())
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\">{}</circle>", x, y, title);
    return fmt::format("<path d=\"M{:.1f} {:.1f}l8 8m0 -8l-8 8\">{}</path>", x - 4, y - 4, title);
}

/// Draws a dot for each batch in which the case succeeded, a cross if it failed.
std::string picture_of(const Night& night, const Case& of) {
    const Axes axes(night, of);
    if (!axes.has_times() || of.history.size() < 2) return {};
    std::string points, marks;
    for (const PastRun& past : of.history) {
        if (past.run->has_time())
            points += fmt::format("{:.1f},{:.1f} ", axes.x(past.batch), axes.y(past.run->time_s));
        marks += mark_of(night, past, axes);
    }
    return fmt::format(
        "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"Times of {2}: {3} to {4} s\"><polyline "
        "points=\"{5}\"/>{6}<text x=\"{7}\" y=\"12\">{4} s</text><text x=\"{7}\" y=\"{8}\">{3} s at the "
        "lowest, "
        "batch {9} to {10}; a cross: it failed</text></svg>\n",
        kWidth_px, kHeight_px, counted(of.history.size(), "batch", "batches"), seconds(axes.least_s()),
        seconds(axes.most_s()), points, marks, kSide_px, kHeight_px - 6, night.batches.front().id,
        night.batches.back().id);
}

std::string span_of(const std::string& first, const std::string& last) {
    return first == last ? first : fmt::format("{} to {}", first, last);
}

/// Returns the table. A run that the following batches reused is one row.
std::string table_of(const Night& night, const Case& of) {
    TableText table("History", {"Batch", "Began", "Outcome", "Time, s", "Against the row below"});
    const auto& history = of.history;
    for (std::size_t end = history.size(); end > 0;) {
        std::size_t begin = end - 1;
        while (begin > 0 && history[begin - 1].run == history[end - 1].run) --begin;
        const RunFacts& run = *history[begin].run;
        const RunFacts* below = begin > 0 ? history[begin - 1].run : nullptr;
        const bool is_compared = below != nullptr && run.has_time() && below->has_time();
        const BatchFacts& first = night.batches[history[begin].batch];
        const BatchFacts& last = night.batches[history[end - 1].batch];
        table.add({span_of(fmt::format("{}", first.id), fmt::format("{}", last.id)),
                   span_of(moment(first.began_at), moment(last.began_at)), outcome(run), time_of(run),
                   is_compared ? difference(below->time_s, run.time_s) : std::string()});
        end = begin;
    }
    return table.text();
}

std::string last_clean(const Night& night, const Case& of) {
    const auto clean = std::find_if(of.history.rbegin(), of.history.rend(),
                                    [](const PastRun& past) { return past.run->is_clean(); });
    if (clean == of.history.rend()) {
        const bool knows_all = night.older_batches == 0;
        return knows_all ? "It has not been without a fault in any batch of these results."
                         : fmt::format("It has not been without a fault in the last {} batches.",
                                       night.batches.size());
    }
    const BatchFacts& batch = night.batches[clean->batch];
    return batch.id == night.latest.id ? std::string("It is without a fault in the latest batch.")
                                       : fmt::format("It was last without a fault in {}.", named(batch));
}

}  // namespace

std::string history_text(const Night& night, const Case& of) {
    std::string text = fmt::format("<p>{}</p>\n", last_clean(night, of));
    if (of.history.size() > 1) text += picture_of(night, of) + table_of(night, of);
    if (night.older_batches > 0)
        text += fmt::format("<p class=\"soft\">Of {} batches these are the last {}.</p>\n",
                            night.older_batches + static_cast<std::int64_t>(night.batches.size()),
                            night.batches.size());
    return text;
}

}  // namespace gsim::batch
