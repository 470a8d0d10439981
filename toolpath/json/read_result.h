#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"

namespace gsim::path {

/// Result of a key or value that was read; the error is a message without a source location.
using ReadResult = Result<void>;

/// Returns the error of a value of the wrong kind. `expected` is such as "'name' must be a string".
inline Unexpected type_error(std::string_view expected, std::string_view found) {
    return Unexpected(fmt::format("{}, not {}", expected, found));
}

/// Returns the error of a key that an object has twice.
inline Unexpected duplicate_key(std::string_view name) {
    return Unexpected(fmt::format("'{}' is given twice", name));
}

}  // namespace gsim::path
