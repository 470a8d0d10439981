#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include <httplib.h>

namespace gsim::studio {

/// Limits of a connection. A request's head (its line and its headers) ends with an empty line.
struct StreamLimits {
    std::size_t head_bytes = std::size_t{64} << 10U;
    std::chrono::milliseconds head{5'000};    ///< For the complete head.
    std::chrono::milliseconds pause{10'000};  ///< Between parts of a body, read or written.
    std::chrono::milliseconds body{120'000};  ///< For the complete body.
};

/// Connection that cpp-httplib reads and writes. It ends if the other end sends too much or too slowly. It
/// does not close the socket.
class LimitedStream final : public httplib::Stream {
  public:
    explicit LimitedStream(int socket, const StreamLimits& bounds = {});

    /// Returns true if the complete head of the request has been read.
    bool has_head() const { return newlines_ == 2; }

    bool is_readable() const override;
    /// Returns false also if the other end has gone.
    bool is_writable() const override;
    ssize_t read(char* bytes, std::size_t size) override;
    ssize_t write(const char* bytes, std::size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override;
    void get_local_ip_and_port(std::string& ip, int& port) const override;
    socket_t socket() const override { return socket_; }

  private:
    using Clock = std::chrono::steady_clock;

    ssize_t fill_buffer();
    void find_head_end(char byte);

    int socket_;
    StreamLimits limits_;
    Clock::time_point start_time_ = Clock::now();
    std::size_t head_bytes_ = 0;
    int newlines_ = 0;    // consecutive; two end the head
    std::string buffer_;  // read, and not asked for yet
    std::size_t at_ = 0;
};

}  // namespace gsim::studio
