#include "base/os/standard_streams.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace gsim::os {

void reserve_standard_streams() {
    for (const int stream : std::array{STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        // The lowest free number is this one. The file is opened in the opposite direction, so that reading
        // from input fails, too.
        static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    }
}

}  // namespace gsim::os
