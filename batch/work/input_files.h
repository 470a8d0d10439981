#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

namespace gsim::batch {

/// Which state of a file it is, as the system tells without reading it.
struct FileState {
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t changed_ns = 0;

    bool operator==(const FileState&) const = default;
};

/// The state of a regular file; nothing where there is none.
std::optional<FileState> state_of(const std::string& name);

/// Bytes of files and what identifies them, kept as long as the files stay as they are: what many runs read
/// is read once.
class InputFiles {
  public:
    struct Content {
        std::string bytes;
        std::string sha256;
    };

    /// Null where there is no such regular file, or it cannot be read.
    std::shared_ptr<const Content> get(const std::string& name);
    /// The same of what is not to be kept in memory: empty where there is no such file.
    std::string hash_of(const std::string& name);

  private:
    struct Kept {
        FileState state;
        std::string sha256;
        std::shared_ptr<const Content> content;  ///< Null: the hash alone.
        std::list<std::string>::iterator place;  ///< In order of use, where there is a content.
    };

    void keep(const std::string& name, Kept kept);
    void forget_oldest();

    std::unordered_map<std::string, Kept> files_;
    std::list<std::string> used_;  ///< Names of contents, the one that was used last in front.
    std::size_t bytes_ = 0;
};

}  // namespace gsim::batch
