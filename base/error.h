#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace gsim {

/// The reason why an operation has no result, or why an input is rejected.
struct Error {
    // A message alone is an error, so both conversions are implicit.
    Error(std::string text) : message(std::move(text)) {}
    Error(const char* text) : message(text) {}
    Error(std::string text, std::uint32_t error_line, std::uint32_t error_column)
        : message(std::move(text)), line(error_line), column(error_column) {}

    bool operator==(const Error&) const = default;

    std::string message;       ///< Text for users, without its full stop.
    std::uint32_t line = 0;    ///< Line in the input, from 1; 0: not known, or part of the message.
    std::uint32_t column = 0;  ///< Column in that line, from 1; 0 as above.
};

/// A value or an error. Functions that only search for an error return std::optional<Error>.
template <typename Value>
using Result = tl::expected<Value, Error>;

/// Ends a function that returns a Result: `return Unexpected("there is no tool");`.
using Unexpected = tl::unexpected<Error>;

}  // namespace gsim
