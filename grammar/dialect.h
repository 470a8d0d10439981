#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lexer/block_text.h"

namespace gsim::grammar {

/// Modal groups: of one group a block takes one code, and the last one given stays in force.
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
    subprogram,
    override_switch,
};

std::string_view name(Group group);

/// What a code does with the axis words of its block.
enum class AxisUse : std::uint8_t { none, motion, data };

/// Whether the library does what the code means. `bare_only`: only without words, where it switches off what
/// cannot be on; with words it is `later`.
enum class Support : std::uint8_t { full, bare_only, later };

/// When in its block a code acts; words of one phase act in the order in which they stand.
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
};

/// One row of a dialect's table.
struct Code {
    char letter;            ///< 'G' or 'M'
    std::int32_t code_x10;  ///< 921: G92.1
    Group group;
    Phase phase;
    AxisUse axes;
    std::string_view words;  ///< Letters it takes besides axis words, '=' for AR=, '1' for I1= J1= K1=.
    Support support;
    std::string_view meaning;  ///< As messages and documents say it.
};

/// A language of part programs: its codes, by table.
class Dialect {
  public:
    Dialect(std::string_view name, std::string_view title, std::span<const Code> codes);

    std::string_view name() const { return name_; }    ///< As --dialect has it.
    std::string_view title() const { return title_; }  ///< As people call it.
    /// The row of a code, or null where the dialect has no such code.
    const Code* find(char letter, std::int32_t code_x10) const;
    std::span<const Code> codes() const { return codes_; }

  private:
    std::string_view name_;
    std::string_view title_;
    std::span<const Code> codes_;
    std::vector<std::uint16_t> index_;  // by letter and number; 0: none, else row + 1
};

/// Allen-Bradley 9/Series, with the codes of the thesis (Appendix C and E).
const Dialect& dialect_ab9();

/// "G92.1", "M8": the code as people write it.
std::string code_name(const Code& code);
/// "G92_1", "M8": the function of the Lua library.
std::string lua_name(const Code& code);

}  // namespace gsim::grammar
