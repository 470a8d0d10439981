// Functions that the C library of emscripten declares but lacks: no process can be started, no memory can be
// a file, and no timer expires. Callers report this as they do if a system refuses.
#include <cerrno>
#include <csignal>
#include <ctime>

#include <spawn.h>
#include <sys/mman.h>

extern "C" {

int memfd_create(const char* /*name*/, unsigned /*flags*/) {
    errno = ENOSYS;
    return -1;
}

int posix_spawnp(pid_t* /*pid*/, const char* /*file*/, const posix_spawn_file_actions_t* /*actions*/,
                 const posix_spawnattr_t* /*attributes*/, char* const* /*arguments*/,
                 char* const* /*environment*/) {
    return ENOSYS;
}

int timer_create(clockid_t /*clock*/, struct sigevent* /*event*/, timer_t* /*timer*/) {
    errno = ENOSYS;
    return -1;
}

int timer_settime(timer_t /*timer*/, int /*flags*/, const struct itimerspec* /*value*/,
                  struct itimerspec* /*old*/) {
    errno = ENOSYS;
    return -1;
}

int timer_delete(timer_t /*timer*/) {
    errno = ENOSYS;
    return -1;
}

}  // extern "C"
