#include "studio/server/access_check.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>
#include <sys/random.h>

namespace gsim::studio {

namespace {

constexpr std::size_t kMaxTargetLength = 4096;
constexpr std::array kMethods = {"GET", "POST", "PUT"};
constexpr std::size_t kTokenBytes = 16;

/// The duration does not reveal where the texts differ.
bool equal_in_constant_time(const std::string& a, const std::string& b) {
    unsigned difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
    return difference == 0;
}

}  // namespace

RequestError too_large() {
    return {{fmt::format("a request may have at most {} MiB", kMaxBodyBytes >> 20U)}, 413};
}

std::uint64_t declared_body_bytes(const httplib::Request& request) {
    const bool may_have_body = request.method == "POST" || request.method == "PUT";
    if (!may_have_body || request.has_header("Transfer-Encoding")) return 0;
    return std::strtoull(request.get_header_value("Content-Length").c_str(), nullptr, 10);
}

AccessCheck::AccessCheck(int port, std::string token) : port_(port), token_(std::move(token)) {}

bool AccessCheck::is_this_server(const std::string& host) const {
    return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

bool AccessCheck::has_token(const std::string& path) const {
    if (path.empty() || path.front() != '/') return false;
    const std::size_t end = path.find('/', 1);
    return end != std::string::npos && equal_in_constant_time(path.substr(1, end - 1), token_);
}

std::optional<RequestError> AccessCheck::reject(const httplib::Request& request) const {
    if (std::find(kMethods.begin(), kMethods.end(), request.method) == kMethods.end())
        return RequestError{{fmt::format("the method {} is not supported", request.method)}, 405};
    if (request.target.size() > kMaxTargetLength) return RequestError{{"the address is too long"}, 414};
    if (request.get_header_value_count("Host") != 1 || !is_this_server(request.get_header_value("Host")))
        return RequestError{
            {fmt::format("the host '{}' is not this server", request.get_header_value("Host"))}, 403};
    if (!has_token(request.path))
        return RequestError{{"the address does not contain the token of this run"}, 403};
    // Users may open the page from anywhere: by a click, from a file.
    const bool is_page_request = request.method == "GET" && request.path == "/" + token_ + "/";
    if (const std::string origin = request.get_header_value("Origin"); request.has_header("Origin")) {
        constexpr std::string_view kScheme = "http://";
        if (origin.rfind(kScheme, 0) != 0 || !is_this_server(origin.substr(kScheme.size())))
            return RequestError{{fmt::format("the origin '{}' is not this server", origin)}, 403};
    }
    const std::string site = request.get_header_value("Sec-Fetch-Site");
    if (!is_page_request && !site.empty() && site != "same-origin" && site != "none")
        return RequestError{{fmt::format("the request comes from a page of another site ('{}')", site)}, 403};
    if (declared_body_bytes(request) > kMaxBodyBytes) return too_large();
    return std::nullopt;
}

std::string random_token() {
    std::array<std::uint8_t, kTokenBytes> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw std::system_error(errno, std::generic_category(), "random numbers are not available");
    std::string text;
    for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}", byte);
    return text;
}

}  // namespace gsim::studio
