#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace gsim::apps {

/// Compressor of bytes as they come, in the gzip format (RFC 1952), without a time stamp. Throws
/// std::bad_alloc.
class Gzip {
  public:
    Gzip();
    ~Gzip();
    Gzip(const Gzip&) = delete;
    Gzip& operator=(const Gzip&) = delete;

    /// Appends available output to `compressed`.
    void add(std::string_view bytes, std::string& compressed);
    /// Appends the remainder.
    void end(std::string& compressed);

  private:
    struct State;
    void run(int flush, std::string& compressed);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::apps
