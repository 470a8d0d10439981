#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// Returns a text for XML and HTML between tags, or in quotation marks. A control character, which XML does
/// not have, becomes a question mark, except tabs and ends of lines.
std::string xml_text(std::string_view text);

}  // namespace gsim::text
