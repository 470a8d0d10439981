#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>

#include <lua.hpp>

#include "base/os/cpu_limit.h"
#include "runtime/script/lua/script_memory.h"
#include "runtime/script/lua/table_serials.h"

namespace gsim::script {

/// Lua state that counts its memory and its steps. A script cannot catch the exhaustion of either: it raises
/// the error of raise_stop(), which the sandbox's pcall passes on.
class LuaState {
  public:
    struct Limits {
        std::size_t memory_bytes = std::size_t{2048} << 20U;
        std::uint64_t steps = 200'000'000;  ///< Instructions without a motion or a dwell in between.
    };
    /// Reason why the state itself called raise_stop().
    enum class StopReason : std::uint8_t { no, memory, steps, cpu };

    /// Cost to copy one of the many values that a call may have.
    static constexpr std::uint64_t kBytesOfValue = 4;

    /// Maximum bytes that scripts may print: the remainder is left out, with one message.
    static constexpr std::size_t kMaxPrinted_bytes = std::size_t{4} << 20U;

    explicit LuaState(Limits limits);
    ~LuaState();
    LuaState(const LuaState&) = delete;
    LuaState& operator=(const LuaState&) = delete;

    lua_State* get() const { return state_; }
    StopReason ended() const { return memory_.is_rejected() ? StopReason::memory : stop_reason_; }
    /// Limits the processor time from here on; null: no limit. `cpu` must outlive the state.
    void set_time_limit(os::CpuLimit* cpu) { cpu_limit_ = cpu; }
    /// Restarts the count of steps, because the machine has moved on.
    void restart_steps() { steps_ = 0; }
    /// Counts work inside one instruction, by the bytes that it touches. Long strings and tables take time in
    /// which no instruction is counted.
    void count_work(std::uint64_t bytes);
    /// Counts work from a function that Lua calls, like count_work(). Ends the run here if that is too much.
    void charge(lua_State* state, std::uint64_t bytes);
    /// Counts instructions that run without Lua counting them; ends the run if that is too much.
    void count_instructions(lua_State* state, std::uint64_t count) {
        steps_ += count * weight_;
        unchecked_steps_ += count;
        if (unchecked_steps_ >= kStepsBetweenCounts || steps_ > limits_.steps) check_limits(state);
    }
    /// Notes a string or a list of values of so many bytes, which any instruction may read. From here on each
    /// instruction counts as that much work.
    void register_large_value(std::uint64_t bytes);
    /// Counts memory outside of Lua that is kept for the script as its own from here on. Ends the run if that
    /// is too much. `what` is stored and names the consumer: "the text of the script".
    void add_external_bytes(lua_State* state, std::size_t bytes, const char* what);
    ScriptMemory& memory() { return memory_; }
    const ScriptMemory& memory() const { return memory_; }
    const TableSerials& table_serials() const { return table_serials_; }
    const Limits& limits() const { return limits_; }
    /// Sets a function that is called before the run ends for its steps or its processor time, while the
    /// script's stack still exists.
    void on_last_step(std::function<void(lua_State*)> call) { on_last_step_ = std::move(call); }

    /// Sets the thread that runs now; the main one by default.
    void set_running(lua_State* thread);
    /// Sets a function that is called for each line of a monitored thread; it may yield.
    void on_line(std::function<void(lua_State*, lua_Debug*)> call) { on_line_ = std::move(call); }
    void set_line_hook(lua_State* thread, bool on) const;

    /// Returns the LuaState of a lua_State.
    static LuaState& of(lua_State* state);
    /// Raises the error that ends the run; does not return.
    [[noreturn]] static void raise_stop(lua_State* state);
    /// Returns true if the value at `index` is the one that raise_stop() raises.
    static bool is_stop(lua_State* state, int index);
    /// Raises an error that no script may catch again. Must be called on each caught error.
    static void stop_if_out_of_memory(lua_State* state, int status);

    /// Returns the text to write for a line that a script prints.
    std::string printed(std::string line);

  private:
    static constexpr int kStepsBetweenCounts = 10'000;

    static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
    static void on_hook(lua_State* state, lua_Debug* event);
    void count_steps(lua_State* state);
    void check_limits(lua_State* state);
    [[noreturn]] void stop_for(StopReason reason, lua_State* state);
    int steps_between_counts() const;
    static void set_hook(lua_State* thread, int steps);

    Limits limits_;
    os::CpuLimit* cpu_limit_ = nullptr;
    ScriptMemory memory_;
    TableSerials table_serials_;
    std::size_t printed_bytes_ = 0;
    std::uint64_t steps_ = 0;
    std::uint64_t unchecked_steps_ = 0;  ///< Instructions since the limits were last looked at.
    std::uint64_t weight_ = 1;           ///< Weight of an instruction.
    StopReason stop_reason_ = StopReason::no;
    std::function<void(lua_State*)> on_last_step_;
    std::function<void(lua_State*, lua_Debug*)> on_line_;
    lua_State* state_ = nullptr;
    lua_State* running_ = nullptr;
};

/// Memory outside of Lua that counts as the script's during the lifetime of this object.
class ExternalMemoryGuard {
  public:
    ExternalMemoryGuard(lua_State* state, std::size_t bytes, const char* what)
        : lua_(LuaState::of(state)), bytes_(bytes), what_(what) {
        lua_.add_external_bytes(state, bytes, what);
    }
    ~ExternalMemoryGuard() { lua_.memory().release_external(bytes_, what_); }
    ExternalMemoryGuard(const ExternalMemoryGuard&) = delete;
    ExternalMemoryGuard& operator=(const ExternalMemoryGuard&) = delete;

  private:
    LuaState& lua_;
    std::size_t bytes_;
    const char* what_;
};

/// Wraps a C++ function for Lua: an exception becomes an error of Lua with its text.
template <int (*Function)(lua_State*)>
int trampoline(lua_State* state) {
    // Lua's own errors pass as exceptions of another type; only exceptions of C++ are converted into errors
    // of Lua.
    try {
        return Function(state);
    } catch (const std::exception& error) {
        lua_pushstring(state, error.what());
    }
    return lua_error(state);
}

/// Sets field `name` of the table on top of the stack to a C++ function with `upvalue` as light userdata.
template <int (*Function)(lua_State*)>
void set_function(lua_State* state, const char* name, void* upvalue) {
    lua_pushlightuserdata(state, upvalue);
    lua_pushcclosure(state, trampoline<Function>, 1);
    lua_setfield(state, -2, name);
}

/// Returns the object that set_function() bound.
template <typename Object>
Object& bound(lua_State* state) {
    return *static_cast<Object*>(lua_touserdata(state, lua_upvalueindex(1)));
}

/// Sets field `name` of the table on top of the stack.
inline void set_number(lua_State* state, const char* name, double value) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
}

/// Returns the number of a field of the table at `index`, or 0 if it does not exist. Raises an error of Lua
/// if it is no number.
inline double number_field(lua_State* state, int index, const char* name) {
    lua_getfield(state, index, name);
    const double value = luaL_optnumber(state, -1, 0);
    lua_pop(state, 1);
    return value;
}

}  // namespace gsim::script
