#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>

#include "base/os/descriptor.h"

namespace gsim::os {

/// Which file it is, by whatever name. Two files that are the same have equal ones. A file that is replaced
/// meanwhile keeps its number for as long as an identity of it lives: another one may get it only then.
struct FileIdentity {
    dev_t device = 0;
    ino_t inode = 0;
    std::string name;  ///< Of a file that is not there yet; device and inode are those of its folder.
    std::shared_ptr<const Descriptor> held = nullptr;  ///< What keeps the number.

    bool operator==(const FileIdentity& other) const {
        return device == other.device && inode == other.inode && name == other.name;
    }
};

/// Of a regular file, or of a file that is not there yet in a folder that is. None of anything else: a device
/// or a pipe may be named twice.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

/// Of the regular file that is open as this descriptor.
std::optional<FileIdentity> identity_of_open(int descriptor);

}  // namespace gsim::os
