#include "calibrate/times/record_clock.h"

#include <chrono>

#include "base/text/read_number.h"

namespace gsim::calibrate {

namespace {

std::optional<double> take_number(std::string_view& text) {
    double value = 0;
    const auto read = text::read_number(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return value;
}

std::optional<int> take_digits(std::string_view& text, std::size_t least, std::size_t most) {
    std::size_t count = 0;
    int value = 0;
    while (count < most && count < text.size() && text[count] >= '0' && text[count] <= '9')
        value = 10 * value + (text[count++] - '0');
    if (count < least) return std::nullopt;
    text.remove_prefix(count);
    return value;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

/// Returns the days since 1970.
std::optional<double> take_date(std::string_view& text) {
    const auto year = take_digits(text, 4, 4);
    if (!year || !take(text, '-')) return std::nullopt;
    const auto month = take_digits(text, 2, 2);
    if (!month || !take(text, '-')) return std::nullopt;
    const auto day = take_digits(text, 2, 2);
    if (!day || !(take(text, 'T') || take(text, ' '))) return std::nullopt;
    using namespace std::chrono;
    const year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                              std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok()) return std::nullopt;
    return static_cast<double>(sys_days(date).time_since_epoch().count());
}

std::optional<double> take_time_of_day(std::string_view& text) {
    const auto hours = take_digits(text, 1, 2);
    if (!hours || !take(text, ':')) return std::nullopt;
    const auto minutes = take_digits(text, 2, 2);
    if (!minutes || !take(text, ':')) return std::nullopt;
    const auto seconds = take_number(text);
    if (!seconds || *seconds < 0 || *seconds >= 61) return std::nullopt;
    return 3600.0 * *hours + 60.0 * *minutes + *seconds;
}

template <typename Take>
auto attempt(std::string_view& text, const Take& take_it) {
    std::string_view rest = text;
    auto found = take_it(rest);
    if (found) text = rest;
    return found;
}

}  // namespace

std::optional<double> take_time_s(std::string_view& line) {
    constexpr double kDay_s = 86400;
    std::string_view rest = line;
    const bool bracket = take(rest, '[');
    const auto days = attempt(rest, take_date);
    auto time_s = attempt(rest, take_time_of_day);
    if (!time_s && !days) time_s = attempt(rest, take_number);
    if (!time_s) return std::nullopt;
    take(rest, 'Z');
    if (bracket && !take(rest, ']')) return std::nullopt;
    line = rest;
    return *time_s + days.value_or(0) * kDay_s;
}

}  // namespace gsim::calibrate
