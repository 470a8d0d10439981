#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/words/word_id.h"

namespace gsim::script {

namespace {

/// Implements G0{..} and G1{..}; upvalues: interpreter, rapid, word id.
int line_word(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    const bool rapid = lua_toboolean(state, lua_upvalueindex(2)) != 0;
    const auto id = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    interpreter.enter(state, id);
    interpreter.make_modal(state, id);
    interpreter.line(state, rapid, 1);
    return 0;
}

/// Implements move{..} if a plain line is modal; upvalues as above.
int modal_line_word(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.enter(state, static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))));
    interpreter.line(state, lua_toboolean(state, lua_upvalueindex(2)) != 0, 1);
    return 0;
}

template <int (*Function)(lua_State*)>
int make_line_word(lua_State* state) {
    const bool rapid = lua_toboolean(state, 1) != 0;
    const lua_Integer id = check_word_id(state, 2);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushboolean(state, static_cast<int>(rapid));
    lua_pushinteger(state, id);
    lua_pushcclosure(state, trampoline<Function>, 3);
    return 1;
}

/// Implements core.line(rapid, words): the move alone, for words that consist of it.
int line(lua_State* state) {
    bound_interpreter(state).line(state, lua_toboolean(state, 1) != 0, 2);
    return 0;
}

/// Implements core.set_modal_tables(environment, names, moves), see Interpreter::ModalTables.
int set_modal_tables(lua_State* state) {
    for (int i = 1; i <= 3; ++i) luaL_checktype(state, i, LUA_TTABLE);
    lua_settop(state, 3);
    Interpreter::ModalTables& tables = bound_interpreter(state).modal_tables;
    for (int* reference : {&tables.moves, &tables.names, &tables.environment})
        *reference = luaL_ref(state, LUA_REGISTRYINDEX);
    return 0;
}

/// Implements core.make_modal(id): that motion is modal, and `move` continues with it, whatever it was.
int make_modal(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.modal().modal_word = kMaxWordIds;
    interpreter.make_modal(state, static_cast<std::size_t>(check_word_id(state, 1)));
    return 0;
}

/// Implements core.motion(): the name of the modal motion.
int motion(lua_State* state) {
    bound_interpreter(state).push_motion(state);
    return 1;
}

/// Implements core.motion_id(), for core.make_modal().
int motion_id(lua_State* state) {
    lua_pushinteger(state, static_cast<lua_Integer>(bound_interpreter(state).modal().modal_word));
    return 1;
}

}  // namespace

void add_motion_words(lua_State* state, Interpreter& interpreter) {
    set_function<make_line_word<line_word>>(state, "line_word", &interpreter);
    set_function<make_line_word<modal_line_word>>(state, "modal_line_word", &interpreter);
    set_function<line>(state, "line", &interpreter);
    set_function<set_modal_tables>(state, "set_modal_tables", &interpreter);
    set_function<make_modal>(state, "make_modal", &interpreter);
    set_function<motion>(state, "motion", &interpreter);
    set_function<motion_id>(state, "motion_id", &interpreter);
}

}  // namespace gsim::script
