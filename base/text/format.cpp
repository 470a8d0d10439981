#include "base/text/format.h"

#include <iterator>

namespace gsim::text {

void append_formatted(std::string& out, fmt::string_view format, fmt::format_args values) {
    fmt::vformat_to(std::back_inserter(out), format, values);
}

void append_formatted(fmt::memory_buffer& out, fmt::string_view format, fmt::format_args values) {
    fmt::vformat_to(fmt::appender(out), format, values);
}

}  // namespace gsim::text
