#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace gsim::path {

/// Result of a key or value that was read; the error is a message without a source location.
using ReadResult = tl::expected<void, std::string>;

/// Returns the error of a value of the wrong kind. `expected` is such as "'name' must be a string".
inline tl::unexpected<std::string> type_error(std::string_view expected, std::string_view found) {
    return tl::unexpected(fmt::format("{}, not {}", expected, found));
}

/// Returns the error of a key that an object has twice.
inline tl::unexpected<std::string> duplicate_key(std::string_view name) {
    return tl::unexpected(fmt::format("'{}' is given twice", name));
}

}  // namespace gsim::path
