#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>

#include "base/os/descriptor.h"

namespace gsim::os {

/// Identity of a file, by whatever name. Equal files have equal identities. So have two files that had one
/// name when they were queried in turn: a file that another program put in place in between counts as the
/// same. A replaced file keeps its number as long as an identity of it lives; another file may get it only
/// then.
struct FileIdentity {
    dev_t device = 0;
    ino_t inode = 0;
    std::string name;  ///< For a file that does not exist yet; device and inode are those of its folder.
    std::shared_ptr<const Descriptor> inode_handle = nullptr;  ///< Handle that keeps the number.
    std::filesystem::path resolved_path = {};  ///< Absolute path without links; empty if not known.

    bool operator==(const FileIdentity& other) const {
        const bool same_file = device == other.device && inode == other.inode && name == other.name;
        return same_file || (!resolved_path.empty() && resolved_path == other.resolved_path);
    }
};

/// Returns the identity of a regular file, or of a file that does not exist yet in a folder that does.
/// Returns none for anything else, because a device or a pipe may have two names.
std::optional<FileIdentity> file_identity(const std::filesystem::path& path);

/// Returns the identity of the regular file that is open as this descriptor.
std::optional<FileIdentity> open_file_identity(int descriptor);

}  // namespace gsim::os
