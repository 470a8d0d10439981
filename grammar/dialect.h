#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lexer/block_text.h"
#include "lexer/style.h"

namespace gsim::grammar {

/// Modal groups: a block accepts one code of each group, and the last one given stays active.
enum class Group : std::uint8_t {
    none,
    motion,
    plane,
    units,
    distance,
    feed_mode,
    cutter_compensation,
    tool_length,
    cycle,
    return_level,
    scaling,
    mirror,
    rotation,
    work_frame,
    path_mode,
    polar,
    zone,
    macro,
    spindle_mode,
    acceleration,
    stop,
    spindle,
    tool_change,
    jet,
    abrasive,
    coolant,
    subprogram,
    override_switch,
    arc_distance,
    lathe_diameter,
    modal_state,
    input_output,
    extrusion,
    user,
    non_modal,  ///< The last one.
};

inline constexpr std::size_t kGroupCount = static_cast<std::size_t>(Group::non_modal) + 1;
std::string_view name(Group group);

/// Use of the axis words of a block by a code.
enum class AxisUse : std::uint8_t { none, motion, data };

/// Support of a code in the library. `without_words`: only without words, because it switches off something
/// that cannot be on; with words it is `later`.
enum class Support : std::uint8_t { full, without_words, planned };

/// Effect of cutter compensation on a code. It acts as usual, or is rejected, always or only while the tool
/// runs next to the path (RS274/NGC permits a radius of 0). Or the tool is led out before it and in again
/// after it (9/Series). Or the move before it ends first, whatever corner follows (RS274/NGC).
enum class Compensation : std::uint8_t {
    allowed,
    rejected,
    refused_next_to_path,
    lead_out_and_in,
    ends_move
};

/// Time in its block at which a code acts, here in the order of the 9/Series; another dialect has its own
/// (Dialect::rank). Words of one phase act in their order in the block.
enum class Phase : std::uint8_t {
    plane,
    units,
    compensation,
    tool_length,
    cycle,
    distance,
    work_frame,
    path_mode,
    feed_mode,
    feed,
    spindle_speed,
    tool,
    offset_number,
    tool_change,
    switch_on,
    dwell,
    data,
    polar,
    one_shot,
    motion,
    switch_off,
    spindle_stop,
    pause,
    flow,
    input_output,  ///< The last one.
};
inline constexpr std::size_t kPhaseCount = static_cast<std::size_t>(Phase::input_output) + 1;
/// Returns a description of the actions of a phase.
std::string_view name(Phase phase);

/// Row of a dialect's table.
struct Code {
    char letter;            ///< 'G' or 'M'
    std::int32_t code_x10;  ///< 921: G92.1
    Group group;
    Phase phase;
    AxisUse axes;
    std::string_view words;  ///< Letters it accepts in addition to axis words, '=' for AR=, '1' for I1= J1=
                             ///< K1=, ',' for ,C ,R ,A.
    Support support;
    std::string_view meaning;  ///< As messages and documents say it.
    Compensation compensation = Compensation::allowed;
};

/// Meaning of a letter, or of a longer address.
struct Letter {
    std::string_view address;
    std::string_view meaning;
};

/// Command with a name instead of a letter and a number. Its parameters are NAME=VALUE.
struct ExtendedCommand {
    std::string_view name;
    std::string_view parameters;  ///< Those that are numbers, between blanks,
    std::string_view texts;       ///< and those that are texts.
    std::string_view meaning;
};

/// Rules of a dialect's table in addition to its codes.
struct DialectRules {
    std::string_view name;             ///< As --dialect has it.
    std::string_view title;            ///< As people call it.
    lexer::Style style;                ///< Style of its text.
    std::string_view lua_module;       ///< Module that its scripts require.
    std::string_view standalone = {};  ///< Letters that are words by themselves, if no code accepts them.
    std::string_view move_words = {};  ///< Letters that a modal motion accepts in addition to axis words.
    std::string_view initial;          ///< Codes in force when a program begins, between blanks.
    std::span<const Letter> letters;
    std::span<const Phase> order =
        {};  ///< Execution order in a block; phases that are not listed come after them.
    std::span<const ExtendedCommand> extended = {};
};

/// Language of part programs: its codes, by table.
class Dialect {
  public:
    Dialect(const DialectRules& rules, std::span<const Code> codes);

    std::string name() const { return std::string(rules_.name); }
    std::string_view title() const { return rules_.title; }
    const DialectRules& rules() const { return rules_; }
    /// Returns the rank of a phase: phases of a block act in ascending order of it.
    int rank(Phase phase) const { return ranks_[static_cast<std::size_t>(phase)]; }
    /// Returns the row of a code, or null if the dialect has no such code.
    const Code* find(char letter, std::int32_t code_x10) const;
    std::span<const Code> codes() const { return codes_; }

  private:
    DialectRules rules_;
    std::span<const Code> codes_;
    std::array<int, kPhaseCount> ranks_;
    std::vector<std::uint16_t> index_;  // by letter and number; 0: no code, else row + 1
};

/// Returns Allen-Bradley 9/Series, with the codes of the thesis (Appendix C and E).
const Dialect& dialect_ab9();
/// Returns RS274/NGC as in LinuxCNC 2.9.
const Dialect& dialect_rs274ngc();
/// Returns Klipper, as klippy reads it.
const Dialect& dialect_klipper();
/// Returns all dialects.
std::span<const Dialect* const> dialects();
/// Returns the dialect with this name ("ab9", "rs274ngc", "klipper"), or null.
const Dialect* find_dialect(std::string_view name);

/// Returns the usual name of a code: "G92.1", "M8".
std::string code_name(const Code& code);
/// Returns the function of the Lua library: "G92_1", "M8", "M[101]".
std::string lua_name(const Code& code);

}  // namespace gsim::grammar
