#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gsim::studio {

/// Returns a message of segments reduced to the TCP path and its source lines, some 20 bytes for a segment
/// instead of 270; docs/studio-server.md has its layout. It is for runs that are too long for a page to hold;
/// the complete message can be requested by its number. Empty if `message` is another one. Throws
/// std::invalid_argument if it is no message, or has more segments than can be distinguished (65,536).
std::optional<std::string> compact_message(std::string_view message);

/// Returns the number of the first segment of a message of segments; nullopt for another message.
std::optional<std::uint64_t> first_segment(std::string_view message);

}  // namespace gsim::studio
