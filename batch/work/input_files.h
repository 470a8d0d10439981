#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

namespace gsim::batch {

/// State of a file that the system provides without reading the file.
struct FileState {
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t modified_ns = 0;

    bool operator==(const FileState&) const = default;
};

/// Returns the state of a regular file; empty if none exists.
std::optional<FileState> file_state(const std::string& name);

/// Cache of file contents and hashes, valid as long as the files do not change, so that input of many runs is
/// read once.
class InputFiles {
  public:
    struct Content {
        std::string bytes;
        std::string sha256;
    };

    /// Returns null if no such regular file exists, or it cannot be read.
    std::shared_ptr<const Content> get(const std::string& name);
    /// Returns the hash of a file without keeping its content; empty if no such file exists.
    std::string file_hash(const std::string& name);

  private:
    struct CacheEntry {
        FileState state;
        std::string sha256;
        std::shared_ptr<const Content> content;     ///< Null: the hash alone.
        std::list<std::string>::iterator position;  ///< Position in order of use, if content exists.
    };

    void store(const std::string& name, CacheEntry entry);
    void evict_oldest();

    std::unordered_map<std::string, CacheEntry> files_;
    std::list<std::string> names_by_last_use_;  ///< Names of contents, the one that was used last in front.
    std::size_t bytes_ = 0;
};

}  // namespace gsim::batch
