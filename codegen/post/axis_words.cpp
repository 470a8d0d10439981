#include "codegen/post/axis_words.h"

#include <algorithm>

#include "base/units.h"

namespace gsim::codegen {

AxisWords::AxisWords(std::span<const GcodeAxis> axes, const DecimalFormat& length, const DecimalFormat& angle,
                     bool inch, bool verbose)
    : axes_(axes.begin(), axes.end()),
      length_(length),
      angle_(angle),
      inch_(inch),
      verbose_(verbose),
      printed_(axes.size(), kUnknownIncrements),
      rounding_residuals_(axes.size(), 0) {}

std::size_t AxisWords::index_of(char letter) const {
    const auto found = std::find_if(axes_.begin(), axes_.end(),
                                    [letter](const GcodeAxis& axis) { return axis.letter == letter; });
    return static_cast<std::size_t>(found - axes_.begin());
}

double AxisWords::in_unit(double mm) const {
    return inch_ ? mm / kMmPerInch : mm;
}

std::int64_t AxisWords::increments(std::size_t axis, double value) const {
    return axes_[axis].rotary ? angle_.increments(value) : length_increments(value);
}

std::string AxisWords::length_text(double mm) const {
    fmt::memory_buffer number;
    length_.append(number, length_increments(mm));
    return fmt::to_string(number);
}

/// Returns the printed value, and keeps its remainder.
std::int64_t AxisWords::round(std::size_t axis, double value) {
    const std::int64_t printed_increments = increments(axis, value);
    rounding_residuals_[axis] =
        (axes_[axis].rotary ? value : in_unit(value)) - format(axis).value(printed_increments);
    return printed_increments;
}

void AxisWords::write(ProgramText& block, std::span<const double> values) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::int64_t next = round(i, values[i]);
        if (next == printed_[i] && !verbose_) continue;
        printed_[i] = next;
        block.word(axes_[i].letter, next, format(i));
    }
}

bool AxisWords::would_change(std::span<const double> values) {
    bool changes = false;
    for (std::size_t i = 0; i < axes_.size(); ++i) changes = round(i, values[i]) != printed_[i] || changes;
    return changes;
}

void AxisWords::set_position(std::span<const double> values) {
    for (std::size_t i = 0; i < axes_.size(); ++i) printed_[i] = round(i, values[i]);
}

void AxisWords::forget_position(std::size_t axis) {
    printed_[axis] = kUnknownIncrements;
}

void AxisWords::forget_positions() {
    std::fill(printed_.begin(), printed_.end(), kUnknownIncrements);
}

void AxisWords::forget() {
    forget_positions();
    std::fill(rounding_residuals_.begin(), rounding_residuals_.end(), 0);
}

}  // namespace gsim::codegen
