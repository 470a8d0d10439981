#pragma once

#include <utility>

#include <unistd.h>

namespace gsim::os {

/// A file descriptor that is closed when this object is destroyed.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() { close(); }

    int number() const { return number_; }
    /// Gives up the descriptor to another owner.
    void release() { number_ = -1; }
    void close() {
        if (number_ >= 0) ::close(std::exchange(number_, -1));
    }

  private:
    int number_;  // -1: closed
};

}  // namespace gsim::os
