#include "runtime/script/lua/interpreter.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/units.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/words/word_advice.h"

namespace gsim::script {

using text::DiagnosticKind;

using simulation::AxisVector;
using simulation::Feed;
using simulation::SourceLocation;

namespace {

constexpr std::string_view kArcWords = "ijkr";

std::array<int, 26> index_axes(const machine::Machine& machine) {
    std::array<int, 26> by_letter;
    by_letter.fill(-1);
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        by_letter[static_cast<std::size_t>(machine.axes[i].letter - 'A')] = static_cast<int>(i);
    return by_letter;
}

}  // namespace

Interpreter::Interpreter(simulation::Simulator& simulator, SourceLocator& locations)
    : simulator_(simulator),
      source_locator_(locations),
      axis_by_letter_(index_axes(simulator.machine())),
      frame_(simulator.machine().axes.size(), {axis('X'), axis('Y'), axis('Z')}) {
    word_factors_.setOnes(static_cast<Eigen::Index>(simulator.machine().axes.size()));
    update_word_factors();
}

void Interpreter::set_unit_mm(double unit_mm) {
    unit_mm_ = unit_mm;
    update_word_factors();
}

void Interpreter::set_word_factor(int axis, double factor) {
    word_factors_[axis] = factor;
    update_word_factors();
}

/// Computes this at each change, because each word of each move is read by it.
void Interpreter::update_word_factors() {
    word_mm_ = word_factors_;
    for (std::size_t i = 0; i < simulator_.machine().axes.size(); ++i) {
        const bool linear = simulator_.machine().axes[i].kind == machine::AxisKind::linear;
        if (linear) word_mm_[static_cast<Eigen::Index>(i)] *= unit_mm_;
    }
}

int Interpreter::axis(char letter) const {
    const int index = (letter | 0x20) - 'a';
    return index >= 0 && index < 26 ? axis_by_letter_[static_cast<std::size_t>(index)] : -1;
}

void Interpreter::enter(lua_State* state, std::size_t word_id) {
    attach(state);
    const SourceLocation location = source_locator_.current(state);
    if (location.line != location_.line || location.file != location_.file || words_in_block_[word_id]) {
        words_in_block_.reset();
        modal_.machine_frame_once = false;
        location_ = location;
        if (!simulator_.outcome().count_block(location)) LuaState::raise_stop(state);
    }
    words_in_block_[word_id] = true;
}

void Interpreter::make_modal(lua_State* state, std::size_t word_id) {
    if (modal_.modal_word == word_id) return;
    modal_.modal_word = word_id;
    const auto id = static_cast<lua_Integer>(word_id);
    lua_rawgeti(state, LUA_REGISTRYINDEX, modal_tables.environment);
    lua_rawgeti(state, LUA_REGISTRYINDEX, modal_tables.moves);
    lua_rawgeti(state, -1, id);
    lua_setfield(state, -3, "move");
    lua_pop(state, 2);
}

void Interpreter::push_motion(lua_State* state) const {
    lua_rawgeti(state, LUA_REGISTRYINDEX, modal_tables.names);
    lua_rawgeti(state, -1, static_cast<lua_Integer>(modal_.modal_word));
    lua_remove(state, -2);
}

void Interpreter::alarm(lua_State* state, DiagnosticKind kind, const std::string& message) {
    simulator_.outcome().fail(kind, message, location_);
    LuaState::raise_stop(state);
}

void Interpreter::check(lua_State* state, bool done) {
    if (!done) LuaState::raise_stop(state);
    LuaState& lua = LuaState::of(state);
    lua.restart_steps();
    if (const std::size_t bytes = simulator_.notifier().observed_bytes(); bytes > observed_bytes_) {
        lua.add_external_bytes(state, bytes - observed_bytes_, "the path of the run (--record)");
        observed_bytes_ = bytes;
    }
}

Feed Interpreter::feed(lua_State* state, std::optional<double> sweep_rad) {
    const bool is_new = modal_.feed_is_new;
    modal_.feed_is_new = false;
    if (modal_.feed_mode == FeedMode::inverse_time) {
        if (!is_new)
            alarm(state, DiagnosticKind::feed,
                  "inverse time feed (G93) needs an F in each block with a motion");
        Feed feed;
        feed.motion_s =
            (modal_.inverse_time_by_angle ? sweep_rad.value_or(1.0) : 1.0) * kSecondsPerMinute / modal_.feed;
        return feed;
    }
    if (modal_.feed <= 0)
        alarm(state, DiagnosticKind::feed, "no feed is active: program F before the first feed move");
    double per_min = 1;
    if (modal_.feed_mode == FeedMode::per_revolution) {
        if (modal_.spindle_rpm <= 0)
            alarm(state, DiagnosticKind::spindle, "feed per revolution (G95) needs a spindle speed S");
        per_min = modal_.spindle_rpm;
    }
    Feed feed;
    feed.linear_mm_min = modal_.feed * modal_.feed_unit_mm * per_min;
    feed.rotary_deg_min = modal_.feed * per_min;
    if (modal_.feed_mode == FeedMode::per_revolution) feed.linear_mm_rev = modal_.feed * modal_.feed_unit_mm;
    return feed;
}

bool Interpreter::set_axis(char letter, double value, AxisVector& target, std::uint32_t& seen_axes) {
    int index = axis(letter);
    bool incremental = modal_.incremental;
    if (index < 0 && modal_.uvw_increments && letter >= 'u' &&
        letter <= 'w') {  // an increment of X, Y or Z (Table 2.2 of the thesis)
        index = axis(static_cast<char>(letter + 3));
        incremental = true;
    }
    if (index < 0) return false;
    if (!std::isfinite(value)) {
        record_word_error_message(
            {&letter, 1}, DiagnosticKind::script,
            fmt::format("the value of {} is not a number", static_cast<char>(letter - 'a' + 'A')));
    }
    if ((seen_axes & (1U << static_cast<unsigned>(index))) != 0) {
        const char axis = simulator_.machine().axes[static_cast<std::size_t>(index)].letter;
        const char key = static_cast<char>(axis - 'A' + 'a');
        record_word_error_message(
            {&key, 1}, DiagnosticKind::word_twice,
            fmt::format("axis {} is given twice, as itself and as its increment", axis));
    }
    seen_axes |= 1U << static_cast<unsigned>(index);
    const machine::Axis& moved = simulator_.machine().axes[static_cast<std::size_t>(index)];
    const double distance = value * word_mm_[index];
    if (modal_.machine_frame_once) {
        target[index] = machine::rotary_target(moved, distance, target[index], 0);
    } else if (incremental) {
        target[index] += distance;
    } else if (frame_.has_matrix()) {
        target[index] = machine::rotary_target(moved, distance, target[index], frame_.offset(index));
    } else {
        target[index] = machine::rotary_target(moved, distance + frame_.offset(index), target[index], 0);
    }
    return true;
}

/// Reports, of several errors, that of the first key by its letters, because Lua's order of keys differs from
/// run to run.
void Interpreter::record_word_error_message(std::string_view key, DiagnosticKind kind, std::string message) {
    if (!word_error_ || key < word_error_->key)
        word_error_ = WordError{.key = std::string(key), .kind = kind, .message = std::move(message)};
}

void Interpreter::record_value_error(std::string_view key, const NonAxisWords* others) {
    if (key.size() == 1 && key[0] >= 'A' && key[0] <= 'Z')
        return record_word_error(key, std::nullopt, others);
    record_word_error_message(key, DiagnosticKind::script,
                              fmt::format("the value of '{}' is not a number", key));
}

void Interpreter::record_word_error(std::string_view key, std::optional<double> value,
                                    const NonAxisWords* others) {
    if (key.size() == 1 && kArcWords.find(key) != std::string_view::npos && others == nullptr) {
        return record_word_error_message(
            key, DiagnosticKind::word_out_of_place,
            "I, J, K and R need an arc, but the active motion is a straight line");
    }
    if (key.size() == 1 && std::string_view("abcuvwxyz").find(key) != std::string_view::npos) {
        return record_word_error_message(
            key, DiagnosticKind::axis,
            fmt::format("the machine '{}' has no axis {}", simulator_.machine().name,
                        static_cast<char>(key[0] - 'a' + 'A')));
    }
    std::vector<std::string> letters;
    for (const machine::Axis& axis : simulator_.machine().axes)
        letters.emplace_back(1, static_cast<char>(axis.letter | 0x20));
    std::vector<std::string_view> used_letters(letters.begin(), letters.end());
    if (others != nullptr) {
        const std::vector<std::string_view> further = others->names();
        used_letters.insert(used_letters.end(), further.begin(), further.end());
    }
    record_word_error_message(
        key, DiagnosticKind::word_out_of_place,
        fmt::format("'{}' is not a word of this motion{}", key, word_advice(key, value, used_letters)));
}

/// `target` is in program coordinates here if a matrix is active, else in machine coordinates. Returns false
/// if the target is in polar form.
bool Interpreter::read_words(lua_State* state, int index, NonAxisWords* others, AxisVector& target,
                             std::uint32_t& seen_axes) {
    word_error_.reset();
    for (lua_pushnil(state); lua_next(state, index) != 0; lua_pop(state, 1)) {
        if (lua_type(state, -2) != LUA_TSTRING)
            alarm(state, DiagnosticKind::script, "the words of a motion must be named: x=1, y=2");
        std::size_t size = 0;
        const char* text = lua_tolstring(state, -2, &size);
        const std::string_view key(text, size);
        int is_number = 0;
        const double value = lua_tonumberx(state, -1, &is_number);
        if (is_number == 0) {
            record_value_error(key, others);
            continue;
        }
        if (size == 1 && key[0] >= 'a' && key[0] <= 'z' && set_axis(key[0], value, target, seen_axes))
            continue;
        if (on_polar != LUA_NOREF && (key == "radius" || key == "angle")) {
            lua_pop(state, 2);
            return false;
        }
        if (others == nullptr || !others->accept_word(key, value)) record_word_error(key, value, others);
    }
    if (word_error_) alarm(state, word_error_->kind, word_error_->message);
    return true;
}

bool Interpreter::read_target(lua_State* state, int index, NonAxisWords* others, AxisVector& target) {
    target = programmed();
    if (lua_isnoneornil(state, index)) return false;
    luaL_checktype(state, index, LUA_TTABLE);
    std::uint32_t seen_axes = 0;
    const bool is_transformed = frame_.has_matrix() && !modal_.machine_frame_once;
    AxisVector values = is_transformed ? frame_.to_program(target) : target;
    if (!read_words(state, index, others, values, seen_axes)) {
        lua_rawgeti(state, LUA_REGISTRYINDEX, on_polar);
        lua_pushvalue(state, index);
        lua_call(state, 1, 1);
        return read_target(state, lua_gettop(state), others, target);
    }
    if (seen_axes != 0) target = is_transformed ? frame_.to_machine(values) : values;
    return seen_axes != 0;
}

void Interpreter::line(lua_State* state, bool rapid, int index) {
    simulation::LineMove move;
    if (!read_target(state, index, nullptr, move.target)) return;
    move.kind = rapid ? simulation::MoveKind::rapid : simulation::MoveKind::linear;
    if (!rapid) move.feed = feed(state, std::nullopt);
    move.location = location_;
    check(state, simulator_.moves().enqueue(move));
}

}  // namespace gsim::script
