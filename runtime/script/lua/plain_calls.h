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

/// A statement that is nothing but the call of a word with numbers: `G1{x=5.000, y=-2}`, `F(3000)`, `M8()`.
/// Texts are views of the text that was read.
struct PlainCall {
    using Number = std::variant<lua_Integer, lua_Number>;  ///< As Lua reads it: 3000 or 5.0.
    struct Field {
        std::string_view key;
        Number value;
    };
    static constexpr std::size_t kMostFields = 16;

    std::string_view word;
    std::optional<Number> argument;  ///< In parentheses.
    bool has_table = false;          ///< Braces instead, with `fields`.
    std::array<Field, kMostFields> all_fields;
    std::size_t field_count = 0;

    std::span<const Field> fields() const { return {all_fields.data(), field_count}; }
};

/// One line of Lua of plain calls and a comment at most, as gcode2lua writes nearly all.
class PlainLine {
  public:
    /// `line` is without its end. False where there is anything else in it: then there are no calls.
    /// A line by itself does not tell that its first word begins a statement; that of gcode2lua always does.
    bool read(std::string_view line);
    std::span<const PlainCall> calls() const { return {calls_.data(), count_}; }

  private:
    std::vector<PlainCall> calls_;  ///< The first of them; the others are kept for their room.
    std::size_t count_ = 0;
};

}  // namespace gsim::script
