#include "runtime/script/lua_state.h"

#include <cstdlib>
#include <new>

namespace gsim::script {

namespace {

constexpr int kStepsBetweenCounts = 10'000;
constexpr std::size_t kBytesPerStep = 64;

/// Its address is the value of an error that no script can make or tell from another.
char stop_mark = 0;

}  // namespace

LuaState::LuaState(Limits limits) : limits_(limits) {
    state_ = lua_newstate(allocate, this);
    if (state_ == nullptr) throw std::bad_alloc();
    *static_cast<LuaState**>(lua_getextraspace(state_)) = this;
    lua_sethook(state_, count_steps, LUA_MASKCOUNT, kStepsBetweenCounts);
}

LuaState::~LuaState() {
    lua_close(state_);
}

LuaState& LuaState::of(lua_State* state) {
    return **static_cast<LuaState**>(lua_getextraspace(state));
}

void* LuaState::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
    auto& state = *static_cast<LuaState*>(self);
    const std::size_t held = block == nullptr ? 0 : old_size;
    if (new_size == 0) {
        std::free(block);
        state.bytes_ -= held;
        return nullptr;
    }
    state.refused_ = new_size > held && state.bytes_ + (new_size - held) > state.limits_.memory_bytes;
    if (state.refused_) return nullptr;
    state.count_work(new_size);
    void* grown = std::realloc(block, new_size);
    state.refused_ = grown == nullptr;
    if (grown != nullptr) {
        state.bytes_ += new_size - held;
        if (state.bytes_ > state.peak_bytes_) state.peak_bytes_ = state.bytes_;
    }
    return grown;
}

void LuaState::count_work(std::uint64_t bytes) {
    steps_ += bytes / kBytesPerStep;
    // Past the limit the very next instruction shall look at it.
    if (steps_ > limits_.steps && state_ != nullptr) lua_sethook(state_, count_steps, LUA_MASKCOUNT, 1);
}

void LuaState::count_steps(lua_State* state, lua_Debug*) {
    LuaState& self = of(state);
    const int count = lua_gethookcount(state);
    self.steps_ += static_cast<std::uint64_t>(count);
    if (self.steps_ <= self.limits_.steps) {
        if (count != kStepsBetweenCounts) lua_sethook(state, count_steps, LUA_MASKCOUNT, kStepsBetweenCounts);
        return;
    }
    self.ended_ = Ended::steps;
    if (self.on_last_step_) self.on_last_step_(state);
    raise_stop(state);
}

void LuaState::raise_stop(lua_State* state) {
    lua_pushlightuserdata(state, &stop_mark);
    lua_error(state);
    std::abort();  // lua_error does not return
}

bool LuaState::is_stop(lua_State* state, int index) {
    return lua_touserdata(state, index) == &stop_mark;
}

void LuaState::pass_on(lua_State* state, int status) {
    LuaState& self = of(state);
    // Lua's string functions raise a lack of memory as an ordinary error.
    if (status == LUA_ERRMEM || self.refused_) self.ended_ = Ended::memory;
    if (self.ended_ == Ended::memory || is_stop(state, -1)) raise_stop(state);
}

}  // namespace gsim::script
