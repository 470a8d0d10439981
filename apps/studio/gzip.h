#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace gsim::apps {

/// Packs bytes as they come, in the format of gzip (RFC 1952), without a time in it. Throws std::bad_alloc.
class Gzip {
  public:
    Gzip();
    ~Gzip();
    Gzip(const Gzip&) = delete;
    Gzip& operator=(const Gzip&) = delete;

    /// Appends to `packed` what is ready.
    void add(std::string_view bytes, std::string& packed);
    /// Appends the rest.
    void end(std::string& packed);

  private:
    struct State;
    void run(int flush, std::string& packed);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::apps
