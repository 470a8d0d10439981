#include "runtime/script/lua/lua_state.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
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

std::string megabytes(std::size_t bytes) {
    constexpr double kMegabyte = 1U << 20U;
    constexpr std::size_t kSmall = std::size_t{100} << 10U;
    return bytes < kSmall ? fmt::format("{} bytes", bytes)
                          : fmt::format("{:.1f} MB", static_cast<double>(bytes) / kMegabyte);
}

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

/// Resizes a block like realloc(), with sizes above 0.
void* LuaState::resize(void* block, std::size_t block_size, std::size_t new_size) {
    if (block_size > SmallBlockAllocator::kMaxBlockSize && new_size > SmallBlockAllocator::kMaxBlockSize)
        return std::realloc(block, new_size);
    if (SmallBlockAllocator::is_same_size_class(block_size, new_size)) return block;
    const bool is_small_block = new_size <= SmallBlockAllocator::kMaxBlockSize;
    void* const grown =
        is_small_block ? small_block_allocator_.allocate_block(new_size) : std::malloc(new_size);
    if (grown == nullptr || block == nullptr) return grown;
    std::memcpy(grown, block, std::min(block_size, new_size));
    release(block, block_size);
    return grown;
}

void LuaState::release(void* block, std::size_t block_size) {
    if (block == nullptr) return;
    if (block_size <= SmallBlockAllocator::kMaxBlockSize) {
        small_block_allocator_.deallocate_block(block, block_size);
    } else {
        std::free(block);
    }
}

void* LuaState::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
    auto& state = *static_cast<LuaState*>(self);
    const std::size_t block_size = block == nullptr ? 0 : old_size;
    if (new_size == 0) {
        state.release(block, block_size);
        state.bytes_ -= block_size;
        return nullptr;
    }
    const bool is_string = block == nullptr && old_size == LUA_TSTRING;
    const auto reject = [&](bool by_system) {
        return state.reject(
            {is_string ? kSingleString : kScriptMemoryLabel, new_size - block_size, state.bytes_, by_system});
    };
    if (new_size > block_size && state.bytes_ + (new_size - block_size) > state.limits_.memory_bytes)
        return reject(false);
    state.count_work(new_size);
    void* grown = state.resize(block, block_size, new_size);
    if (grown == nullptr) return reject(true);
    state.refused_ = false;
    if (block == nullptr && old_size == LUA_TTABLE) state.assign_table_serial(grown, new_size);
    if (is_string && new_size > kBytesOfOneStep) state.register_large_value(new_size);
    state.bytes_ += new_size - block_size;
    return grown;
}

/// Lua reports the type of the object that it allocates. The number is stored after the object, if a small
/// block has the space.
void LuaState::assign_table_serial(void* table, std::size_t size) {
    if (SmallBlockAllocator::spare_bytes(size) < sizeof tables_) return;
    ++tables_;
    table_bytes_ = size;
    std::memcpy(static_cast<std::byte*>(table) + size, &tables_, sizeof tables_);
}

std::uint64_t LuaState::table_serial(const void* table) const {
    std::uint64_t serial = 0;
    if (table_bytes_ > 0)
        std::memcpy(&serial, static_cast<const std::byte*>(table) + table_bytes_, sizeof serial);
    return serial;
}

std::nullptr_t LuaState::reject(const MemoryError& memory_request_error) {
    refused_ = true;
    memory_error_ = memory_request_error;
    if (const char* max = largest_holder();
        max != nullptr && memory_request_error.requested_bytes < bytes_ / 2)
        memory_error_.what = max;
    return nullptr;
}

void LuaState::add_external_bytes(lua_State* state, std::size_t bytes, const char* what) {
    const auto exceeds_limit = [&] {
        return bytes > limits_.memory_bytes || bytes_ > limits_.memory_bytes - bytes;
    };
    if (exceeds_limit()) lua_gc(state, LUA_GCCOLLECT);
    if (exceeds_limit()) {
        reject({what, bytes, bytes_, false});
        stop_reason_ = StopReason::memory;
        raise_stop(state);
    }
    external_bytes(what) += bytes;
    bytes_ += bytes;
}

void LuaState::release_memory(std::size_t bytes, const char* what) {
    external_bytes(what) -= bytes;
    bytes_ -= bytes;
}

std::size_t& LuaState::external_bytes(const char* what) {
    const auto found = std::find_if(
        allocations_.begin(), allocations_.end(),
        [what](const ExternalMemory& block_size) { return std::string_view(block_size.what) == what; });
    return found != allocations_.end() ? found->bytes
                                       : allocations_.emplace_back(ExternalMemory{what, 0}).bytes;
}

/// Returns what holds more than half of the memory outside of Lua, or null. That is reported as the consumer
/// that needs too much, even if another one requests the last part.
const char* LuaState::largest_holder() const {
    for (const ExternalMemory& block_size : allocations_) {
        if (block_size.bytes > bytes_ / 2) return block_size.what;
    }
    return nullptr;
}

std::string LuaState::memory_error() const {
    const std::string amounts =
        fmt::format("{} are in use, and it asks for {}", megabytes(memory_error_.retained_bytes),
                    megabytes(memory_error_.requested_bytes));
    if (memory_error_.by_system)
        return fmt::format("{} needs more memory than the system gives: {}", memory_error_.what, amounts);
    return fmt::format("{} needs more memory than the run may use, {} MB (--memory): {}", memory_error_.what,
                       limits_.memory_bytes >> 20U, amounts);
}

void LuaState::count_work(std::uint64_t bytes) {
    steps_ += bytes / kBytesPerStep;
    // The very next instruction after the limit must check it.
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
    unchecked_ = 0;
    if (steps_ > limits_.steps) stop_for(StopReason::steps, state);
    if (cpu_ != nullptr && cpu_->reached()) stop_for(StopReason::cpu, state);
}

std::string LuaState::printed(std::string line) {
    if (printed_bytes_ > kMostPrinted_bytes) return {};
    printed_bytes_ += line.size();
    if (printed_bytes_ <= kMostPrinted_bytes) return line;
    return fmt::format("the script has printed {} MB; what it prints from here on is left out\n",
                       kMostPrinted_bytes >> 20U);
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
    if (status == LUA_ERRMEM || self.refused_) self.stop_reason_ = StopReason::memory;
    if (self.stop_reason_ == StopReason::memory || is_stop(state, -1)) raise_stop(state);
}

}  // namespace gsim::script
