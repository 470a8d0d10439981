#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <httplib.h>

namespace gsim::studio {

/// Why a request is not answered.
struct Refusal {
    int status = 403;
    std::string sentence;  ///< For who asked, and for the log; without the token.
};

/// What a request may bring along.
constexpr std::size_t kLargestBody = std::size_t{512} << 20U;

/// Why more than that is refused.
Refusal too_large();

/// The length of the body that a head announces; 0: none. One that is no number is 0, a negative one huge.
std::uint64_t announced_bytes(const httplib::Request& request);

/// Who may ask: a page that came from here. A page of another site that a browser is told to send here has
/// another origin; a name of another site that leads to this machine stands in `Host`; another program of
/// this machine does not know the token. Sources: RFC 9110 (Host), Fetch (Origin, Sec-Fetch-Site).
class Guard {
  public:
    /// `token`: the first part of each address that is answered.
    Guard(int port, std::string token);

    /// Nothing where a request is for the page, or one of its own.
    std::optional<Refusal> refuse(const httplib::Request& request) const;
    const std::string& token() const { return token_; }

  private:
    bool is_ours(const std::string& host) const;
    bool has_token(const std::string& path) const;

    int port_;
    std::string token_;
};

/// 32 hexadecimal digits that nobody can guess. Throws std::system_error where the system has none.
std::string random_token();

}  // namespace gsim::studio
