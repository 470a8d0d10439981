#include <fmt/format.h>

#include "runtime/script/bindings/arc_reader.h"
#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/axis_table.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/words/word_id.h"

namespace gsim::script {

using text::DiagnosticKind;

namespace {

/// Makes the move of a plain arc word with its words as the first argument; upvalues: interpreter, ccw, word
/// id, name.
void move_along_arc(lua_State* state, Interpreter& interpreter) {
    if (lua_isnoneornil(state, 1)) return;
    const bool ccw = lua_toboolean(state, lua_upvalueindex(2)) != 0;
    if (!lua_istable(state, 1)) {
        const char* name = lua_tostring(state, lua_upvalueindex(4));
        interpreter.alarm(state, DiagnosticKind::script,
                          fmt::format("{0} needs its words in braces: {0}{{x=1, y=2}}", name));
    }
    simulation::ArcMove move = read_arc(state, interpreter, ccw, 1);
    move.feed = interpreter.feed(state, move.sweep_rad);
    move.location = interpreter.location();
    interpreter.check(state, interpreter.simulator().moves().enqueue(move));
}

/// Implements G2{..} and G3{..}; upvalues as above.
int arc_word(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    const auto id = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    interpreter.enter(state, id);
    interpreter.make_modal(state, id);
    move_along_arc(state, interpreter);
    return 0;
}

/// Implements move{..} if a plain arc is modal; upvalues as above.
int modal_arc_word(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.enter(state, static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))));
    move_along_arc(state, interpreter);
    return 0;
}

/// Implements core.arc_word(ccw, id, name).
template <int (*Function)(lua_State*)>
int make_arc_word(lua_State* state) {
    const bool ccw = lua_toboolean(state, 1) != 0;
    const lua_Integer id = check_word_id(state, 2);
    luaL_checkstring(state, 3);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushboolean(state, static_cast<int>(ccw));
    lua_pushinteger(state, id);
    lua_pushvalue(state, 3);
    lua_pushcclosure(state, trampoline<Function>, 4);
    return 1;
}

/// Implements core.read_arc(ccw, words): returns the arc in machine coordinates, in the form of core.arc.
/// These are its plane, its sense, its centre along the plane's two directions, its sweep and its target.
int read_arc_words(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    luaL_checktype(state, 2, LUA_TTABLE);
    const simulation::ArcMove move = read_arc(state, interpreter, lua_toboolean(state, 1) != 0, 2);
    const ArcBasis basis = arc_basis(move.normal);
    push_arc_plane(state, move.normal);
    lua_pushboolean(state, static_cast<int>(move.kind == simulation::MoveKind::arc_ccw));
    lua_pushnumber(state, basis.first.dot(move.center_mm));
    lua_pushnumber(state, basis.second.dot(move.center_mm));
    lua_pushnumber(state, move.sweep_rad);
    push_axes(state, interpreter, move.target);
    return 6;
}

/// Implements core.plane_across(x, y, z): returns the plane at right angles to a vector, in the form of
/// core.arc. Also returns true if arcs that are counter-clockwise about the vector are so in that plane.
int plane_across(lua_State* state) {
    const Eigen::Vector3d vector(luaL_checknumber(state, 1), luaL_checknumber(state, 2),
                                 luaL_checknumber(state, 3));
    const Eigen::Vector3d normal = simulation::canonical_normal(vector.normalized());
    push_arc_plane(state, normal);
    lua_pushboolean(state, static_cast<int>(normal.dot(vector) > 0));
    return 2;
}

int plane(lua_State* state) {
    push_plane(state, bound_interpreter(state).modal().plane);
    return 1;
}

int has_absolute_arc_centers(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(bound_interpreter(state).modal().absolute_arc_centers));
    return 1;
}

int set_plane(lua_State* state) {
    bound_interpreter(state).modal().plane = check_plane(state, 1);
    return 0;
}

/// Implements core.set_absolute_arc_centers(on): I, J and K are a point, or a vector from the start.
int set_absolute_arc_centers(lua_State* state) {
    bound_interpreter(state).modal().absolute_arc_centers = lua_toboolean(state, 1) != 0;
    return 0;
}

/// Reads a field of the table that is the first argument; a missing field leaves `value` as it is.
void read_field(lua_State* state, const char* name, double& value) {
    lua_getfield(state, 1, name);
    value = luaL_optnumber(state, -1, value);
    lua_pop(state, 1);
}

/// Implements core.set_arc_rules{...}: the fields of ArcRules by their names.
int set_arc_rules(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    ArcRules& rules = bound_interpreter(state).modal().arc_rules;
    read_field(state, "radii_tolerance_mm", rules.radii_tolerance_mm);
    read_field(state, "radii_tolerance_inch_mm", rules.radii_tolerance_inch_mm);
    read_field(state, "radii_tolerance_share", rules.radii_tolerance_share);
    read_field(state, "radii_tolerance_growth", rules.radii_tolerance_growth);
    read_field(state, "max_radius_shortfall_mm", rules.max_radius_shortfall_mm);
    read_field(state, "turns_tolerance", rules.turns_tolerance);
    return 0;
}

}  // namespace

void add_arc_words(lua_State* state, Interpreter& interpreter) {
    set_function<make_arc_word<arc_word>>(state, "arc_word", &interpreter);
    set_function<make_arc_word<modal_arc_word>>(state, "modal_arc_word", &interpreter);
    set_function<read_arc_words>(state, "read_arc", &interpreter);
    set_function<plane_across>(state, "plane_across", &interpreter);
    set_function<plane>(state, "plane", &interpreter);
    set_function<has_absolute_arc_centers>(state, "has_absolute_arc_centers", &interpreter);
    set_function<set_plane>(state, "set_plane", &interpreter);
    set_function<set_absolute_arc_centers>(state, "set_absolute_arc_centers", &interpreter);
    set_function<set_arc_rules>(state, "set_arc_rules", &interpreter);
}

}  // namespace gsim::script
