#pragma once

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"

namespace gsim::script {

/// Returns the id of a word, as the library numbers them; raises an error of Lua if the argument is none.
inline lua_Integer check_word_id(lua_State* state, int argument) {
    const lua_Integer id = luaL_checkinteger(state, argument);
    luaL_argcheck(state, id >= 0 && id < static_cast<lua_Integer>(kMaxWordIds), argument, "no word id");
    return id;
}

}  // namespace gsim::script
