#define TOML_IMPLEMENTATION
#include "base/toml/toml_section.h"

#include "base/text/file_format.h"
#include "base/toml/toml_bounds.h"

namespace gsim::base {

namespace {

constexpr double kMaxTomlNumber = 1e9;  // mm or deg; far beyond any machine, far from overflow
constexpr double kMinStep = 1e-6;       // a nanometre, a microsecond
constexpr double kMaxCount = 1e5;       // blocks; a few hundred bytes each

/// Checks and removes the format of a file, which is the same key in all of them.
void check_format(FirstError& error, toml::table& table) {
    const toml::node* node = table.get("format");
    if (!node) return;
    const auto number = node->value_exact<std::int64_t>();
    const auto format_error = number ? text::find_format_error(static_cast<double>(*number))
                                     : std::optional<Error>("'format' must be an integer");
    if (format_error) error.report(node->source().begin, format_error->message);
    table.erase("format");
}

}  // namespace

toml::table parse_toml(FirstError& error, std::string_view toml_text) {
    if (const auto excess = find_toml_bounds_error(toml_text)) {
        error.report(
            {static_cast<toml::source_index>(excess->line), static_cast<toml::source_index>(excess->column)},
            excess->message);
        return {};
    }
    toml::parse_result parsed = toml::parse(toml_text);
    if (parsed) {
        toml::table table = std::move(parsed).table();
        check_format(error, table);
        return table;
    }
    error.report(parsed.error().source().begin, parsed.error().description());
    return {};
}

std::optional<std::string_view> TomlSection::find_error(double value, NumberRule rule) {
    if (std::isnan(value)) return "a number";
    const bool may_be_infinite = rule == NumberRule::any || rule == NumberRule::positive;
    if (std::isinf(value) && !may_be_infinite) return "finite";
    if (std::isfinite(value) && std::abs(value) > kMaxTomlNumber) return "between -1e9 and 1e9";
    switch (rule) {
        case NumberRule::finite:
        case NumberRule::any: return std::nullopt;
        case NumberRule::positive:
            if (value <= 0) return "greater than 0";
            return std::nullopt;
        case NumberRule::not_negative:
            if (value < 0) return "0 or greater";
            return std::nullopt;
        case NumberRule::step:
            if (value != 0 && value < kMinStep) return "0, or 1e-6 or greater";
            return std::nullopt;
        case NumberRule::share:
            if (value <= 0 || value > 1) return "greater than 0 and at most 1";
            return std::nullopt;
        case NumberRule::part:
            if (value < 0 || value >= 1) return "0 or greater and less than 1";
            return std::nullopt;
        case NumberRule::percent:
            if (value <= 0 || value > 100) return "greater than 0 and at most 100";
            return std::nullopt;
        case NumberRule::count:
            if (value < 1 || value > kMaxCount || value != std::floor(value))
                return "an integer between 1 and 100000";
            return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace gsim::base
