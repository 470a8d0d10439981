#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gsim::text {

/// Encoder of bytes as base64 (RFC 4648, section 4), in parts: the remainder of three bytes waits for the
/// next part, or for end().
class Base64 {
  public:
    /// Appends the digits to `text`.
    void add(std::string_view bytes, std::string& text);
    void end(std::string& text);

  private:
    std::string remaining_;
};

/// Returns the bytes of base64 with its padding, or nothing if the text is not base64.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace gsim::text
