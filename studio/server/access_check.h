#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <httplib.h>

#include "base/error.h"

namespace gsim::studio {

/// Reason why a request is rejected. The message is for the requester and the log; it is without the token.
struct RequestError : Error {
    int status = 403;  ///< Status of HTTP.
};

/// Max size of a request's body.
constexpr std::size_t kMaxBodyBytes = std::size_t{512} << 20U;

/// Returns the reason why larger bodies are rejected.
RequestError too_large();

/// Returns the length of the body that a head announces; 0: none. A length that is no number is 0, a negative
/// one huge.
std::uint64_t declared_body_bytes(const httplib::Request& request);

/// Access check: only a page from this server may send requests. A page of another site that makes a browser
/// send requests here has another origin. A name of another site that leads to this computer is in `Host`.
/// Another program of this computer does not know the token. Sources: RFC 9110 (Host), Fetch (Origin,
/// Sec-Fetch-Site).
class AccessCheck {
  public:
    /// `token`: the first part of each accepted address.
    AccessCheck(int port, std::string token);

    /// Returns no value if a request is for the page, or one of the page's requests.
    std::optional<RequestError> reject(const httplib::Request& request) const;
    const std::string& token() const { return token_; }

  private:
    bool is_this_server(const std::string& host) const;
    bool has_token(const std::string& path) const;

    int port_;
    std::string token_;
};

/// Returns 32 unpredictable hexadecimal digits. Throws std::system_error if the system has none.
std::string random_token();

}  // namespace gsim::studio
