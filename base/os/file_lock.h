#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "base/os/descriptor.h"
#include "base/os/temporary_name.h"

namespace gsim::os {

/// The right to change a file: of all that ask for it by this class one at a time has it, until the object
/// goes or the process ends. The lock is on a file beside it, .NAME.lock, as the file itself is replaced by
/// each change; it goes with the lock, and one that a killed process has left behind holds nobody up.
class FileLock {
  public:
    /// Waits that long for it. What is no regular file needs no lock and gets an empty one. The error is a
    /// sentence that names the file.
    static tl::expected<FileLock, std::string> get(const std::filesystem::path& file,
                                                   std::chrono::milliseconds longest_wait);

    FileLock(FileLock&&) noexcept = default;
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock() = default;

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}
    static tl::expected<FileLock, int> try_once(const std::filesystem::path& lock);

    Descriptor descriptor_;
    TemporaryName name_;  // goes first, while nobody else can have the lock
};

}  // namespace gsim::os
