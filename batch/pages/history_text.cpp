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
    Axes(const NightlyReport& report, const Case& of) : batches_(static_cast<double>(report.batches.size())) {
        for (const HistoryEntry& entry : of.history) {
            if (!entry.run->has_time()) continue;
            min_s_ = has_times_ ? std::min(min_s_, entry.run->time_s) : entry.run->time_s;
            max_s_ = has_times_ ? std::max(max_s_, entry.run->time_s) : entry.run->time_s;
            has_times_ = true;
        }
    }

    bool has_times() const { return has_times_; }
    double min_s() const { return min_s_; }
    double max_s() const { return max_s_; }
    double x(std::size_t batch) const {
        const double share = batches_ > 1 ? static_cast<double>(batch) / (batches_ - 1) : 0.5;
        return kSide_px + share * (kWidth_px - 2 * kSide_px);
    }
    double y(double time_s) const {
        const double span_s = max_s_ - min_s_;
        const double share = span_s > 0 ? (time_s - min_s_) / span_s : 0.5;
        return kHeight_px - kBottom_px - 8 - share * (kHeight_px - kTop_px - kBottom_px - 16);
    }

  private:
    double batches_;
    bool has_times_ = false;
    double min_s_ = 0, max_s_ = 0;
};

std::string point_mark(const NightlyReport& report, const HistoryEntry& entry, const Axes& axes) {
    const bool has_time = entry.run->has_time();
    const double x = axes.x(entry.batch), y = has_time ? axes.y(entry.run->time_s) : kHeight_px - kBottom_px;
    const BatchSummary& batch = report.batches[entry.batch];
    const std::string title = fmt::format(
        "<title>batch {}, {}: {}{}</title>", batch.id, escape_html(batch.started_at.substr(0, 10)),
        entry.run->is_clean() ? std::string() : escape_html(entry.run->status) + ' ',
        has_time ? seconds(entry.run->time_s) + " s" : std::string("no time"));
    if (entry.run->is_clean())
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\">{}</circle>", x, y, title);
    return fmt::format("<path d=\"M{:.1f} {:.1f}l8 8m0 -8l-8 8\">{}</path>", x - 4, y - 4, title);
}

/// Draws a dot for each batch in which the case succeeded, a cross if it failed.
std::string times_picture(const NightlyReport& report, const Case& of) {
    const Axes axes(report, of);
    if (!axes.has_times() || of.history.size() < 2) return {};
    std::string points, marks;
    for (const HistoryEntry& entry : of.history) {
        if (entry.run->has_time())
            points += fmt::format("{:.1f},{:.1f} ", axes.x(entry.batch), axes.y(entry.run->time_s));
        marks += point_mark(report, entry, axes);
    }
    return fmt::format(
        "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"Times of {2}: {3} to {4} s\"><polyline "
        "points=\"{5}\"/>{6}<text x=\"{7}\" y=\"12\">{4} s</text><text x=\"{7}\" y=\"{8}\">min {3} s, batch "
        "{9} to {10}; a cross: failed run</text></svg>\n",
        kWidth_px, kHeight_px, count_text(of.history.size(), "batch", "batches"), seconds(axes.min_s()),
        seconds(axes.max_s()), points, marks, kSide_px, kHeight_px - 6, report.batches.front().id,
        report.batches.back().id);
}

std::string range_text(const std::string& first, const std::string& last) {
    return first == last ? first : fmt::format("{} to {}", first, last);
}

/// Returns the table. A run that the following batches reused is one row.
std::string history_table(const NightlyReport& report, const Case& of) {
    HtmlTable table("History", {"Batch", "Started", "Outcome", "Time, s", "Difference to the row below"});
    const auto& history = of.history;
    for (std::size_t end = history.size(); end > 0;) {
        std::size_t begin = end - 1;
        while (begin > 0 && history[begin - 1].run == history[end - 1].run) --begin;
        const RunSummary& run = *history[begin].run;
        const RunSummary* below = begin > 0 ? history[begin - 1].run : nullptr;
        const bool is_compared = below != nullptr && run.has_time() && below->has_time();
        const BatchSummary& first = report.batches[history[begin].batch];
        const BatchSummary& last = report.batches[history[end - 1].batch];
        table.add({range_text(fmt::format("{}", first.id), fmt::format("{}", last.id)),
                   range_text(time_markup(first.started_at), time_markup(last.started_at)), outcome(run),
                   time_text(run), is_compared ? difference(below->time_s, run.time_s) : std::string()});
        end = begin;
    }
    return table.text();
}

std::string last_clean_text(const NightlyReport& report, const Case& of) {
    const auto last_clean_run = std::find_if(of.history.rbegin(), of.history.rend(),
                                             [](const HistoryEntry& entry) { return entry.run->is_clean(); });
    if (last_clean_run == of.history.rend()) {
        const bool is_full_history = report.older_batches == 0;
        return is_full_history
                   ? "It has had errors in all batches of these results."
                   : fmt::format("It has had errors in all of the last {} batches.", report.batches.size());
    }
    const BatchSummary& batch = report.batches[last_clean_run->batch];
    return batch.id == report.latest.id
               ? std::string("It has no errors in the latest batch.")
               : fmt::format("It was last without errors in {}.", batch_label(batch));
}

}  // namespace

std::string history_text(const NightlyReport& report, const Case& of) {
    std::string text = fmt::format("<p>{}</p>\n", last_clean_text(report, of));
    if (of.history.size() > 1) text += times_picture(report, of) + history_table(report, of);
    if (report.older_batches > 0)
        text += fmt::format("<p class=\"soft\">Of {} batches, only the last {} are shown.</p>\n",
                            report.older_batches + static_cast<std::int64_t>(report.batches.size()),
                            report.batches.size());
    return text;
}

}  // namespace gsim::batch
