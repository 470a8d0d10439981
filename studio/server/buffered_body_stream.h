#pragma once

#include <cstdint>

#include <httplib.h>

namespace gsim::studio {

/// Stream of one request that reads the body to its end before any response. A browser reads the response
/// only once it has sent all, and a connection that is closed with unread bytes loses its response.
class BufferedBodyStream final : public httplib::Stream {
  public:
    explicit BufferedBodyStream(httplib::Stream& stream) : stream_(stream) {}

    /// Sets the size of the body, once the head has been read.
    void expect_body(std::uint64_t bytes) { remaining_ = bytes; }

    bool is_readable() const override { return stream_.is_readable(); }
    bool is_writable() const override { return stream_.is_writable(); }
    ssize_t read(char* bytes, std::size_t size) override;
    ssize_t write(const char* bytes, std::size_t size) override;
    void get_remote_ip_and_port(std::string& ip, int& port) const override {
        stream_.get_remote_ip_and_port(ip, port);
    }
    void get_local_ip_and_port(std::string& ip, int& port) const override {
        stream_.get_local_ip_and_port(ip, port);
    }
    socket_t socket() const override { return stream_.socket(); }

  private:
    httplib::Stream& stream_;
    std::uint64_t remaining_ = 0;  // of the body; also 0 if it has ended too soon
};

}  // namespace gsim::studio
