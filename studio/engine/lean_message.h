#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gsim::studio {

/// A message of segments without all but the way of the tip and the lines that it comes from, some 20 bytes
/// for a segment in place of 270; docs/studio-server.md has its layout. For runs that are too long for a page
/// to hold; the whole message can be asked for by its number. Nothing where `message` is another one. Throws
/// std::invalid_argument where it is none, or has more segments than can be told apart (65,536).
std::optional<std::string> lean_message(std::string_view message);

/// The number of the first segment of a message of segments; nothing of another one.
std::optional<std::uint64_t> first_segment(std::string_view message);

}  // namespace gsim::studio
