#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gsim::text {

/// Bytes as base64 (RFC 4648, section 4), in pieces: what is left of three bytes waits for the next piece, or
/// for end().
class Base64 {
  public:
    /// Appends to `text`.
    void add(std::string_view bytes, std::string& text);
    void end(std::string& text);

  private:
    std::string rest_;
};

/// The bytes of base64 with its padding; nothing where it is none.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace gsim::text
