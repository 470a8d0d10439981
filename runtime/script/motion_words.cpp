#include "runtime/script/bindings.h"
#include "runtime/script/lua_state.h"

namespace gsim::script {

namespace {

Controller& controller_of(lua_State* state) {
    return bound<Controller>(state);
}

/// Tells the library that a plain line is the modal motion now, so that `move` goes on with it.
void make_modal(lua_State* state, Controller& controller, bool rapid) {
    ModalState& modal = controller.modal();
    if (modal.has_modal_line && modal.modal_rapid == rapid) return;
    modal.has_modal_line = true;
    modal.modal_rapid = rapid;
    lua_rawgeti(state, LUA_REGISTRYINDEX, controller.on_modal_line);
    lua_pushboolean(state, static_cast<int>(rapid));
    lua_call(state, 1, 0);
}

/// G0{..} and G1{..}; upvalues: controller, rapid, word id.
int line_word(lua_State* state) {
    Controller& controller = controller_of(state);
    const bool rapid = lua_toboolean(state, lua_upvalueindex(2)) != 0;
    controller.enter(state, static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))));
    make_modal(state, controller, rapid);
    controller.line(state, rapid, 1);
    return 0;
}

/// move{..} where a plain line is modal; upvalues as above.
int modal_line_word(lua_State* state) {
    Controller& controller = controller_of(state);
    controller.enter(state, static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))));
    controller.line(state, lua_toboolean(state, lua_upvalueindex(2)) != 0, 1);
    return 0;
}

template <int (*Function)(lua_State*)>
int make_word(lua_State* state) {
    const bool rapid = lua_toboolean(state, 1) != 0;
    const lua_Integer id = luaL_checkinteger(state, 2);
    luaL_argcheck(state, id >= 0 && id < static_cast<lua_Integer>(kMaxWordIds), 2, "no word id");
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushboolean(state, static_cast<int>(rapid));
    lua_pushinteger(state, id);
    lua_pushcclosure(state, trampoline<Function>, 3);
    return 1;
}

/// core.line(rapid, words): the move alone, for words that are made of it.
int line(lua_State* state) {
    controller_of(state).line(state, lua_toboolean(state, 1) != 0, 2);
    return 0;
}

int set_on_modal_line(lua_State* state) {
    luaL_checktype(state, 1, LUA_TFUNCTION);
    lua_settop(state, 1);
    controller_of(state).on_modal_line = luaL_ref(state, LUA_REGISTRYINDEX);
    return 0;
}

int forget_modal_line(lua_State* state) {
    controller_of(state).modal().has_modal_line = false;
    return 0;
}

}  // namespace

void add_motion_words(lua_State* state, Controller& controller) {
    set_function<make_word<line_word>>(state, "line_word", &controller);
    set_function<make_word<modal_line_word>>(state, "modal_line_word", &controller);
    set_function<line>(state, "line", &controller);
    set_function<set_on_modal_line>(state, "on_modal_line", &controller);
    set_function<forget_modal_line>(state, "forget_modal_line", &controller);
}

}  // namespace gsim::script
