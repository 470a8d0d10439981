#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace gsim::conformance {

/// One line of canonical output, `   12 N..... NAME(1.0, 2.0)`, split into its parts. They are views into
/// that line.
struct CanonCall {
    std::string_view name;
    std::string_view arguments;  ///< Text between the brackets.

    /// The arguments that are numbers, in order, parted by commas or blanks; others are left out.
    std::vector<double> numbers() const;
};

/// Returns the call in a line, or none if the line holds none.
std::optional<CanonCall> read_canon_call(std::string_view line);

}  // namespace gsim::conformance
