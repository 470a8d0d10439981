#include "runtime/script/control.h"

#include <stdexcept>

#include "runtime/machine/homes.h"
#include "runtime/script/bindings.h"
#include "runtime/script/data_tables.h"
#include "runtime/script/lua_state.h"
#include "runtime/script/sandbox.h"

namespace gsim::script {

namespace {

void set_number(lua_State* state, const char* name, double value) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
}

/// core.corner_override.percent, .before_mm, .after_mm and .angle_deg; the table of core is on top of the
/// stack.
void set_corner_override(lua_State* state, const rrs::ControllerRules& rules) {
    lua_createtable(state, 0, 4);
    set_number(state, "percent", rules.corner_override_percent);
    set_number(state, "before_mm", rules.corner_override_before_mm);
    set_number(state, "after_mm", rules.corner_override_after_mm);
    set_number(state, "angle_deg", rules.corner_override_angle_deg);
    lua_setfield(state, -2, "corner_override");
}

}  // namespace

void load_text(lua_State* state, const std::string& text, const char* name) {
    if (luaL_loadbufferx(state, text.data(), text.size(), name, "t") != LUA_OK) lua_error(state);
    lua_insert(state, -2);
    lua_setupvalue(state, -2, 1);
}

/// What a script sees (the environment) and what the library's files see: the same safe functions, each in
/// tables of their own, so that a script that changes its own harms no word; and the core.
void Control::open(lua_State* state, const Library& library_files, const Switches& switches,
                   const AddCore& add_core_functions) {
    files_ = &library_files;
    push_safe_library(state);
    const int environment = lua_gettop(state);
    lua_newtable(state);
    add_rrs(state, controller_);
    lua_setfield(state, environment, "rrs");
    set_require(state, environment);
    push_safe_library(state);
    const int library = lua_gettop(state);
    for (const char* name : {"setmetatable", "rawget", "rawset"}) {
        lua_getglobal(state, name);
        lua_setfield(state, library, name);
    }
    lua_newtable(state);
    add_core(state, controller_);
    add_motion_words(state, controller_);
    add_arc_words(state, controller_);
    add_moves(state, controller_);
    add_frames(state, controller_);
    add_poses(state, controller_);
    add_zones(state, controller_);
    add_core_functions(state, *this);
    set_options(state, switches);
    robot_.simulator.watch_zones(robot_.data);
    machine::MachineData tables = robot_.data;
    tables.homes = machine::further_homes(robot_.simulator.machine(), tables.homes);
    set_data_tables(state, tables);
    lua_setfield(state, library, "core");
    lua_pushvalue(state, environment);
    lua_setfield(state, library, "env");
    lua_pushvalue(state, library);
    set_function<include_file>(state, "include", this);
    lua_pop(state, 1);
    library_ = luaL_ref(state, LUA_REGISTRYINDEX);
    environment_ = luaL_ref(state, LUA_REGISTRYINDEX);
    include(state, "init.lua");
}

void Control::set_require(lua_State* state, int environment) {
    lua_pushlightuserdata(state, this);
    lua_pushvalue(state, environment);
    lua_pushcclosure(state, trampoline<require_gsim>, 2);
    lua_setfield(state, environment, "require");
}

/// require "gsim" or "gsim.rs274ngc": the environment, of the control's dialect; there is nothing else to
/// require.
int Control::require_gsim(lua_State* state) {
    const std::string& dialect = bound<Control>(state).dialect();
    const std::string_view name = luaL_checkstring(state, 1);
    if (name != "gsim" && name != "gsim.rs274ngc") {
        return luaL_error(state, "require finds \"gsim\" and \"gsim.rs274ngc\" alone, not \"%s\"",
                          lua_tostring(state, 1));
    }
    if ((name == "gsim") != (dialect == "ab9")) {
        return luaL_error(state, "this run is of the dialect %s, and \"%s\" is another one", dialect.c_str(),
                          lua_tostring(state, 1));
    }
    lua_pushvalue(state, lua_upvalueindex(2));
    return 1;
}

/// Fields of `core` that the command line and the machine decide; the table is on top of the stack.
void Control::set_options(lua_State* state, const Switches& switches) const {
    lua_pushlstring(state, robot_.dialect.data(), robot_.dialect.size());
    lua_setfield(state, -2, "dialect");
    lua_pushboolean(state, static_cast<int>(switches.block_delete));
    lua_setfield(state, -2, "block_delete");
    lua_pushboolean(state, static_cast<int>(switches.optional_stop));
    lua_setfield(state, -2, "optional_stop");
    const bool stops = robot_.simulator.machine().controller.planner == rrs::PlannerKind::rest_to_rest;
    lua_pushboolean(state, static_cast<int>(stops));
    lua_setfield(state, -2, "stops_at_each_move");
    const std::string prefix = robot_.name.empty() ? "" : robot_.name + ".";
    lua_pushlstring(state, prefix.data(), prefix.size());
    lua_setfield(state, -2, "signal_prefix");
    set_corner_override(state, robot_.simulator.machine().controller);
}

void Control::include(lua_State* state, const std::string& file_name) {
    const tl::expected<std::string, std::string> text = files_->read(file_name);
    if (!text) throw std::runtime_error(text.error());
    lua_rawgeti(state, LUA_REGISTRYINDEX, library_);
    load_text(state, *text, ("=lua_lib/" + file_name).c_str());
    lua_call(state, 0, 0);
}

/// include "file": runs another file of the library.
int Control::include_file(lua_State* state) {
    bound<Control>(state).include(state, std::string(luaL_checkstring(state, 1)) + ".lua");
    return 0;
}

void Control::push_environment(lua_State* state) const {
    lua_rawgeti(state, LUA_REGISTRYINDEX, environment_);
}

void Control::push_library(lua_State* state, const char* name) const {
    lua_rawgeti(state, LUA_REGISTRYINDEX, library_);
    lua_getfield(state, -1, name);
    lua_remove(state, -2);
}

void Control::flush(lua_State* state) const {
    push_library(state, "path");
    lua_getfield(state, -1, "flush");
    lua_call(state, 0, 0);
    lua_pop(state, 1);
}

}  // namespace gsim::script
