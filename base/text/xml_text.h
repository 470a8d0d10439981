#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// A text as XML and HTML have it between tags, or in quotation marks; a control character, for which XML has
/// none, becomes a question mark, but for tabs and ends of lines.
std::string xml_text(std::string_view text);

}  // namespace gsim::text
