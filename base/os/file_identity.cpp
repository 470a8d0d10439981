#include "base/os/file_identity.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

namespace gsim::os {

namespace {

// Flags of a descriptor that reads and writes nothing, for which a file needs no permission.
#ifdef O_PATH
constexpr int kHold = O_PATH | O_CLOEXEC;
#else
constexpr int kHold = O_RDONLY | O_NONBLOCK | O_CLOEXEC;
#endif

struct Held {
    struct stat status {};
    std::shared_ptr<const Descriptor> descriptor;
};

// Returns nothing if no such file exists; errno gives the reason.
std::optional<Held> hold(const std::filesystem::path& path) {
    Held held;
    held.descriptor = std::make_shared<const Descriptor>(::open(path.c_str(), kHold));
    if (held.descriptor->number() < 0 || ::fstat(held.descriptor->number(), &held.status) != 0)
        return std::nullopt;
    return held;
}

// Returns an empty path if it is unknown.
std::filesystem::path place_of(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
    return error ? std::filesystem::path() : place;
}

}  // namespace

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
    const bool may_be_new = path.has_filename();
    if (auto held = hold(path)) {
        if (!S_ISREG(held->status.st_mode)) return std::nullopt;
        return FileIdentity{
            held->status.st_dev, held->status.st_ino, {}, std::move(held->descriptor), place_of(path)};
    }
    if (errno != ENOENT || !may_be_new) return std::nullopt;
    auto folder = hold(path.has_parent_path() ? path.parent_path() : ".");
    if (!folder) return std::nullopt;
    return FileIdentity{folder->status.st_dev, folder->status.st_ino, path.filename().string(),
                        std::move(folder->descriptor), place_of(path)};
}

std::optional<FileIdentity> identity_of_open(int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return std::nullopt;
    if (!S_ISREG(status.st_mode)) return std::nullopt;
    return FileIdentity{status.st_dev, status.st_ino, {}};
}

}  // namespace gsim::os
