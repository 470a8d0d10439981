#include "base/os/file_lock.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include "base/os/output_file.h"

namespace gsim::os {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause(5);

bool needs_lock(const fs::path& file) {
    std::error_code ignored;
    return file != kStandardStream && (!fs::exists(file, ignored) || fs::is_regular_file(file, ignored));
}

fs::path lock_name(const fs::path& file) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(fs::absolute(file), error);
    const fs::path& found = error ? file : target;
    return found.parent_path() / fmt::format(".{}.lock", found.filename().string());
}

// A lock of another user may be readable only, which is enough except on some network file systems.
int open_lock(const fs::path& lock) {
    constexpr int kFlags = O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    const int descriptor = ::open(lock.c_str(), O_RDWR | kFlags, 0666);
    return descriptor < 0 && errno == EACCES ? ::open(lock.c_str(), O_RDONLY | kFlags, 0666) : descriptor;
}

// Returns errno, or 0 if the file is still the lock. Its owner removes the file before others get the lock.
// Their lock then has no name, and is not the lock (EWOULDBLOCK).
int verify_lock_name(int descriptor, const fs::path& lock) {
    struct stat open {};
    struct stat file_status {};
    if (::fstat(descriptor, &open) != 0) return errno;
    if (::lstat(lock.c_str(), &file_status) != 0) return errno == ENOENT ? EWOULDBLOCK : errno;
    return open.st_dev == file_status.st_dev && open.st_ino == file_status.st_ino ? 0 : EWOULDBLOCK;
}

}  // namespace

// Returns the error of errno; EWOULDBLOCK: another one has the lock.
tl::expected<FileLock, int> FileLock::try_lock(const fs::path& path) {
    const SignalBlocker blocked_signals;
    auto temporary_path = TemporaryName::temporary_path(path);
    FileLock lock(open_lock(path));
    const int descriptor = lock.descriptor_.number();
    if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return tl::unexpected(errno);
    if (const int error = verify_lock_name(descriptor, path); error != 0) return tl::unexpected(error);
    lock.name_.adopt(TemporaryName(std::move(temporary_path)));
    return lock;
}

Result<FileLock> FileLock::get(const fs::path& file, std::chrono::milliseconds max_wait) {
    if (!needs_lock(file)) return FileLock(-1);
    const fs::path path = lock_name(file);
    const Clock::time_point end = Clock::now() + max_wait;
    while (true) {
        auto lock = try_lock(path);
        if (lock) return *std::move(lock);
        if (lock.error() != EWOULDBLOCK && lock.error() != EINTR) {
            return Unexpected(fmt::format("cannot write '{}': {}", file.string(),
                                          std::generic_category().message(lock.error())));
        }
        if (Clock::now() >= end) break;
        std::this_thread::sleep_for(kPause);
    }
    return Unexpected(
        fmt::format("cannot change '{}': another program is changing it, and has not finished within {:.6g} "
                    "s (its lock is '{}')",
                    file.string(), std::chrono::duration<double>(max_wait).count(), path.string()));
}

}  // namespace gsim::os
