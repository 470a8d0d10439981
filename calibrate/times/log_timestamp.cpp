#include "calibrate/times/log_timestamp.h"

#include <chrono>

#include "base/text/read_number.h"

namespace gsim::calibrate {

namespace {

std::optional<double> consume_number(std::string_view& text) {
    double value = 0;
    const auto read = text::read_number(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return value;
}

std::optional<int> consume_digits(std::string_view& text, std::size_t min, std::size_t max) {
    std::size_t count = 0;
    int value = 0;
    while (count < max && count < text.size() && text[count] >= '0' && text[count] <= '9')
        value = 10 * value + (text[count++] - '0');
    if (count < min) return std::nullopt;
    text.remove_prefix(count);
    return value;
}

bool consume_character(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

/// Returns the days since 1970.
std::optional<double> consume_date(std::string_view& text) {
    const auto year = consume_digits(text, 4, 4);
    if (!year || !consume_character(text, '-')) return std::nullopt;
    const auto month = consume_digits(text, 2, 2);
    if (!month || !consume_character(text, '-')) return std::nullopt;
    const auto day = consume_digits(text, 2, 2);
    if (!day || !(consume_character(text, 'T') || consume_character(text, ' '))) return std::nullopt;
    using namespace std::chrono;
    const year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                              std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok()) return std::nullopt;
    return static_cast<double>(sys_days(date).time_since_epoch().count());
}

std::optional<double> consume_time_of_day(std::string_view& text) {
    const auto hours = consume_digits(text, 1, 2);
    if (!hours || !consume_character(text, ':')) return std::nullopt;
    const auto minutes = consume_digits(text, 2, 2);
    if (!minutes || !consume_character(text, ':')) return std::nullopt;
    const auto seconds = consume_number(text);
    if (!seconds || *seconds < 0 || *seconds >= 61) return std::nullopt;
    return 3600.0 * *hours + 60.0 * *minutes + *seconds;
}

template <typename Parse>
auto try_consume(std::string_view& text, const Parse& consume) {
    std::string_view remaining = text;
    auto found = consume(remaining);
    if (found) text = remaining;
    return found;
}

}  // namespace

std::optional<double> consume_time_s(std::string_view& line) {
    constexpr double kDay_s = 86400;
    std::string_view remaining = line;
    const bool bracket = consume_character(remaining, '[');
    const auto days = try_consume(remaining, consume_date);
    auto time_s = try_consume(remaining, consume_time_of_day);
    if (!time_s && !days) time_s = try_consume(remaining, consume_number);
    if (!time_s) return std::nullopt;
    consume_character(remaining, 'Z');
    if (bracket && !consume_character(remaining, ']')) return std::nullopt;
    line = remaining;
    return *time_s + days.value_or(0) * kDay_s;
}

}  // namespace gsim::calibrate
