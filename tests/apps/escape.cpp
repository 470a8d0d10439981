// Simulates a security hole in Lua or in a reader. When preloaded, it acts within the first script that runs,
// or when a file with GSIM_ESCAPE_AT in its name is opened. It tries to open the files that are named in
// GSIM_ESCAPE (r:NAME to read, w:NAME to create), and reports the results on standard error.

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <lua.hpp>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

void try_to_escape() {
    const char* const requested = std::getenv("GSIM_ESCAPE");
    if (requested == nullptr) return;
    ::unsetenv("GSIM_ESCAPE");
    std::istringstream names(requested);
    for (std::string name; std::getline(names, name, ' ');) {
        const int flags = name[0] == 'r' ? O_RDONLY : O_WRONLY | O_CREAT;
        const int opened =
            static_cast<int>(::syscall(SYS_openat, AT_FDCWD, name.c_str() + 2, flags | O_CLOEXEC, 0600));
        std::fprintf(stderr, "%s: %s\n", name.c_str(), opened < 0 ? std::strerror(errno) : "reached");
        if (opened >= 0) ::close(opened);
    }
}

}  // namespace

extern "C" [[gnu::visibility("default")]] int lua_resume(lua_State* state, lua_State* from, int arguments,
                                                         int* results) {
    using Resume = int (*)(lua_State*, lua_State*, int, int*);
    const auto resume = reinterpret_cast<Resume>(::dlsym(RTLD_NEXT, "lua_resume"));
    try_to_escape();
    return resume(state, from, arguments, results);
}

// Names that are only looked up (O_PATH) are what a confinement allows, in front of it.
extern "C" [[gnu::visibility("default")]] int open(const char* name, int flags, ...) {
    std::va_list more;
    va_start(more, flags);
    const mode_t mode = va_arg(more, mode_t);
    va_end(more);
    const char* const at = std::getenv("GSIM_ESCAPE_AT");
    if (at != nullptr && (flags & O_PATH) == 0 && std::strstr(name, at) != nullptr) try_to_escape();
    return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, name, flags, mode));
}

// Replacement of open() in programs that are compiled with _FORTIFY_SOURCE.
extern "C" [[gnu::visibility("default")]] int open_of_fortified(const char* name,
                                                                int flags) __asm__("__open_2");
int open_of_fortified(const char* name, int flags) {
    return open(name, flags, 0);
}
