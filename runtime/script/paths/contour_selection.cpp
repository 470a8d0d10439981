#include "runtime/script/paths/contour_selection.h"

#include <algorithm>

#include <fmt/format.h>

#include "runtime/script/lua/object_names.h"
#include "runtime/script/lua/sandbox.h"

namespace gsim::script {

namespace {

struct ContourTask {
    std::string_view lua;
    const std::string& file_name;
    std::span<const ContourDescription> contours;
    os::CpuLimit* cpu;
    std::vector<bool> selected = {};
    int last_line = 1;  // line where a limit was reached
};

void set_text(lua_State* state, const char* name, const std::string& text) {
    lua_pushlstring(state, text.data(), text.size());
    lua_setfield(state, -2, name);
}

// {x = 1, y = 2, z = 3}
void set_vector(lua_State* state, const char* name, const std::array<double, 3>& values) {
    lua_createtable(state, 0, 3);
    set_number(state, "x", values[0]);
    set_number(state, "y", values[1]);
    set_number(state, "z", values[2]);
    lua_setfield(state, -2, name);
}

void push_contour(lua_State* state, const ContourDescription& description) {
    lua_createtable(state, 0, 10);
    set_text(state, "face", description.face);
    lua_pushboolean(state, description.is_hole ? 1 : 0);
    lua_setfield(state, -2, "is_hole");
    lua_pushboolean(state, description.is_open ? 1 : 0);
    lua_setfield(state, -2, "is_open");
    set_number(state, "length_mm", description.length_mm);
    set_vector(state, "low_mm", description.low_mm);
    set_vector(state, "high_mm", description.high_mm);
    set_vector(state, "normal", description.normal);
    set_number(state, "depth_mm", description.depth_mm);
    set_number(state, "tilt_deg", description.tilt_deg);
    set_number(state, "lean_deg", description.tilt_deg);  // its name until 0.3
    lua_createtable(state, static_cast<int>(description.edges.size()), 0);
    for (std::size_t i = 0; i < description.edges.size(); ++i) {
        lua_createtable(state, 0, 2);
        set_text(state, "name", description.edges[i].name);
        set_number(state, "length_mm", description.edges[i].length_mm);
        lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
    }
    lua_setfield(state, -2, "edges");
}

// Gets the ContourTask.
int run_contour_task(lua_State* state) {
    ContourTask& task = *static_cast<ContourTask*>(lua_touserdata(state, 1));
    const std::string chunk = fmt::format("@{}", task.file_name);
    if (luaL_loadbufferx(state, task.lua.data(), task.lua.size(), chunk.c_str(), "t") != LUA_OK)
        return lua_error(state);
    push_safe_library(state);
    lua_setupvalue(state, -2, 1);
    LuaState::of(state).set_time_limit(task.cpu);
    lua_call(state, 0, 1);
    if (!lua_isfunction(state, -1)) {
        return luaL_error(state,
                          "%s:1: the script must return a function with a contour as its argument, such as "
                          "function(contour) return contour.is_hole end",
                          task.file_name.c_str());
    }
    const int choose = lua_gettop(state);
    for (const ContourDescription& description : task.contours) {
        lua_pushvalue(state, choose);
        push_contour(state, description);
        lua_call(state, 1, 1);
        if (!lua_isboolean(state, -1) && !lua_isnil(state, -1)) {
            return luaL_error(state,
                              "%s:1: the function must return true or false, but for %s it returns a %s",
                              task.file_name.c_str(), description.face.c_str(), luaL_typename(state, -1));
        }
        task.selected.push_back(lua_toboolean(state, -1) != 0);
        lua_pop(state, 1);
    }
    return 0;
}

std::string stop_error(const LuaState& lua, const ContourTask& task) {
    std::string reason = "the script exceeds the allowed number of steps";
    if (lua.ended() == LuaState::StopReason::memory) reason = lua.memory().error();
    if (lua.ended() == LuaState::StopReason::cpu)
        reason = fmt::format("the limit of {:.10g} s of processor time is reached (--max-cpu-seconds)",
                             task.cpu->seconds());
    return fmt::format("{}:{}: {}", task.file_name, task.last_line, reason);
}

}  // namespace

Result<std::vector<bool>> choose_contours(std::string_view lua_text, const std::string& file_name,
                                          std::span<const ContourDescription> contours,
                                          const LuaState::Limits& limits, os::CpuLimit* cpu) {
    LuaState lua(limits);
    lua_State* state = lua.get();
    ContourTask task{lua_text, file_name, contours, cpu};
    lua.on_last_step([&task](lua_State* at) {
        lua_Debug current{};
        if (lua_getstack(at, 0, &current) != 0 && lua_getinfo(at, "l", &current) != 0)
            task.last_line = std::max(1, current.currentline);
    });
    lua_pushcfunction(state, trampoline<run_contour_task>);
    lua_pushlightuserdata(state, &task);
    if (lua_pcall(state, 1, 0, 0) == LUA_OK) return std::move(task.selected);
    if (lua.ended() != LuaState::StopReason::no || LuaState::is_stop(state, -1))
        return tl::unexpected(stop_error(lua, task));
    std::string message(push_text(state, -1));
    std::replace(message.begin(), message.end(), '\n', ' ');
    return tl::unexpected(message);
}

}  // namespace gsim::script
