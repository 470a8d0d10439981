#include "runtime/script/processes/process_signals.h"

#include <utility>

namespace gsim::script {

using process::is_on;
using process::ProcessId;
using process::Value;
using process::value_text;

void ProcessSignals::set(const std::string& name, const Value& value) {
    const Value before = board_.get(name);
    if (!board_.set(name, value)) return;
    const process::Process& process = table_.running();
    board_.note({.t_s = process.time_s,
                 .location = process.location,
                 .process = process.name,
                 .signal = name,
                 .value = value_text(value)});
    table_.schedule().changed(name, before, value, process.time_s);
    if (is_on(before) || !is_on(value)) return;
    for (ProcessId id = 0; id < table_.size(); ++id) {
        LuaProcess& lua_process = table_.lua_process(id);
        if (const auto handler = lua_process.handlers.find(name); handler != lua_process.handlers.end())
            lua_process.pending.push_back(handler->second);
    }
}

int ProcessSignals::wait(lua_State* state, process::Wait wait) {
    if (is_met(wait, board_.get(wait.signal))) {
        lua_pushboolean(state, 1);
        return 1;
    }
    table_.schedule().wait(table_.running_id(), std::move(wait));
    return table_.yield(state, YieldReason::in_wait);
}

void ProcessSignals::set_interrupt(lua_State* state, const std::string& name) {
    LuaProcess& lua_process = table_.running_lua();
    if (const auto old = lua_process.handlers.find(name); old != lua_process.handlers.end()) {
        std::erase(lua_process.pending, old->second);
        luaL_unref(state, LUA_REGISTRYINDEX, old->second);
        lua_process.handlers.erase(old);
    }
    if (lua_isnil(state, -1)) {
        lua_pop(state, 1);
    } else {
        lua_process.handlers.emplace(name, luaL_ref(state, LUA_REGISTRYINDEX));
    }
    lua_.set_line_hook(lua_process.threads.front().state, needs_line_hook(lua_process));
}

}  // namespace gsim::script
