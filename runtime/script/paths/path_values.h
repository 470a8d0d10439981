#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <lua.hpp>

#include "base/error.h"
#include "toolpath/json/path_draft.h"
#include "toolpath/json/target_draft.h"

namespace gsim::script::path_values {

// Values of paths from tables of a script. Errors are raised as errors of Lua with the source location of the
// script. They pass as exceptions, so that destructors run.

[[noreturn]] void raise(lua_State* state, const std::string& message);
void check(lua_State* state, const Result<void>& done);

/// Returns a string on the stack, valid as long as it stays there.
std::string_view text_at(lua_State* state, int index);

/// Reads a value of a target, which is on top of the stack.
void read_value(lua_State* state, path::TargetDraft& draft, path::TargetKey key);

/// Keys of a path for its location and its tool; the first ones are also those of a use of it.
inline constexpr auto kSetUpKeys = std::span(path::kPathKeys).subspan(path::kRequiredPathKeys);
inline constexpr auto kFrameKeys = kSetUpKeys.first(3);
static_assert(kFrameKeys.back() == path::key_name(path::PathKey::probe_offset));

/// Reads those of the first `keys` entries of kSetUpKeys that a table has.
path::PathDraft read_set_up(lua_State* state, int table, std::size_t keys);

}  // namespace gsim::script::path_values
