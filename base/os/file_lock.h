#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "base/error.h"
#include "base/os/descriptor.h"
#include "base/os/temporary_name.h"

namespace gsim::os {

/// The right to change a file. Only one of all users of this class has it at a time, until the object is
/// destroyed or the process ends. The lock is on a file next to it, .NAME.lock, because the file itself is
/// replaced by each change. It is removed with the lock. One that a killed process has left blocks nobody.
class FileLock {
  public:
    /// Waits that long for the lock. Anything but a regular file needs no lock and gets an empty one. The
    /// error is a message that names the file.
    static Result<FileLock> get(const std::filesystem::path& file, std::chrono::milliseconds max_wait);

    FileLock(FileLock&&) noexcept = default;
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock() = default;

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}
    static tl::expected<FileLock, int> try_lock(const std::filesystem::path& lock);

    Descriptor descriptor_;
    TemporaryName name_;  // destroyed first, while no one else can have the lock
};

}  // namespace gsim::os
