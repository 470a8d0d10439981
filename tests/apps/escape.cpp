// Stands for a hole in Lua: preloaded, it tries from within the first script that runs to open the files that
// are named in GSIM_ESCAPE (r:NAME to read, w:NAME to make), and tells on standard error what came of it.

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <lua.hpp>
#include <unistd.h>

namespace {

void try_to_escape() {
    const char* const asked = std::getenv("GSIM_ESCAPE");
    if (asked == nullptr) return;
    ::unsetenv("GSIM_ESCAPE");
    std::istringstream names(asked);
    for (std::string name; std::getline(names, name, ' ');) {
        const int flags = name[0] == 'r' ? O_RDONLY : O_WRONLY | O_CREAT;
        const int opened = ::open(name.c_str() + 2, flags | O_CLOEXEC, 0600);
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
