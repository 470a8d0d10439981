#pragma once

#include <string>
#include <string_view>

#include "runtime/outputs/text_stream.h"

namespace gsim::simulation {

/// A TextStream whose text ends up in a string.
class StringStream {
  public:
    TextStream& out() { return out_; }
    std::string text() {
        out_.flush();
        return text_;
    }

  private:
    std::string text_;
    TextStream out_{[this](std::string_view piece) {
        text_ += piece;
        return true;
    }};
};

}  // namespace gsim::simulation
