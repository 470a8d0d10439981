#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/number.h"

namespace gsim::simulation {

/// Text for gnuplot, line by line.
class GnuplotScript {
  public:
    template <typename... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        text::append_format(text_, format, std::forward<Args>(args)...);
        text_ += '\n';
    }

    /// Begins a named block of data; the rows follow by point(), with gap() between polylines.
    void begin_data(std::string_view name) { line("${} << EOD", name); }
    void point(double x, double y) { line("{:.7g} {:.7g}", text::unsigned_zero(x), text::unsigned_zero(y)); }
    void gap() { text_ += '\n'; }
    void end_data() { line("EOD"); }

    std::string release() { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace gsim::simulation
