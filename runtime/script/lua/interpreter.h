#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <lua.hpp>

#include "runtime/script/lua/source_locator.h"
#include "runtime/script/words/arc_solution.h"
#include "runtime/script/words/program_frame.h"
#include "runtime/simulator/simulator.h"

namespace gsim::script {

inline constexpr std::size_t kMaxWordIds = 1024;

enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_revolution };

/// Modal state of the controller that the library's C++ side needs for a plain move; the Lua library sets it.
/// Machine coordinates are those of the frame at program value * unit.
struct ModalState {
    bool incremental = false;
    bool machine_frame_once = false;  ///< The moves of this block are in machine coordinates (G53).
    FeedMode feed_mode = FeedMode::per_minute;
    double feed = 0;                    ///< As programmed; 0: not set yet.
    double feed_unit_mm = 1;            ///< Unit in force when it was programmed.
    bool feed_is_new = false;           ///< No move has used it yet.
    bool inverse_time_by_angle = true;  ///< G93: 60/F s is the time of a radian of an arc, else of all of it.
    double spindle_rpm = 0;
    bool uvw_increments = true;  ///< U, V and W are increments of X, Y and Z on machines without such axes.
    Plane plane = Plane::xy;     ///< Plane of arcs.
    bool absolute_arc_centers = false;  ///< I, J and K are a point of the program, no vector from the start.
    ArcRules arc_rules;
    std::size_t modal_word = kMaxWordIds;  ///< Id of the modal motion; kMaxWordIds: not set yet.
};

/// Words that a motion accepts in addition to axis words.
class NonAxisWords {
  public:
    virtual ~NonAxisWords() = default;
    /// Returns false if the motion accepts no such word.
    virtual bool accept_word(std::string_view name, double value) = 0;
    /// Returns the names of these words.
    virtual std::vector<std::string_view> names() const = 0;
};

/// Interpreter of the words of one controller's scripts: connects its simulator, the modal state and the
/// source location in the script.
class Interpreter {
  public:
    Interpreter(simulation::Simulator& simulator, SourceLocator& locations);

    simulation::Simulator& simulator() { return simulator_; }
    const simulation::Simulator& simulator() const { return simulator_; }
    SourceLocator& locations() { return source_locator_; }
    ModalState& modal() { return modal_; }
    /// Returns the length of a program unit on linear axes in mm: 1, or 25.4 in inch mode.
    double unit_mm() const { return unit_mm_; }
    void set_unit_mm(double unit_mm);
    /// Returns the number of program units that 1 in a word of that axis (by its index) counts: 1, or 0.5 if
    /// it is a diameter. Applies to words alone, not to the values of the axis that the program reads.
    double word_factor(int axis) const { return word_factors_[axis]; }
    void set_word_factor(int axis, double factor);
    ProgramFrame& frame() { return frame_; }
    /// Returns the point that the program has reached, in machine coordinates. It is the position of the
    /// machine, unless the library has set another one (set_programmed).
    const simulation::AxisVector& programmed() const {
        return programmed_ ? *programmed_ : simulator_.position().axes();
    }
    void set_programmed(const std::optional<simulation::AxisVector>& point) { programmed_ = point; }
    const simulation::SourceLocation& location() const { return location_; }
    /// Returns the index of the axis with this lower or upper case letter, or -1.
    int axis(char letter) const;

    /// Begins a call of a word of the library: finds its source location. Counts a block if the line is
    /// another one or the word has been called in this block before. Raises the end of the run at its limit.
    void enter(lua_State* state, std::size_t word_id);
    /// Sets if the words belong to the process that runs. If they do not, `call` is called before a word
    /// acts, and may raise.
    void set_attached(bool attached) { attached_ = attached; }
    void on_foreign_word(std::function<void(lua_State*, Interpreter&)> call) {
        on_foreign_word_ = std::move(call);
    }
    void attach(lua_State* state) {
        if (!attached_) on_foreign_word_(state, *this);
    }
    /// Ends the program here, by one of its own words.
    void end_program() { program_ended_ = true; }
    /// Returns true if the program has ended since the last call.
    bool consume_program_end() { return std::exchange(program_ended_, false); }
    /// Makes this motion modal: `move` continues with it.
    void make_modal(lua_State* state, std::size_t word_id);
    /// Pushes the name of the modal motion.
    void push_motion(lua_State* state) const;
    /// Updates only the source location, for functions that are no words.
    void locate(lua_State* state, int level = 1) {
        const simulation::SourceLocation location = source_locator_.current(state, level);
        if (location.line > 0) location_ = location;
    }

    /// Ends the run with an alarm at the current source location; does not return.
    [[noreturn]] void alarm(lua_State* state, text::DiagnosticKind kind, const std::string& message);
    /// Continues if `done` is true. If it is false, the simulator has an alarm, and the run ends.
    void check(lua_State* state, bool done);
    /// Returns the feed of the next move; `sweep_rad` is that of an arc, which inverse time needs. Raises an
    /// alarm without F.
    simulation::Feed feed(lua_State* state, std::optional<double> sweep_rad);

    /// Reads axis words of the table at `index` into a target in machine coordinates. Keys that are no axis
    /// are passed to `others`, if given; keys that it does not accept raise an alarm. Returns true if one or
    /// more axes were given.
    bool read_target(lua_State* state, int index, NonAxisWords* others, simulation::AxisVector& target);
    /// Makes the move of a plain rapid or linear word with its words at `index`.
    void line(lua_State* state, bool rapid, int index);

    /// Reference in the registry to the function that converts words with `radius` and `angle` into Cartesian
    /// ones.
    int on_polar = LUA_NOREF;
    /// Tables of motions that the library has set; references in the registry.
    struct ModalTables {
        int environment = LUA_NOREF;  ///< Table with the function `move`.
        int names = LUA_NOREF;        ///< Name of each motion, by its id.
        int moves = LUA_NOREF;        ///< Function `move` while the motion is modal.
    };
    ModalTables modal_tables;

  private:
    struct WordError {
        std::string key;
        text::DiagnosticKind kind = text::DiagnosticKind::script;
        std::string message;
    };

    void update_word_factors();
    bool set_axis(char letter, double value, simulation::AxisVector& target, std::uint32_t& seen_axes);
    bool read_words(lua_State* state, int index, NonAxisWords* others, simulation::AxisVector& target,
                    std::uint32_t& seen_axes);
    void record_value_error(std::string_view key, const NonAxisWords* others);
    void record_word_error(std::string_view key, std::optional<double> value, const NonAxisWords* others);
    void record_word_error_message(std::string_view key, text::DiagnosticKind kind, std::string message);

    simulation::Simulator& simulator_;
    SourceLocator& source_locator_;
    ModalState modal_;
    double unit_mm_ = 1;
    simulation::AxisVector word_factors_;
    simulation::AxisVector word_mm_;  ///< Value of 1 in a word of an axis, mm or deg.
    simulation::SourceLocation location_;
    std::array<int, 26> axis_by_letter_{};
    ProgramFrame frame_;
    std::optional<simulation::AxisVector> programmed_;
    std::bitset<kMaxWordIds> words_in_block_;
    std::function<void(lua_State*, Interpreter&)> on_foreign_word_;
    std::optional<WordError> word_error_;  ///< First error by key, of the words that are read.
    std::size_t observed_bytes_ = 0;       ///< Already counted in the script's memory.
    bool attached_ = true;
    bool program_ended_ = false;
};

}  // namespace gsim::script
