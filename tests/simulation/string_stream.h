#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "runtime/simulation/text_stream.h"

namespace gsim::simulation {

/// A TextStream whose text ends up in a string.
class StringStream {
  public:
    StringStream() : file_(::open_memstream(&data_, &size_)), out_(file_) {}
    StringStream(const StringStream&) = delete;
    StringStream& operator=(const StringStream&) = delete;
    ~StringStream() {
        std::fclose(file_);
        std::free(data_);
    }

    TextStream& out() { return out_; }
    std::string text() {
        (void)out_.flush();
        return {data_, size_};
    }

  private:
    char* data_ = nullptr;
    std::size_t size_ = 0;
    std::FILE* file_;
    TextStream out_;
};

}  // namespace gsim::simulation
