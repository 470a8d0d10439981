#pragma once

#include <compare>
#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

namespace gsim::os {

/// Which file it is, by whatever name. Two files that are the same have equal ones.
struct FileIdentity {
    dev_t device = 0;
    ino_t inode = 0;
    std::string name;  ///< Of a file that is not there yet; device and inode are those of its folder.

    auto operator<=>(const FileIdentity&) const = default;
};

/// Of a regular file, or of a file that is not there yet in a folder that is. None of anything else: a device
/// or a pipe may be named twice.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

/// Of the regular file that is open as this descriptor.
std::optional<FileIdentity> identity_of_open(int descriptor);

}  // namespace gsim::os
