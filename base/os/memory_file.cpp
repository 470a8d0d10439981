#include "base/os/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

namespace gsim::os {

FileHandle open_memory_file(const char* name) {
    const int descriptor = ::memfd_create(name, MFD_CLOEXEC);
    if (descriptor < 0) return nullptr;
    FileHandle file(::fdopen(descriptor, "w+"));
    if (!file) ::close(descriptor);
    return file;
}

}  // namespace gsim::os
