#include "runtime/script/engine/robot_controller.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "base/text/format.h"
#include "machine/model/secondary_homes.h"
#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/data_tables.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/lua/sandbox.h"

namespace gsim::script {

namespace {

/// Pushes a list of words: { code = "M62", text = "M62 P0", words = { p = 0 } }.
void push_switch_words(lua_State* state, const std::vector<machine::SwitchWord>& words) {
    lua_createtable(state, static_cast<int>(words.size()), 0);
    for (std::size_t i = 0; i < words.size(); ++i) {
        lua_createtable(state, 0, 3);
        lua_pushstring(state, fmt::format("M{}", words[i].code).c_str());
        lua_setfield(state, -2, "code");
        lua_pushstring(state, words[i].text().c_str());
        lua_setfield(state, -2, "text");
        lua_newtable(state);
        for (const auto& [letter, value] : words[i].words) {
            const char lower = static_cast<char>(letter | 0x20);
            lua_pushlstring(state, &lower, 1);
            lua_pushnumber(state, value);
            lua_rawset(state, -3);
        }
        lua_setfield(state, -2, "words");
        lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
    }
}

/// Sets core.process; the table of the core is on top of the stack.
void set_machine_process(lua_State* state, const machine::Process& process) {
    lua_createtable(state, 0, 3);
    lua_pushstring(state, std::string(machine::name(process.kind)).c_str());
    lua_setfield(state, -2, "kind");
    push_switch_words(state, process.on);
    lua_setfield(state, -2, "on");
    push_switch_words(state, process.off);
    lua_setfield(state, -2, "off");
    lua_setfield(state, -2, "process");
}

/// Sets core.stops: words that stop the controller otherwise than by default, by word as it is printed.
void set_stops(lua_State* state, const rrs::StandstillRules& rules) {
    constexpr std::array kRules{"always", "on-change", "never"};
    lua_createtable(state, 0, static_cast<int>(rules.stops.size()));
    for (const auto& [word, rule] : rules.stops) {
        lua_pushstring(state, kRules[static_cast<std::size_t>(rule)]);
        lua_setfield(state, -2, word.c_str());
    }
    lua_setfield(state, -2, "stops");
}

/// Sets core.codes: entries of the dialect's table, by column and by word; empty ones are omitted.
void set_codes(lua_State* state, const std::vector<CodeRow>& codes) {
    constexpr std::array<std::pair<const char*, std::string CodeRow::*>, 4> kColumns{
        {{"group", &CodeRow::group},
         {"keys", &CodeRow::keys},
         {"compensation", &CodeRow::compensation},
         {"unsupported", &CodeRow::unsupported}}};
    lua_createtable(state, 0, static_cast<int>(kColumns.size()));
    for (const auto& [column, field] : kColumns) {
        lua_newtable(state);
        for (const CodeRow& code : codes) {
            if ((code.*field).empty()) continue;
            lua_pushlstring(state, (code.*field).data(), (code.*field).size());
            lua_setfield(state, -2, code.name.c_str());
        }
        lua_setfield(state, -2, column);
    }
    lua_setfield(state, -2, "codes");
}

/// Sets core.times, s; the table of the core is on top of the stack.
void set_word_times(lua_State* state, const machine::WordTimes& times) {
    lua_createtable(state, 0, 9);
    set_number(state, "tool_change", times.tool_change_s);
    set_number(state, "tool_table", times.tool_table_s);
    set_number(state, "coolant_on", times.coolant_on_s);
    set_number(state, "coolant_off", times.coolant_off_s);
    set_number(state, "spindle_start", times.spindle_start_s);
    set_number(state, "spindle_stop", times.spindle_stop_s);
    set_number(state, "process_on", times.process_on_s);
    set_number(state, "process_off", times.process_off_s);
    lua_newtable(state);
    for (const auto& [code, time_s] : times.codes_s)
        set_number(state, fmt::format("M{}", code).c_str(), time_s);
    lua_setfield(state, -2, "codes");
    lua_setfield(state, -2, "times");
}

/// Sets core.corner_override.percent, .before_mm, .after_mm and .angle_deg; the table of core is on top of
/// the stack.
void set_corner_override(lua_State* state, const rrs::CornerOverrideRules& rules) {
    lua_createtable(state, 0, 4);
    set_number(state, "percent", rules.percent);
    set_number(state, "before_mm", rules.before_mm);
    set_number(state, "after_mm", rules.after_mm);
    set_number(state, "angle_deg", rules.max_angle_deg);
    lua_setfield(state, -2, "corner_override");
}

/// Sets core.drilling: the deep drilling of the controller.
void set_drilling(lua_State* state, const rrs::DrillingRules& rules) {
    lua_createtable(state, 0, 4);
    set_number(state, "clearance_mm", rules.peck_clearance_mm);
    set_number(state, "dwell", rules.peck_dwell_s);
    lua_pushboolean(state, rules.pecks_feed_down ? 1 : 0);
    lua_setfield(state, -2, "feeds_down");
    lua_pushboolean(state, rules.boring_cycles ? 1 : 0);
    lua_setfield(state, -2, "bores");
    lua_setfield(state, -2, "drilling");
}

/// Sets core.arc_resolution_mm, and core.retraction.length_mm, .speed_mm_s, .extra_mm and
/// .unretract_speed_mm_s.
void set_klipper_rules(lua_State* state, const rrs::ControllerRules& rules) {
    set_number(state, "arc_resolution_mm", rules.klipper.arc_resolution_mm);
    lua_createtable(state, 0, 4);
    set_number(state, "length_mm", rules.retraction.length_mm);
    set_number(state, "speed_mm_s", rules.retraction.speed_mm_s);
    set_number(state, "extra_mm", rules.retraction.unretract_extra_length_mm);
    set_number(state, "unretract_speed_mm_s", rules.retraction.unretract_speed_mm_s);
    lua_setfield(state, -2, "retraction");
}

int raise_unknown_name(lua_State* state) {
    return luaL_error(state, "the library does not define '%s'", luaL_tolstring(state, 2, nullptr));
}

int raise_shared_name(lua_State* state) {
    return luaL_error(state, "'%s' would be global for all files of the library; return it, or make it local",
                      luaL_tolstring(state, 2, nullptr));
}

/// Names a function of the table on top of the stack by this table name in errors, if the call has no name: a
/// tail call, or one by pcall.
void name_functions(lua_State* state, const std::string& table) {
    lua_getfield(state, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    lua_pushvalue(state, -2);
    lua_setfield(state, -2, table.c_str());
    lua_pop(state, 1);
}

int append_bytes(lua_State* /*state*/, const void* bytes, std::size_t count, void* to) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), count);
    return 0;
}

/// Returns the function on top of the stack, with the locations of its lines.
std::string compiled_function(lua_State* state) {
    std::string bytes;
    lua_dump(state, append_bytes, &bytes, 0);
    return bytes;
}

/// Loads a chunk. `mode`: "t" for texts, "b" for compiled ones. The environment on top of the stack becomes
/// the function's.
void load_chunk(lua_State* state, std::string_view bytes, const char* name, const char* mode) {
    if (luaL_loadbufferx(state, bytes.data(), bytes.size(), name, mode) != LUA_OK) lua_error(state);
    lua_insert(state, -2);
    lua_setupvalue(state, -2, 1);
}

/// Loads a file of the library, compiled if a run has compiled it before.
void load_file(lua_State* state, const Library& library, const std::string& file_name) {
    const std::string chunk = "=lua_lib/" + file_name;
    const auto compiled = library.compiled() == nullptr ? nullptr : library.compiled()->find(file_name);
    if (compiled != nullptr) return load_chunk(state, *compiled, chunk.c_str(), "b");
    const Result<std::string> text = library.read(file_name);
    if (!text) throw std::runtime_error(text.error().message);
    load_chunk(state, *text, chunk.c_str(), "t");
    if (library.compiled() != nullptr) library.compiled()->keep(file_name, compiled_function(state));
}

}  // namespace

void load_text(lua_State* state, const std::string& text, const char* name) {
    load_chunk(state, text, name, "t");
}

/// Sets up what a script sees (the environment) and what the library's files see. Both have the same safe
/// functions, each in separate tables, so that a script that changes its tables harms no word; and the core.
void RobotController::open(lua_State* state, const Library& library_files, const ProgramOptions& switches,
                           const AddCore& add_core_functions) {
    files_ = &library_files;
    interpreter_.set_unit_mm(robot_.unit_mm);
    push_safe_library(state);
    const int environment = lua_gettop(state);
    lua_newtable(state);
    add_rrs(state, interpreter_);
    name_functions(state, prefix() + "rrs");
    lua_setfield(state, environment, "rrs");
    push_safe_library(state);
    const int library = lua_gettop(state);
    for (const char* name : {"setmetatable", "rawget", "rawset"}) {
        lua_getglobal(state, name);
        lua_setfield(state, library, name);
    }
    // Uses Lua's order, which is fast, if no order is required: unordered(t) is Lua's own pairs.
    for (const auto& [name, iterator_name] : {std::pair{"next", "next"}, {"unordered", "pairs"}}) {
        lua_getglobal(state, iterator_name);
        lua_setfield(state, library, name);
    }
    lua_newtable(state);
    add_core(state, interpreter_);
    add_angles(state, interpreter_);
    add_motion_words(state, interpreter_);
    add_arc_words(state, interpreter_);
    add_moves(state, interpreter_);
    add_frames(state, interpreter_);
    add_poses(state, interpreter_);
    add_groups(state, interpreter_);
    add_zones(state, interpreter_);
    add_core_functions(state, *this);
    set_function<push_loading_module>(state, "loading", this);
    set_options(state, switches);
    robot_.simulator.program().zones().set_data(robot_.data);
    machine::MachineData tables = robot_.data;
    tables.homes = machine::secondary_homes(robot_.simulator.machine(), tables.homes);
    set_data_tables(state, tables);
    name_functions(state, prefix() + "core");
    lua_getfield(state, -1, "processes");
    name_functions(state, prefix() + "core.processes");
    lua_pop(state, 1);
    lua_setfield(state, library, "core");
    lua_pushvalue(state, environment);
    lua_setfield(state, library, "env");
    set_function<use_module>(state, "use", this);
    make_read_only(state);
    library_ = luaL_ref(state, LUA_REGISTRYINDEX);
    environment_ = luaL_ref(state, LUA_REGISTRYINDEX);
    lua_newtable(state);
    modules_ = luaL_ref(state, LUA_REGISTRYINDEX);
    push_module(state, "init");
    lua_pop(state, 1);
}

/// Prevents shared names between the library's files: a file returns what it gives to others. The table that
/// they all see is on top of the stack.
void RobotController::make_read_only(lua_State* state) {
    lua_createtable(state, 0, 2);
    lua_pushcfunction(state, trampoline<raise_unknown_name>);
    lua_setfield(state, -2, "__index");
    lua_pushcfunction(state, trampoline<raise_shared_name>);
    lua_setfield(state, -2, "__newindex");
    lua_setmetatable(state, -2);
}

/// Returns the prefix of names, if the run has several robots.
std::string RobotController::prefix() const {
    return robot_.name.empty() ? "" : robot_.name + ".";
}

/// Sets fields of `core` that the command line and the machine decide; the table is on top of the stack.
void RobotController::set_options(lua_State* state, const ProgramOptions& switches) const {
    lua_pushlstring(state, robot_.dialect.data(), robot_.dialect.size());
    lua_setfield(state, -2, "dialect");
    set_codes(state, robot_.codes);
    lua_pushboolean(state, static_cast<int>(switches.block_delete));
    lua_setfield(state, -2, "block_delete");
    lua_pushboolean(state, static_cast<int>(switches.optional_stop));
    lua_setfield(state, -2, "optional_stop");
    lua_pushinteger(state, static_cast<lua_Integer>(switches.passes));
    lua_setfield(state, -2, "passes");
    const rrs::ControllerRules& controller = robot_.simulator.machine().controller;
    lua_pushboolean(state, static_cast<int>(controller.capabilities().stops_at_each_move));
    lua_setfield(state, -2, "stops_at_each_move");
    set_stops(state, controller.standstill);
    lua_pushstring(state, prefix().c_str());
    lua_setfield(state, -2, "signal_prefix");
    set_corner_override(state, controller.corner_override);
    set_drilling(state, controller.drilling);
    set_number(state, "spline_chord_mm", controller.curves.spline_chord_tolerance_mm);
    set_klipper_rules(state, controller);
    if (robot_.simulator.machine().process) set_machine_process(state, *robot_.simulator.machine().process);
    if (const machine::WordTimes& times = robot_.simulator.machine().times; times != machine::WordTimes{})
        set_word_times(state, times);
}

/// Pushes the result of a file of the library, which is run when it is first needed.
void RobotController::push_module(lua_State* state, const std::string& name) {
    lua_rawgeti(state, LUA_REGISTRYINDEX, modules_);
    if (lua_getfield(state, -1, name.c_str()) == LUA_TNIL) {
        lua_pop(state, 1);
        load_module(state, name);
        lua_pushvalue(state, -1);
        lua_setfield(state, -3, name.c_str());
    }
    lua_remove(state, -2);
}

void RobotController::load_module(lua_State* state, const std::string& name) {
    const auto begun = std::find(loading_.begin(), loading_.end(), name);
    if (begun != loading_.end()) {
        const std::string dependency_chain(text::joined(begun, loading_.end(), " needs "));
        throw std::runtime_error(
            fmt::format("circular dependency of library files: {} needs {}", dependency_chain, name));
    }
    loading_.push_back(name);
    lua_rawgeti(state, LUA_REGISTRYINDEX, library_);
    load_file(state, *files_, name + ".lua");
    lua_call(state, 0, 1);
    if (lua_isnil(state, -1)) {
        lua_pop(state, 1);
        lua_pushboolean(state, 1);
    }
    loading_.pop_back();
}

/// use(name, fields ...): the result of the file of that name, or these fields of it.
int RobotController::use_module(lua_State* state) {
    const int fields = lua_gettop(state);
    const std::string name = luaL_checkstring(state, 1);
    bound<RobotController>(state).push_module(state, name);
    if (fields == 1) return 1;
    luaL_checkstack(state, fields, nullptr);
    for (int field = 2; field <= fields; ++field) {
        lua_pushvalue(state, field);
        if (lua_gettable(state, fields + 1) == LUA_TNIL)
            luaL_error(state, "lua_lib/%s.lua does not return '%s'", name.c_str(),
                       luaL_checkstring(state, field));
    }
    return fields - 1;
}

/// core.loading(): the name of the library file that is being loaded.
int RobotController::push_loading_module(lua_State* state) {
    const std::vector<std::string>& loading = bound<RobotController>(state).loading_;
    lua_pushstring(state, loading.empty() ? "" : loading.back().c_str());
    return 1;
}

void RobotController::push_environment(lua_State* state) const {
    lua_rawgeti(state, LUA_REGISTRYINDEX, environment_);
}

void RobotController::push_library(lua_State* state, const char* name) const {
    lua_rawgeti(state, LUA_REGISTRYINDEX, modules_);
    lua_getfield(state, -1, "init");
    lua_remove(state, -2);
    lua_getfield(state, -1, name);
    lua_remove(state, -2);
}

void RobotController::flush(lua_State* state) const {
    push_library(state, "flush");
    lua_call(state, 0, 0);
}

}  // namespace gsim::script
