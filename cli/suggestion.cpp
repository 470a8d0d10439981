#include "cli/suggestion.h"

#include <fmt/format.h>

#include "base/text/nearest_name.h"

namespace gsim::apps {

std::string did_you_mean(std::string_view word, std::span<const std::string_view> known) {
    const auto nearest = text::nearest_name(word, known);
    return nearest ? fmt::format("; did you mean '{}'?", *nearest) : std::string{};
}

}  // namespace gsim::apps
