#include "studio/server/guarded_stream.h"

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

constexpr std::size_t kReceived = std::size_t{64} << 10U;

/// Returns the subset of `events` for which the socket is ready, or 0 after that time; -1: an error.
short wait_for(int socket, short events, milliseconds longest) {
    pollfd asked{socket, events, 0};
    int ready = 0;
    do {
        ready = ::poll(&asked, 1, static_cast<int>(std::max<long>(longest.count(), 0)));
    } while (ready < 0 && errno == EINTR);
    return ready < 0 ? short{-1} : asked.revents;
}

using Naming = int (*)(int, sockaddr*, socklen_t*);

void address_of(int socket, Naming naming, std::string& ip, int& port) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    std::array<char, INET_ADDRSTRLEN> text{};
    if (naming(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0 || address.sin_family != AF_INET)
        return;
    if (::inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size()) != nullptr) ip = text.data();
    port = ntohs(address.sin_port);
}

}  // namespace

GuardedStream::GuardedStream(int socket, const StreamBounds& bounds) : socket_(socket), bounds_(bounds) {}

bool GuardedStream::is_readable() const {
    return at_ < buffer_.size() || (wait_for(socket_, POLLIN, bounds_.pause) & POLLIN) != 0;
}

bool GuardedStream::is_writable() const {
    const short now = wait_for(socket_, POLLOUT | POLLRDHUP, bounds_.pause);
    return (now & POLLOUT) != 0 && (now & (POLLRDHUP | POLLHUP | POLLERR)) == 0;
}

ssize_t GuardedStream::refill() {
    const auto spent = std::chrono::duration_cast<milliseconds>(Clock::now() - began_);
    const milliseconds left = (has_head() ? bounds_.body : bounds_.head) - spent;
    if (left.count() <= 0) return -1;
    if ((wait_for(socket_, POLLIN, std::min(left, bounds_.pause)) & (POLLIN | POLLHUP)) == 0) return -1;
    buffer_.resize(kReceived);
    ssize_t got = 0;
    do {
        got = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    } while (got < 0 && errno == EINTR);
    buffer_.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    at_ = 0;
    return got;
}

// A line may also end with \n alone, as cpp-httplib accepts it.
void GuardedStream::look_for_end(char byte) {
    if (has_head()) return;
    ++head_bytes_;
    if (byte == '\r') return;
    newlines_ = byte == '\n' ? newlines_ + 1 : 0;
}

ssize_t GuardedStream::read(char* bytes, std::size_t size) {
    if (at_ == buffer_.size()) {
        if (const ssize_t got = refill(); got <= 0) return got;
    }
    const std::size_t taken = std::min(size, buffer_.size() - at_);
    std::copy_n(buffer_.data() + at_, taken, bytes);
    at_ += taken;
    for (std::size_t i = 0; i < taken; ++i) look_for_end(bytes[i]);
    if (!has_head() && head_bytes_ > bounds_.head_bytes) return -1;
    return static_cast<ssize_t>(taken);
}

ssize_t GuardedStream::write(const char* bytes, std::size_t size) {
    if ((wait_for(socket_, POLLOUT, bounds_.pause) & POLLOUT) == 0) return -1;
    ssize_t sent = 0;
    do {
        sent = ::send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    } while (sent < 0 && errno == EINTR);
    return sent < 0 && errno == EAGAIN ? 0 : sent;
}

void GuardedStream::get_remote_ip_and_port(std::string& ip, int& port) const {
    address_of(socket_, ::getpeername, ip, port);
}

void GuardedStream::get_local_ip_and_port(std::string& ip, int& port) const {
    address_of(socket_, ::getsockname, ip, port);
}

}  // namespace gsim::studio
