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

iovec to_iovec(const char* text) {
    return {const_cast<char*>(text), std::strlen(text)};
}

// Allocates no memory. A failure to write the message could not be reported.
void exit_out_of_memory() {
    os::remove_temporaries();
    const std::array message{to_iovec(::program_invocation_short_name), to_iovec(": out of memory\n")};
    static_cast<void>(!::writev(STDERR_FILENO, message.data(), static_cast<int>(message.size())));
    ::_exit(kUsageError);
}

}  // namespace

void exit_on_out_of_memory() {
    std::set_new_handler(exit_out_of_memory);
}

}  // namespace gsim::apps
