#include "runtime/script/lua_state.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

namespace gsim::script {

namespace {

constexpr int kStepsBetweenCounts = 10'000;
constexpr std::size_t kBytesPerStep = 64;
/// Of the longest string: what an instruction may look at and still count as one.
constexpr std::uint64_t kBytesOfOneStep = std::uint64_t{64} << 10U;

/// Its address is the value of an error that no script can make or tell from another.
char stop_mark = 0;

}  // namespace

LuaState::LuaState(Limits limits) : limits_(limits) {
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

/// As realloc() does, with sizes above 0.
void* LuaState::resize(void* block, std::size_t held, std::size_t new_size) {
    if (held > SmallBlocks::kLargest && new_size > SmallBlocks::kLargest)
        return std::realloc(block, new_size);
    if (SmallBlocks::same_class(held, new_size)) return block;
    const bool small = new_size <= SmallBlocks::kLargest;
    void* const grown = small ? small_blocks_.take(new_size) : std::malloc(new_size);
    if (grown == nullptr || block == nullptr) return grown;
    std::memcpy(grown, block, std::min(held, new_size));
    release(block, held);
    return grown;
}

void LuaState::release(void* block, std::size_t held) {
    if (block == nullptr) return;
    if (held <= SmallBlocks::kLargest) {
        small_blocks_.give(block, held);
    } else {
        std::free(block);
    }
}

void* LuaState::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
    auto& state = *static_cast<LuaState*>(self);
    const std::size_t held = block == nullptr ? 0 : old_size;
    if (new_size == 0) {
        state.release(block, held);
        state.bytes_ -= held;
        return nullptr;
    }
    state.refused_ = new_size > held && state.bytes_ + (new_size - held) > state.limits_.memory_bytes;
    if (state.refused_) return nullptr;
    state.count_work(new_size);
    void* grown = state.resize(block, held, new_size);
    state.refused_ = grown == nullptr;
    if (grown != nullptr) {
        if (block == nullptr && old_size == LUA_TTABLE) state.number_table(grown, new_size);
        if (block == nullptr && old_size == LUA_TSTRING && new_size > kBytesOfOneStep)
            state.note_large(new_size);
        state.bytes_ += new_size - held;
        if (state.bytes_ > state.peak_bytes_) state.peak_bytes_ = state.bytes_;
    }
    return grown;
}

/// Lua says what it makes an object for. Its number goes behind the object, where a small block has room.
void LuaState::number_table(void* table, std::size_t size) {
    if (SmallBlocks::spare_bytes(size) < sizeof tables_) return;
    ++tables_;
    table_bytes_ = size;
    std::memcpy(static_cast<std::byte*>(table) + size, &tables_, sizeof tables_);
}

std::uint64_t LuaState::serial_of_table(const void* table) const {
    std::uint64_t serial = 0;
    if (table_bytes_ > 0)
        std::memcpy(&serial, static_cast<const std::byte*>(table) + table_bytes_, sizeof serial);
    return serial;
}

void LuaState::count_work(std::uint64_t bytes) {
    steps_ += bytes / kBytesPerStep;
    // Past the limit the very next instruction shall look at it.
    if (steps_ > limits_.steps && running_ != nullptr) set_hook(running_, 1);
}

void LuaState::charge(lua_State* state, std::uint64_t bytes) {
    steps_ += bytes / kBytesPerStep;
    if (steps_ > limits_.steps) end_for_steps(state);
}

void LuaState::note_large(std::uint64_t bytes) {
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

/// Lines stay watched where they are. Threads get the hook of the main one when they are made.
void LuaState::set_hook(lua_State* thread, int steps) {
    lua_sethook(thread, on_hook, LUA_MASKCOUNT | (lua_gethookmask(thread) & LUA_MASKLINE), steps);
}

void LuaState::watch_lines(lua_State* thread, bool on) const {
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
    if (steps_ > limits_.steps) end_for_steps(state);
    if (count != steps_between_counts()) set_hook(state, steps_between_counts());
}

void LuaState::end_for_steps(lua_State* state) {
    ended_ = Ended::steps;
    if (on_last_step_) on_last_step_(state);
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
