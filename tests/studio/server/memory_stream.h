#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include <httplib.h>

namespace gsim::studio {

/// Connection after the other end has sent all its data.
class MemoryStream final : public httplib::Stream {
  public:
    explicit MemoryStream(std::string sent) : sent_(std::move(sent)) {}

    const std::string& answered() const { return answered_; }

    bool is_readable() const override { return at_ < sent_.size(); }
    bool is_writable() const override { return true; }
    ssize_t read(char* bytes, std::size_t size) override {
        const std::size_t taken = std::min(size, sent_.size() - at_);
        std::copy_n(sent_.data() + at_, taken, bytes);
        at_ += taken;
        return static_cast<ssize_t>(taken);
    }
    ssize_t write(const char* bytes, std::size_t size) override {
        answered_.append(bytes, size);
        return static_cast<ssize_t>(size);
    }
    void get_remote_ip_and_port(std::string& ip, int& port) const override {
        ip = "127.0.0.1";
        port = 1;
    }
    void get_local_ip_and_port(std::string& ip, int& port) const override {
        get_remote_ip_and_port(ip, port);
    }
    socket_t socket() const override { return -1; }

  private:
    std::string sent_;
    std::size_t at_ = 0;
    std::string answered_;
};

}  // namespace gsim::studio
