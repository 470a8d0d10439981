#include "cli/out_of_memory.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <new>

#include <sys/uio.h>
#include <unistd.h>

#include "base/os/temporary_name.h"
#include "cli/exit_status.h"

namespace gsim::apps {

namespace {

iovec piece(const char* text) {
    return {const_cast<char*>(text), std::strlen(text)};
}

// Allocates no memory. A failure to write the message could not be reported.
void end_without_memory() {
    os::remove_temporaries();
    const std::array sentence{piece(::program_invocation_short_name), piece(": out of memory\n")};
    static_cast<void>(!::writev(STDERR_FILENO, sentence.data(), static_cast<int>(sentence.size())));
    ::_exit(kUsage);
}

}  // namespace

void end_where_memory_lacks() {
    std::set_new_handler(end_without_memory);
}

}  // namespace gsim::apps
