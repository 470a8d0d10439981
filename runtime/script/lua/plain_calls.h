#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include <lua.hpp>

namespace gsim::script {

/// Statement that only calls a word with numbers: `G1{x=5.000, y=-2}`, `F(3000)`, `M8()`. Texts are views of
/// the text that was read.
struct PlainCall {
    using Number = std::variant<lua_Integer, lua_Number>;  ///< As Lua reads it: 3000 or 5.0.
    struct Field {
        std::string_view key;
        Number value;
    };
    static constexpr std::size_t kMaxFields = 16;

    std::string_view word;
    std::optional<Number> argument;  ///< In parentheses.
    bool has_table = false;          ///< Braces instead, with `fields`.
    std::array<Field, kMaxFields> all_fields;
    std::size_t field_count = 0;

    std::span<const Field> fields() const { return {all_fields.data(), field_count}; }
};

/// Line of Lua with plain calls and an optional comment, as gcode2lua writes nearly all.
class PlainLine {
  public:
    /// Reads `line`, which is without its end. Returns false if it has anything else in it; then calls() is
    /// empty. A single line does not show that its first word begins a statement; that of gcode2lua always
    /// does.
    bool read(std::string_view line);
    std::span<const PlainCall> calls() const { return {calls_.data(), count_}; }

  private:
    std::vector<PlainCall> calls_;  ///< The first count_ are valid; the others keep their memory.
    std::size_t count_ = 0;
};

}  // namespace gsim::script
