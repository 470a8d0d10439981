#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/error.h"
#include "base/os/descriptor.h"

namespace gsim::os {

/// Identifier of a file's content, which changes if the file is written meanwhile. An opaque text that
/// clients receive and send back.
using ContentTag = std::string;

/// A file below a folder.
struct FileEntry {
    std::string name;  ///< From the folder: "cell/table.toml".
    std::uint64_t bytes = 0;
    ContentTag tag;
};

/// Reason why a file of a folder is not read or written.
struct DirectoryError : Error {
    enum class Kind : std::uint8_t {
        name,      ///< It is no name of a file that lies below the folder.
        absent,    ///< There is no such file.
        conflict,  ///< The file is another one than the one that was meant.
        no_space,  ///< The disk, or a quota, is full.
        other,
    };
    Kind kind = Kind::other;
    ContentTag tag = {};  ///< For a conflict: tag of the existing file; empty: no file.
};

/// The regular files below a folder, without hidden ones, and nothing else. Names are resolved part by part,
/// and no link along the path is followed, wherever it leads. So names from untrusted users may be used.
/// Copies share one folder.
class RootedDirectory {
  public:
    /// Opens the folder. The error is a message that names it.
    static Result<RootedDirectory> open(const std::filesystem::path& folder);

    /// Returns up to `max` files of up to `max` folders, sorted by name. Sets `cut` if more files exist, or
    /// folders deeper than 32. Then the files of upper folders are included, and of one folder the first
    /// ones.
    std::vector<FileEntry> list(std::size_t max, bool& cut) const;
    /// Returns the bytes of a file of up to `max_bytes`.
    tl::expected<std::string, DirectoryError> read(const std::string& name, std::size_t max_bytes,
                                                   ContentTag* tag = nullptr) const;
    /// Returns the tag of the file as it is now, or nothing if it does not exist.
    std::optional<ContentTag> content_tag(const std::string& name) const;

    /// Writes the full file and returns its tag. At every instant the name refers to the old content or the
    /// new one, also on the disk. `before` is the content that is replaced; if it is empty, the file must be
    /// new, and missing folders are made for it. If another program has saved the file meanwhile, its content
    /// stays: a conflict. `fill` gets a function that writes one part, to be called until it returns false.
    /// `fill` returns true if all content was available.
    using WriteChunk = std::function<bool(std::string_view)>;
    tl::expected<ContentTag, DirectoryError> write(const std::string& name, const ContentTag& before,
                                                   const std::function<bool(const WriteChunk&)>& fill) const;

    /// Returns the folder's own name, with links resolved.
    const std::filesystem::path& path() const { return *path_; }

  private:
    RootedDirectory(std::shared_ptr<const Descriptor> root, std::shared_ptr<const std::filesystem::path> path)
        : root_(std::move(root)), path_(std::move(path)) {}

    std::shared_ptr<const Descriptor> root_;
    std::shared_ptr<const std::filesystem::path> path_;
};

}  // namespace gsim::os
