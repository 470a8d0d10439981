// Records which lines of the library in Lua are run; for measuring coverage alone. When preloaded, it
// intercepts lua_sethook: each hook is called for lines, too, and passes on what the program requested. At
// the end of the program its lines are added to those in the file GSIM_LUA_LINES (FILE:LINE, one a line).

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <lua.hpp>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

namespace {

constexpr const char* kFolder = "=lua_lib/";

/// The lines of one process.
class Lines {
  public:
    Lines() = default;
    Lines(const Lines&) = delete;
    Lines& operator=(const Lines&) = delete;
    ~Lines() {
        const char* const name = std::getenv("GSIM_LUA_LINES");
        if (name == nullptr || run_.empty() || may_write_little()) return;
        const int locked = ::open(name, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (locked < 0) return;
        if (::flock(locked, LOCK_EX) == 0) add_to(name);
        ::close(locked);
    }

    void count(const char* source, int line) {
        if (std::strncmp(source, kFolder, std::strlen(kFolder)) != 0) return;
        const std::lock_guard lock(mutex_);
        run_[source + 1].insert(line);
    }

  private:
    /// A test of full disks: what is half written would spoil the lines of others.
    static bool may_write_little() {
        rlimit size{};
        return ::getrlimit(RLIMIT_FSIZE, &size) != 0 || size.rlim_cur != RLIM_INFINITY;
    }

    void add_to(const char* name) {
        std::ifstream before(name);
        for (std::string line; std::getline(before, line);) {
            const std::size_t colon = line.rfind(':');
            if (colon != std::string::npos)
                run_[line.substr(0, colon)].insert(std::stoi(line.substr(colon + 1)));
        }
        before.close();
        std::ofstream after(name);
        for (const auto& [file, lines] : run_) {
            for (const int line : lines) after << file << ':' << line << '\n';
        }
    }

    std::mutex mutex_;
    std::map<std::string, std::set<int>> run_;
};

Lines& lines() {
    static Lines all;
    return all;
}

/// Hook that the program requested; it has one.
lua_Hook requested = nullptr;

using SetHook = void (*)(lua_State*, lua_Hook, int, int);
using GetMask = int (*)(lua_State*);

template <class Function>
Function next_one(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

bool is_counted(lua_State* state, lua_Debug* event) {
    if (event->event != LUA_HOOKLINE) return false;
    lua_getinfo(state, "S", event);
    lines().count(event->source, event->currentline);
    return true;
}

void count_only(lua_State* state, lua_Debug* event) {
    if (!is_counted(state, event)) requested(state, event);
}

void count_and_hand_on(lua_State* state, lua_Debug* event) {
    is_counted(state, event);
    requested(state, event);
}

}  // namespace

extern "C" [[gnu::visibility("default")]] void lua_sethook(lua_State* state, lua_Hook hook, int mask,
                                                           int count) {
    static const auto set = next_one<SetHook>("lua_sethook");
    if (hook == nullptr) return set(state, hook, mask, count);
    requested = hook;
    set(state, (mask & LUA_MASKLINE) != 0 ? count_and_hand_on : count_only, mask | LUA_MASKLINE, count);
}

extern "C" [[gnu::visibility("default")]] int lua_gethookmask(lua_State* state) {
    static const auto mask = next_one<GetMask>("lua_gethookmask");
    return lua_gethook(state) == count_only ? mask(state) & ~LUA_MASKLINE : mask(state);
}
