#include "tests/accuracy/outcome.h"

#include <array>
#include <cmath>
#include <limits>

namespace gsim::accuracy {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kMarks{"good"sv, "fair"sv, "OFF"sv, "REFUSED"sv, "not counted"sv};

}  // namespace

double TimeOutcome::error_percent() const {
    const double error = error_s();
    if (error == 0) return 0;
    if (recorded_s == 0) return std::copysign(std::numeric_limits<double>::infinity(), error);
    return 100 * error / recorded_s;
}

std::string_view name(Mark mark) {
    return kMarks[static_cast<std::size_t>(mark)];
}

Mark mark(const TimeOutcome& outcome, const Controller& controller) {
    if (!outcome.counted) return Mark::not_counted;
    if (!outcome.found_s) return Mark::rejected;
    if (controller.close.is_within(outcome.error_s(), outcome.recorded_s)) return Mark::close;
    return controller.fair.is_within(outcome.error_s(), outcome.recorded_s) ? Mark::fair : Mark::off;
}

bool Summary::good() const {
    return 100 * close >= close_percent * counted && 100 * (counted - unknown) >= fair_percent * counted;
}

Summary summarize(std::span<const TimeOutcome> outcomes, const Controller& controller) {
    Summary summary;
    summary.close_percent = controller.close_percent;
    summary.fair_percent = controller.fair_percent;
    for (const TimeOutcome& outcome : outcomes) {
        if (!outcome.counted) continue;
        ++summary.counted;
        const Mark marked = mark(outcome, controller);
        if (marked == Mark::close) ++summary.close;
        if (marked == Mark::close || marked == Mark::fair) {
            ++summary.fair;
        } else if (outcome.known.empty()) {
            ++summary.unknown;
        }
        if (!outcome.found_s) continue;
        if (!summary.largest ||
            std::abs(outcome.error_percent()) > std::abs(summary.largest->error_percent()))
            summary.largest = outcome;
    }
    return summary;
}

}  // namespace gsim::accuracy
