// A program that ends by _Exit loses what it counted. In builds that measure coverage this stands in for it.

#include <unistd.h>

extern "C" void __gcov_dump();

extern "C" [[noreturn]] void _Exit(int status) noexcept {
    __gcov_dump();
    ::_exit(status);
}
