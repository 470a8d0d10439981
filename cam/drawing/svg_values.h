#pragma once

#include <optional>
#include <string_view>

#include <tl/expected.hpp>

#include "base/units.h"
#include "cam/drawing/affine.h"

namespace gsim::drawing {

/// A reader for numbers, flags and letters of SVG attributes, with blanks and commas between them.
class SvgScanner {
  public:
    explicit SvgScanner(std::string_view text) : text_(text) {}

    bool at_end();
    /// Reads a finite number.
    std::optional<double> number();
    /// Reads "0" or "1", which need no trailing separator.
    std::optional<bool> flag();
    /// Reads a letter, if one comes next.
    std::optional<char> letter();
    /// Reads letters up to another character.
    std::string_view word();
    bool consume(char c);
    std::size_t offset() const { return offset_; }

  private:
    void skip_blanks();

    std::string_view text_;
    std::size_t offset_ = 0;
};

/// Returns a length in px (1/96 inch) such as "12mm" or "3.5"; nothing if it is invalid or relative ("50%",
/// "2em").
std::optional<double> svg_length_px(std::string_view text);

/// Returns the map of a list such as "translate(3) rotate(30 1 2)"; nothing if it is invalid.
std::optional<Affine> svg_transform(std::string_view text);

inline constexpr double kMmPerPx = kMmPerInch / 96;

}  // namespace gsim::drawing
