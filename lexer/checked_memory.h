#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace gsim::lexer {

/// What std::malloc() and std::realloc() gave, for the scanner and the parser, whose generated code would end
/// the program, or take what is missing for the end of its input. Where they gave nothing, the same is done
/// as operator new does: the handler of the program is called, or std::bad_alloc thrown.
inline void* checked(void* memory) {
    if (memory != nullptr) return memory;
    if (const std::new_handler handler = std::get_new_handler(); handler != nullptr) handler();
    throw std::bad_alloc();
}

inline void* checked_malloc(std::size_t bytes) {
    return checked(std::malloc(bytes));
}

inline void* checked_realloc(void* old, std::size_t bytes) {
    return checked(std::realloc(old, bytes));
}

}  // namespace gsim::lexer
