#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// A text for a terminal or a log: what could move its cursor, change its colours or the order of its letters
/// (control characters but for the end of a line and the tab, in one byte or in UTF-8, and marks of
/// direction, as of Unicode TR 36) is written as \u001b, and a byte that is no UTF-8 as \xff. JSON stays what
/// it was.
std::string printable(std::string_view text);

/// Whether there are no control characters in a text. One in the name of a file would cut it short for the
/// operating system, or spread errors over two lines.
bool is_printable(std::string_view text);

}  // namespace gsim::text
