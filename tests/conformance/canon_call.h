#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace gsim::conformance {

/// One line of canonical output, `   12 N..... NAME(1.0, 2.0)`, taken apart. Views into that line.
struct CanonCall {
    std::string_view name;
    std::string_view arguments;  ///< What stands between the brackets.

    /// The arguments that are numbers, in order, parted by commas or blanks; others are left out.
    std::vector<double> numbers() const;
};

/// The call in a line; nothing in a line that holds none.
std::optional<CanonCall> read_canon_call(std::string_view line);

}  // namespace gsim::conformance
