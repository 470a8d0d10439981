#pragma once

#include <string>
#include <string_view>

#include "runtime/outputs/text_stream.h"

namespace gsim::simulation {

/// TextStream with its text in a string.
class StringStream {
  public:
    TextStream& out() { return out_; }
    std::string text() {
        out_.flush();
        return text_;
    }

  private:
    std::string text_;
    TextStream out_{[this](std::string_view chunk) {
        text_ += chunk;
        return true;
    }};
};

}  // namespace gsim::simulation
