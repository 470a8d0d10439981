#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codegen/post/gcode_numbers.h"
#include "codegen/post/program_text.h"

namespace gsim::codegen {

/// Axis of the machine of a program.
struct GcodeAxis {
    char letter = 'X';
    bool rotary = false;  ///< In deg, otherwise mm.
};

/// Words of the axes, and their positions as they were printed last. A word without new content is left out.
class AxisWords {
  public:
    /// `inch`: lengths are written in inches. `verbose`: words are written though they have not changed.
    AxisWords(std::span<const GcodeAxis> axes, const DecimalFormat& length, const DecimalFormat& angle,
              bool inch, bool verbose);

    const std::vector<GcodeAxis>& axes() const { return axes_; }
    /// Returns the index of the axis with this letter, which must exist.
    std::size_t index_of(char letter) const;

    /// Returns a length in the program's unit.
    double in_unit(double mm) const;
    /// Returns a length in printed increments.
    std::int64_t length_increments(double mm) const { return length_.increments(in_unit(mm)); }
    /// Returns a value of an axis, in mm or deg, in printed increments.
    std::int64_t increments(std::size_t axis, double value) const;
    const DecimalFormat& length() const { return length_; }
    const DecimalFormat& format(std::size_t axis) const { return axes_[axis].rotary ? angle_ : length_; }
    std::string length_text(double mm) const;

    /// Writes the words of the axes that have changed.
    void write(ProgramText& block, std::span<const double> values);
    /// Returns true if a word would change; keeps the remainders of these values.
    bool would_change(std::span<const double> values);
    /// Sets the position of the axes, though no block has moved them there.
    void set_position(std::span<const double> values);
    bool is_at(std::size_t axis, double value) const { return increments(axis, value) == printed_[axis]; }
    /// Returns the value of an axis less the printed one, in the program's unit.
    double rounding_residual(std::size_t axis) const { return rounding_residuals_[axis]; }
    /// Makes the axis be written again.
    void forget_position(std::size_t axis);
    /// Makes all axes be written again.
    void forget_positions();
    /// Clears everything that was printed, because another program begins, or one has been called.
    void forget();

  private:
    std::int64_t round(std::size_t axis, double value);

    std::vector<GcodeAxis> axes_;
    DecimalFormat length_;
    DecimalFormat angle_;
    bool inch_;
    bool verbose_;
    std::vector<std::int64_t> printed_;  ///< Printed increments of each axis.
    std::vector<double> rounding_residuals_;
};

}  // namespace gsim::codegen
