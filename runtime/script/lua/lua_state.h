#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <lua.hpp>

#include "base/os/cpu_limit.h"
#include "runtime/script/lua/small_blocks.h"

namespace gsim::script {

/// A Lua state that counts its memory and its steps. Running out of either cannot be caught by a script: what
/// is raised then is kStop, which the sandbox's pcall passes on.
class LuaState {
  public:
    struct Limits {
        std::size_t memory_bytes = std::size_t{2048} << 20U;
        std::uint64_t steps = 200'000'000;  ///< Instructions without a motion or a dwell in between.
    };
    /// Why kStop was raised, where it was the state itself that raised it.
    enum class Ended : std::uint8_t { no, memory, steps, cpu };

    /// What one value costs to copy, of the many that a call may have.
    static constexpr std::uint64_t kBytesOfValue = 4;

    /// What scripts may print: more is left out, and said so once.
    static constexpr std::size_t kMostPrinted_bytes = std::size_t{4} << 20U;

    explicit LuaState(Limits limits);
    ~LuaState();
    LuaState(const LuaState&) = delete;
    LuaState& operator=(const LuaState&) = delete;

    lua_State* get() const { return state_; }
    Ended ended() const { return refused_ ? Ended::memory : ended_; }
    /// The processor time is bounded from here on; null: no longer. `cpu` outlives the state.
    void end_by(os::CpuLimit* cpu) { cpu_ = cpu; }
    /// The machine has moved on: the count of steps starts anew.
    void restart_steps() { steps_ = 0; }
    /// Work inside one instruction, by the bytes that it touches: long strings and tables take time in which
    /// no instruction is counted.
    void count_work(std::uint64_t bytes);
    /// The same from a function that Lua calls, which ends the run here where that is too much.
    void charge(lua_State* state, std::uint64_t bytes);
    /// Instructions that are carried out without Lua counting them; ends the run where that is too much.
    void count_instructions(lua_State* state, std::uint64_t count) {
        steps_ += count * weight_;
        unchecked_ += count;
        if (unchecked_ >= kStepsBetweenCounts || steps_ > limits_.steps) check_limits(state);
    }
    /// There is a string, or a list of values, that any instruction may take so many bytes of to look at:
    /// from here on each counts as that much work.
    void note_large(std::uint64_t bytes);
    /// Memory outside of Lua that is kept for the script counts as its own from here on. Ends the run where
    /// that is too much; `what` is kept, and says what asks: "the text of the script".
    void hold(lua_State* state, std::size_t bytes, const char* what);
    /// It is kept no longer; `what` as it was said to hold().
    void give_back(std::size_t bytes, const char* what);
    /// What needs more memory than there is, as a sentence, where that ended the run: what holds most of it,
    /// or what asked.
    std::string memory_refusal() const;
    /// The how many-th table of this state it is; 0 where that is not known. Lua's order of tables as keys is
    /// that of their addresses, which differ from run to run.
    std::uint64_t serial_of_table(const void* table) const;
    const Limits& limits() const { return limits_; }
    /// Called before the run ends for its steps or its processor time, while the script's stack still stands.
    void on_last_step(std::function<void(lua_State*)> call) { on_last_step_ = std::move(call); }

    /// The thread that runs now; the main one unless told.
    void set_running(lua_State* thread);
    /// Called for each line that a watched thread begins; it may yield.
    void on_line(std::function<void(lua_State*, lua_Debug*)> call) { on_line_ = std::move(call); }
    void watch_lines(lua_State* thread, bool on) const;

    /// The LuaState of a lua_State.
    static LuaState& of(lua_State* state);
    /// Raises kStop; does not return.
    [[noreturn]] static void raise_stop(lua_State* state);
    /// True where the value at `index` is what raise_stop() raises.
    static bool is_stop(lua_State* state, int index);
    /// To be called on a caught error: an error that no script may catch is raised again.
    static void pass_on(lua_State* state, int status);

    /// What is to be written of a line that a script prints.
    std::string printed(std::string line);

  private:
    static constexpr int kStepsBetweenCounts = 10'000;

    /// A request for memory that was not fulfilled.
    struct Refusal {
        const char* what = "the script";
        std::size_t asked_bytes = 0;
        std::size_t held_bytes = 0;
        bool by_system = false;
    };

    static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
    void* resize(void* block, std::size_t held, std::size_t new_size);
    void release(void* block, std::size_t held);
    /// Memory outside of Lua, by what it is kept for.
    struct Held {
        const char* what;
        std::size_t bytes;
    };

    std::nullptr_t refuse(const Refusal& refusal);
    std::size_t& held_for(const char* what);
    const char* holder_of_most() const;
    static void on_hook(lua_State* state, lua_Debug* event);
    void count_steps(lua_State* state);
    void check_limits(lua_State* state);
    [[noreturn]] void end_for(Ended reason, lua_State* state);
    void number_table(void* table, std::size_t size);
    int steps_between_counts() const;
    static void set_hook(lua_State* thread, int steps);

    Limits limits_;
    os::CpuLimit* cpu_ = nullptr;
    SmallBlocks small_blocks_;
    std::size_t printed_bytes_ = 0;
    std::size_t bytes_ = 0;
    std::vector<Held> held_;  ///< A part of bytes_.
    std::uint64_t steps_ = 0;
    std::uint64_t unchecked_ = 0;  ///< Instructions since the limits were last looked at.
    std::uint64_t weight_ = 1;     ///< What an instruction counts as.
    std::uint64_t tables_ = 0;     ///< That were made.
    std::size_t table_bytes_ = 0;
    Ended ended_ = Ended::no;
    bool refused_ = false;  ///< The last request for more memory was.
    Refusal refusal_;
    std::function<void(lua_State*)> on_last_step_;
    std::function<void(lua_State*, lua_Debug*)> on_line_;
    lua_State* state_ = nullptr;
    lua_State* running_ = nullptr;
};

/// Memory outside of Lua that counts as the script's for as long as this lives.
class HeldMemory {
  public:
    HeldMemory(lua_State* state, std::size_t bytes, const char* what)
        : lua_(LuaState::of(state)), bytes_(bytes), what_(what) {
        lua_.hold(state, bytes, what);
    }
    ~HeldMemory() { lua_.give_back(bytes_, what_); }
    HeldMemory(const HeldMemory&) = delete;
    HeldMemory& operator=(const HeldMemory&) = delete;

  private:
    LuaState& lua_;
    std::size_t bytes_;
    const char* what_;
};

/// A C++ function as Lua calls it: an exception becomes an error of Lua with its text.
template <int (*Function)(lua_State*)>
int trampoline(lua_State* state) {
    // Lua's own errors pass as exceptions of another type; only what C++ throws is turned into one of Lua.
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

/// The object that set_function() bound.
template <typename Object>
Object& bound(lua_State* state) {
    return *static_cast<Object*>(lua_touserdata(state, lua_upvalueindex(1)));
}

/// Sets field `name` of the table on top of the stack.
inline void set_number(lua_State* state, const char* name, double value) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
}

/// The number of a field of the table at `index`, 0 where there is none; an error of Lua where it is no
/// number.
inline double number_field(lua_State* state, int index, const char* name) {
    lua_getfield(state, index, name);
    const double value = luaL_optnumber(state, -1, 0);
    lua_pop(state, 1);
    return value;
}

}  // namespace gsim::script
