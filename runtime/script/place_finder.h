#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <lua.hpp>

#include "runtime/simulation/move.h"

namespace gsim::script {

/// Knows where loaded texts come from: the chunk with the name "=#3" is entry 3. A line of a text that
/// gcode2lua wrote and nobody edited is told as the line of the G-code.
class PlaceFinder {
  public:
    struct Text {
        std::uint32_t file = 0;            ///< Index of the file that places name.
        std::int64_t line_difference = 0;  ///< Line in that file minus line in the chunk.
    };

    /// Adds a text and returns its chunk name.
    std::string add(Text text);
    /// Where the script is: the innermost function of a text, from stack level `level` on.
    simulation::Place current(lua_State* state, int level = 1) const;
    /// Takes "#3:12: " off the front of a message of Lua and returns that place; line 0 if there is none.
    simulation::Place strip(std::string& message) const;

  private:
    simulation::Place place(std::uint32_t text, std::int64_t chunk_line) const;

    std::vector<Text> texts_;
};

}  // namespace gsim::script
