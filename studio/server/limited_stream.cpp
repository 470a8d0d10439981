#include "studio/server/limited_stream.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

namespace gsim::studio {

namespace {

using std::chrono::milliseconds;

constexpr std::size_t kReceiveBufferSize = std::size_t{64} << 10U;

/// Returns the subset of `events` for which the socket is ready, or 0 if none is in that time; -1: an error.
short wait_for(int socket, short events, milliseconds max_wait) {
    pollfd poll_entry{socket, events, 0};
    int ready = 0;
    do {
        ready = ::poll(&poll_entry, 1, static_cast<int>(std::max<long>(max_wait.count(), 0)));
    } while (ready < 0 && errno == EINTR);
    return ready < 0 ? short{-1} : poll_entry.revents;
}

using AddressFunction = int (*)(int, sockaddr*, socklen_t*);

void read_address(int socket, AddressFunction address_function, std::string& ip, int& port) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    std::array<char, INET_ADDRSTRLEN> text{};
    if (address_function(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
        address.sin_family != AF_INET)
        return;
    if (::inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size()) != nullptr) ip = text.data();
    port = ntohs(address.sin_port);
}

}  // namespace

LimitedStream::LimitedStream(int socket, const StreamLimits& bounds) : socket_(socket), limits_(bounds) {}

bool LimitedStream::is_readable() const {
    return at_ < buffer_.size() || (wait_for(socket_, POLLIN, limits_.pause) & POLLIN) != 0;
}

bool LimitedStream::is_writable() const {
    const short now = wait_for(socket_, POLLOUT | POLLRDHUP, limits_.pause);
    return (now & POLLOUT) != 0 && (now & (POLLRDHUP | POLLHUP | POLLERR)) == 0;
}

ssize_t LimitedStream::fill_buffer() {
    const auto elapsed = std::chrono::duration_cast<milliseconds>(Clock::now() - start_time_);
    const milliseconds remaining = (has_head() ? limits_.body : limits_.head) - elapsed;
    if (remaining.count() <= 0) return -1;
    if ((wait_for(socket_, POLLIN, std::min(remaining, limits_.pause)) & (POLLIN | POLLHUP)) == 0) return -1;
    buffer_.resize(kReceiveBufferSize);
    ssize_t bytes_read = 0;
    do {
        bytes_read = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    } while (bytes_read < 0 && errno == EINTR);
    buffer_.resize(static_cast<std::size_t>(std::max<ssize_t>(bytes_read, 0)));
    at_ = 0;
    return bytes_read;
}

// A line may also end with \n alone, as cpp-httplib accepts it.
void LimitedStream::find_head_end(char byte) {
    if (has_head()) return;
    ++head_bytes_;
    if (byte == '\r') return;
    newlines_ = byte == '\n' ? newlines_ + 1 : 0;
}

ssize_t LimitedStream::read(char* bytes, std::size_t size) {
    if (at_ == buffer_.size()) {
        if (const ssize_t bytes_read = fill_buffer(); bytes_read <= 0) return bytes_read;
    }
    const std::size_t copied_bytes = std::min(size, buffer_.size() - at_);
    std::copy_n(buffer_.data() + at_, copied_bytes, bytes);
    at_ += copied_bytes;
    for (std::size_t i = 0; i < copied_bytes; ++i) find_head_end(bytes[i]);
    if (!has_head() && head_bytes_ > limits_.head_bytes) return -1;
    return static_cast<ssize_t>(copied_bytes);
}

ssize_t LimitedStream::write(const char* bytes, std::size_t size) {
    if ((wait_for(socket_, POLLOUT, limits_.pause) & POLLOUT) == 0) return -1;
    ssize_t sent = 0;
    do {
        sent = ::send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    } while (sent < 0 && errno == EINTR);
    return sent < 0 && errno == EAGAIN ? 0 : sent;
}

void LimitedStream::get_remote_ip_and_port(std::string& ip, int& port) const {
    read_address(socket_, ::getpeername, ip, port);
}

void LimitedStream::get_local_ip_and_port(std::string& ip, int& port) const {
    read_address(socket_, ::getsockname, ip, port);
}

}  // namespace gsim::studio
