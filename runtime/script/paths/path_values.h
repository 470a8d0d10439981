#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <lua.hpp>
#include <tl/expected.hpp>

#include "toolpath/json/path_draft.h"
#include "toolpath/json/target_draft.h"

namespace gsim::script::path_values {

// What paths hold, from tables of a script. What is wrong is raised as an error of Lua, with the place of the
// script; these pass as exceptions, so that destructors run.

[[noreturn]] void raise(lua_State* state, const std::string& sentence);
void check(lua_State* state, const tl::expected<void, std::string>& done);

/// A string on the stack, as long as it stays there.
std::string_view text_at(lua_State* state, int index);

/// A value of a target; it is on top of the stack.
void read_value(lua_State* state, path::TargetDraft& draft, path::TargetKey key);

/// The keys of a path that say where it is and with what it works; the first ones are those of a use of it,
/// too.
inline constexpr auto kSetUpKeys = std::span(path::kPathKeys).subspan(path::kNeededPathKeys);
inline constexpr auto kFrameKeys = kSetUpKeys.first(3);
static_assert(kFrameKeys.back() == path::name_of(path::PathKey::probe_offset));

/// Those of the first so many of kSetUpKeys that a table has.
path::PathDraft read_set_up(lua_State* state, int table, std::size_t keys);

}  // namespace gsim::script::path_values
