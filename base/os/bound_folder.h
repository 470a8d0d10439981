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

#include "base/os/descriptor.h"

namespace gsim::os {

/// Which content of a file it is: another one where the file has been written meanwhile. A text without
/// meaning, which is shown to others and comes back.
using ContentTag = std::string;

/// A file below a folder.
struct FoundFile {
    std::string name;  ///< From the folder: "cell/table.toml".
    std::uint64_t bytes = 0;
    ContentTag tag;
};

/// Why a file of a folder is not read or written.
struct FolderFault {
    enum class Kind : std::uint8_t {
        name,      ///< It is no name of a file that lies below the folder.
        absent,    ///< There is no such file.
        conflict,  ///< The file is another one than the one that was meant.
        no_space,  ///< The disk, or a quota, is full.
        other,
    };
    Kind kind = Kind::other;
    std::string sentence;
    ContentTag tag = {};  ///< Of a conflict: of the file that is there; empty: none.
};

/// The regular files below a folder, hidden ones left out, and nothing else: names are walked one by one, and
/// no link on the way is followed, wherever it leads. So it may be asked for names that somebody else has
/// made. Copies are one.
class BoundFolder {
  public:
    /// The error is a sentence that names the folder.
    static tl::expected<BoundFolder, std::string> open(const std::filesystem::path& folder);

    /// Up to `most` files of up to `most` folders, by name. Where there are more, or folders deeper than 32,
    /// `cut` is set: those of upper folders are there, and of one folder the first ones.
    std::vector<FoundFile> list(std::size_t most, bool& cut) const;
    /// The bytes of a file of up to `max_bytes`.
    tl::expected<std::string, FolderFault> read(const std::string& name, std::size_t max_bytes,
                                                ContentTag* tag = nullptr) const;
    /// Of the file as it is now; nothing where there is none.
    std::optional<ContentTag> tag_of(const std::string& name) const;

    /// Writes the whole file and gives its tag: at every instant the name means the old content or the new
    /// one, on the disk, too. `before` is the content that is replaced; empty: the file must be a new one,
    /// for which missing folders are made. Where it is another one by now (another program has saved it)
    /// that one stays: a conflict. `fill` is given what writes a piece, until false, and tells whether all
    /// was there to write.
    using WritePiece = std::function<bool(std::string_view)>;
    tl::expected<ContentTag, FolderFault> write(const std::string& name, const ContentTag& before,
                                                const std::function<bool(const WritePiece&)>& fill) const;

    /// The folder's own name, wherever links lead.
    const std::filesystem::path& path() const { return *path_; }

  private:
    BoundFolder(std::shared_ptr<const Descriptor> root, std::shared_ptr<const std::filesystem::path> path)
        : root_(std::move(root)), path_(std::move(path)) {}

    std::shared_ptr<const Descriptor> root_;
    std::shared_ptr<const std::filesystem::path> path_;
};

}  // namespace gsim::os
