#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>

#include "base/os/descriptor.h"

namespace gsim::os {

/// Which file it is, by whatever name. Two files that are the same have equal ones, as have two that had one
/// name when they were asked, one after the other: what another program has put in place of the file in
/// between is the same file to whoever names it. A file that is replaced meanwhile keeps its number for as
/// long as an identity of it lives: another one may get it only then.
struct FileIdentity {
    dev_t device = 0;
    ino_t inode = 0;
    std::string name;  ///< Of a file that is not there yet; device and inode are those of its folder.
    std::shared_ptr<const Descriptor> held = nullptr;  ///< What keeps the number.
    std::filesystem::path place = {};  ///< Absolute, without links; empty where it is not known.

    bool operator==(const FileIdentity& other) const {
        const bool one_file = device == other.device && inode == other.inode && name == other.name;
        return one_file || (!place.empty() && place == other.place);
    }
};

/// Of a regular file, or of a file that is not there yet in a folder that is. None of anything else: a device
/// or a pipe may be named twice.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

/// Of the regular file that is open as this descriptor.
std::optional<FileIdentity> identity_of_open(int descriptor);

}  // namespace gsim::os
