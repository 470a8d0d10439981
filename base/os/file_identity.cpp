#include "base/os/file_identity.h"

#include <cerrno>

#include <sys/stat.h>

namespace gsim::os {

namespace {

std::optional<FileIdentity> identity_of_regular(const struct stat& status) {
    if (!S_ISREG(status.st_mode)) return std::nullopt;
    return FileIdentity{.device = status.st_dev, .inode = status.st_ino, .name = {}};
}

}  // namespace

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) return identity_of_regular(status);
    if (errno != ENOENT || !path.has_filename()) return std::nullopt;
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (::stat(folder.c_str(), &status) != 0) return std::nullopt;
    return FileIdentity{.device = status.st_dev, .inode = status.st_ino, .name = path.filename().string()};
}

std::optional<FileIdentity> identity_of_open(int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return std::nullopt;
    return identity_of_regular(status);
}

}  // namespace gsim::os
