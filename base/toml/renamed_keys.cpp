#include "base/toml/renamed_keys.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace gsim::base {

namespace {

struct RenamedKey {
    std::string_view table, old_name, name;
};

constexpr std::array kRenamedKeys{
    RenamedKey{"[controller]", "rest_s", "standstill_s"},
    RenamedKey{"[controller]", "own_ramps", "independent_ramps"},
    RenamedKey{"[controller]", "least_feed_mm_min", "min_feed_mm_min"},
    RenamedKey{"[calibration]", "left_percent", "residual_percent"},
    RenamedKey{"[lag]", "least_feed_share", "min_feed_share"},
    RenamedKey{"[pierce]", "least_s", "min_s"},
    RenamedKey{"[pierce]", "moving_share", "dynamic_share"},
    RenamedKey{"[objective]", "most_s", "cycle_time_max_s"},
    RenamedKey{"[[limit]]", "figure", "metric"},
    RenamedKey{"[[limit]]", "least", "min"},
    RenamedKey{"[[limit]]", "most", "max"},
};

template <typename Predicate>
const RenamedKey* find(const Predicate& matches) {
    const auto found = std::find_if(kRenamedKeys.begin(), kRenamedKeys.end(), matches);
    return found == kRenamedKeys.end() ? nullptr : &*found;
}

}  // namespace

std::optional<std::string_view> old_key_name(std::string_view table, std::string_view key) {
    const RenamedKey* found =
        find([&](const RenamedKey& each) { return each.table == table && each.name == key; });
    return found != nullptr ? std::optional(found->old_name) : std::nullopt;
}

std::optional<std::string_view> renamed_key(std::string_view table, std::string_view old_name) {
    const RenamedKey* found =
        find([&](const RenamedKey& each) { return each.table == table && each.old_name == old_name; });
    return found != nullptr ? std::optional(found->name) : std::nullopt;
}

std::string deprecated_key_text(std::string_view old_name, std::string_view name) {
    return fmt::format("'{}' is named '{}' now; the old name is an error from 0.3 on", old_name, name);
}

}  // namespace gsim::base
