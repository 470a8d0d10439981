#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// Returns a text that is safe for a terminal or a log. Characters that could move its cursor, change its
/// colours or the order of its letters are written as \u001b. These are control characters (except the end of
/// a line and the tab, in one byte or in UTF-8) and marks of direction, as of Unicode TR 36. A byte that is
/// not UTF-8 is written as \xff. JSON is not changed.
std::string printable(std::string_view text);

/// True if a text has no control characters. In a file name one would cut the name short for the operating
/// system, or spread errors over two lines.
bool is_printable(std::string_view text);

}  // namespace gsim::text
