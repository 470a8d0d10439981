#pragma once

#include <cstring>
#include <type_traits>

namespace gsim {

/// Returns the bytes of a value as a value of another type of the same size, like std::bit_cast, which libc++
/// has only since version 14.
template <typename To, typename From>
To bits_as(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                  std::is_trivially_copyable_v<From>);
    To to{};
    std::memcpy(&to, &from, sizeof to);
    return to;
}

}  // namespace gsim
