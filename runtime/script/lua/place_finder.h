#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <lua.hpp>

#include "runtime/simulator/move.h"

namespace gsim::script {

/// Where a C function is that runs the lines of a text itself: the first value on its stack, as a userdata
/// that begins with this.
struct LinePosition {
    const void* mark;    ///< Tells it from others, see PlaceFinder::begin().
    std::uint32_t text;  ///< That the PlaceFinder has, and a line of it
    std::int64_t line;   ///< from 1.
};

/// Knows where loaded texts come from: the chunk with the name "=#3" is entry 3. A line of a text that
/// gcode2lua wrote and nobody edited is told as the line of the G-code.
class PlaceFinder {
  public:
    struct Text {
        std::uint32_t file = 0;            ///< Index of the file that places name.
        std::int64_t line_difference = 0;  ///< Line in that file minus line in the chunk.
    };

    /// Adds a text and returns its number.
    std::uint32_t add(Text text);
    /// The name of a chunk of Lua that has the text.
    static std::string chunk_name(std::uint32_t text);
    /// A position in a text that current() knows.
    static LinePosition begin(std::uint32_t text) { return {&kMark, text, 0}; }
    /// Where the script is: the innermost function of a text, from stack level `level` on.
    simulation::Place current(lua_State* state, int level = 1) const;
    /// Takes "#3:12: " off the front of a message of Lua and returns that place; line 0 if there is none.
    simulation::Place strip(std::string& message) const;

  private:
    static constexpr char kMark = 0;

    static const LinePosition* position(lua_State* state, const lua_Debug& frame);
    simulation::Place place(std::uint32_t text, std::int64_t chunk_line) const;

    std::vector<Text> texts_;
};

}  // namespace gsim::script
