#include "runtime/script/lua/lua_state.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <string>

#include <fmt/format.h>

namespace gsim::script {

namespace {

constexpr std::size_t kBytesPerStep = 64;
/// Size of the longest string that an instruction may read and still count as one.
constexpr std::uint64_t kBytesOfOneStep = std::uint64_t{64} << 10U;

/// Its address is the value of an error that no script can create or distinguish from another.
char stop_sentinel = 0;

constexpr const char* kScriptMemoryLabel = "the script";
constexpr const char* kSingleString = "a string of the script";

}  // namespace

LuaState::LuaState(Limits limits) : limits_(limits), memory_(limits.memory_bytes) {
    state_ = lua_newstate(allocate, this);
    if (state_ == nullptr) throw std::bad_alloc();
    *static_cast<LuaState**>(lua_getextraspace(state_)) = this;
    running_ = state_;
    set_hook(state_, kStepsBetweenCounts);
}

LuaState::~LuaState() {
    lua_close(state_);
}

LuaState& LuaState::of(lua_State* state) {
    return **static_cast<LuaState**>(lua_getextraspace(state));
}

void* LuaState::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
    auto& state = *static_cast<LuaState*>(self);
    const std::size_t block_size = block == nullptr ? 0 : old_size;
    if (new_size == 0) {
        state.memory_.release(block, block_size);
        return nullptr;
    }
    // Lua reports the type of an object that it allocates.
    const bool is_string = block == nullptr && old_size == LUA_TSTRING;
    const char* const what = is_string ? kSingleString : kScriptMemoryLabel;
    if (!state.memory_.permits(block_size, new_size, what)) return nullptr;
    state.count_work(new_size);
    void* const resized = state.memory_.resize(block, block_size, new_size, what);
    if (resized == nullptr) return nullptr;
    if (block == nullptr && old_size == LUA_TTABLE) state.table_serials_.assign(resized, new_size);
    if (is_string && new_size > kBytesOfOneStep) state.register_large_value(new_size);
    return resized;
}

void LuaState::add_external_bytes(lua_State* state, std::size_t bytes, const char* what) {
    if (!memory_.has_space_for(bytes)) lua_gc(state, LUA_GCCOLLECT);
    if (!memory_.has_space_for(bytes)) {
        memory_.reject_external(bytes, what);
        stop_reason_ = StopReason::memory;
        raise_stop(state);
    }
    memory_.add_external(bytes, what);
}

void LuaState::count_work(std::uint64_t bytes) {
    steps_ += bytes / kBytesPerStep;
    // The very first instruction past the limit must check it.
    if (steps_ > limits_.steps && running_ != nullptr) set_hook(running_, 1);
}

void LuaState::charge(lua_State* state, std::uint64_t bytes) {
    steps_ += bytes / kBytesPerStep;
    check_limits(state);
}

void LuaState::register_large_value(std::uint64_t bytes) {
    const std::uint64_t weight = std::max<std::uint64_t>(1, bytes / kBytesOfOneStep);
    if (weight <= weight_) return;
    weight_ = weight;
    if (running_ != nullptr) set_hook(running_, steps_between_counts());
}

int LuaState::steps_between_counts() const {
    return std::max(1, static_cast<int>(kStepsBetweenCounts / weight_));
}

void LuaState::set_running(lua_State* thread) {
    running_ = thread;
    if (lua_gethookcount(thread) > steps_between_counts()) set_hook(thread, steps_between_counts());
}

/// Line hooks stay as they are. Threads get the hook of the main one when they are created.
void LuaState::set_hook(lua_State* thread, int steps) {
    lua_sethook(thread, on_hook, LUA_MASKCOUNT | (lua_gethookmask(thread) & LUA_MASKLINE), steps);
}

void LuaState::set_line_hook(lua_State* thread, bool on) const {
    lua_sethook(thread, on_hook, on ? LUA_MASKCOUNT | LUA_MASKLINE : LUA_MASKCOUNT, steps_between_counts());
}

void LuaState::on_hook(lua_State* state, lua_Debug* event) {
    LuaState& self = of(state);
    if (event->event == LUA_HOOKLINE) {
        self.on_line_(state, event);
    } else {
        self.count_steps(state);
    }
}

void LuaState::count_steps(lua_State* state) {
    const int count = lua_gethookcount(state);
    steps_ += static_cast<std::uint64_t>(count) * weight_;
    check_limits(state);
    if (count != steps_between_counts()) set_hook(state, steps_between_counts());
}

void LuaState::check_limits(lua_State* state) {
    unchecked_steps_ = 0;
    if (steps_ > limits_.steps) stop_for(StopReason::steps, state);
    if (cpu_limit_ != nullptr && cpu_limit_->reached()) stop_for(StopReason::cpu, state);
}

std::string LuaState::printed(std::string line) {
    if (printed_bytes_ > kMaxPrinted_bytes) return {};
    printed_bytes_ += line.size();
    if (printed_bytes_ <= kMaxPrinted_bytes) return line;
    return fmt::format("the script has printed {} MB; further output is suppressed\n",
                       kMaxPrinted_bytes >> 20U);
}

void LuaState::stop_for(StopReason reason, lua_State* state) {
    stop_reason_ = reason;
    if (on_last_step_) on_last_step_(state);
    raise_stop(state);
}

void LuaState::raise_stop(lua_State* state) {
    lua_pushlightuserdata(state, &stop_sentinel);
    lua_error(state);
    std::abort();  // lua_error does not return
}

bool LuaState::is_stop(lua_State* state, int index) {
    return lua_touserdata(state, index) == &stop_sentinel;
}

void LuaState::stop_if_out_of_memory(lua_State* state, int status) {
    LuaState& self = of(state);
    // Lua's string functions raise a lack of memory as an ordinary error.
    if (status == LUA_ERRMEM || self.memory_.is_rejected()) self.stop_reason_ = StopReason::memory;
    if (self.stop_reason_ == StopReason::memory || is_stop(state, -1)) raise_stop(state);
}

}  // namespace gsim::script
