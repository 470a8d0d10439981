#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <lua.hpp>

#include "runtime/simulator/move.h"

namespace gsim::script {

/// Position of a C function that runs the lines of a text itself: the first value on its stack, as a userdata
/// that begins with this.
struct LinePosition {
    const void* mark;    ///< Identifies it, see SourceLocator::begin().
    std::uint32_t text;  ///< That the SourceLocator has, and a line of it
    std::int64_t line;   ///< from 1.
};

/// Source locations of loaded texts: the chunk with the name "=#3" is entry 3. A line of an unedited text
/// from gcode2lua is reported as the line of the G-code.
class SourceLocator {
  public:
    struct Text {
        std::uint32_t file = 0;        ///< Index of the file of source locations.
        std::int64_t line_offset = 0;  ///< Line in that file minus line in the chunk.
    };

    /// Adds a text and returns its number.
    std::uint32_t add(Text text);
    /// Returns the name of a chunk of Lua that has the text.
    static std::string chunk_name(std::uint32_t text);
    /// Returns a position in a text that current() can find.
    static LinePosition begin(std::uint32_t text) { return {&kMark, text, 0}; }
    /// Returns the source location of the script: the innermost function of a text, from stack level `level`
    /// on.
    simulation::SourceLocation current(lua_State* state, int level = 1) const;
    /// Removes "#3:12: " from the front of a message of Lua and returns that source location; line 0 if it is
    /// missing.
    simulation::SourceLocation strip(std::string& message) const;

  private:
    static constexpr char kMark = 0;

    static const LinePosition* position(lua_State* state, const lua_Debug& frame);
    simulation::SourceLocation location(std::uint32_t text, std::int64_t chunk_line) const;

    std::vector<Text> texts_;
};

}  // namespace gsim::script
