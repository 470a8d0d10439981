#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace gsim::lexer {

/// Checks the result of std::malloc() and std::realloc() for the scanner and the parser. Their generated code
/// would end the program, or treat the missing part as the end of its input. If the result is null, acts like
/// operator new: the handler of the program is called, or std::bad_alloc thrown.
inline void* check_allocation(void* memory) {
    if (memory != nullptr) return memory;
    if (const std::new_handler handler = std::get_new_handler(); handler != nullptr) handler();
    throw std::bad_alloc();
}

inline void* checked_malloc(std::size_t bytes) {
    return check_allocation(std::malloc(bytes));
}

inline void* checked_realloc(void* old, std::size_t bytes) {
    return check_allocation(std::realloc(old, bytes));
}

}  // namespace gsim::lexer
