#include "runtime/script/lua/check_option.h"

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/text/nearest_name.h"

namespace gsim::script {

int check_option(lua_State* state, int argument, const char* fallback, std::span<const char* const> names) {
    const std::string_view given =
        fallback != nullptr ? luaL_optstring(state, argument, fallback) : luaL_checkstring(state, argument);
    std::vector<std::string_view> known;
    std::string list;
    for (const char* const name : names.first(names.size() - 1)) {
        if (given == name) return static_cast<int>(known.size());
        known.emplace_back(name);
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
    }
    const auto nearest = text::nearest_name(given, known);
    const std::string hint = nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : "";
    return luaL_argerror(state, argument, fmt::format("'{}' must be one of {}{}", given, list, hint).c_str());
}

}  // namespace gsim::script
