#include "base/os/rooted_directory.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/os/safe_name.h"

namespace gsim::os {

namespace fs = std::filesystem;

namespace {

using Kind = DirectoryError::Kind;

constexpr int kMaxDepth = 32;
constexpr int kMaxTemporaryNames = 1000;  // names of temporary files
constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;

std::string system_message(int error) {
    return std::generic_category().message(error);
}

tl::unexpected<DirectoryError> make_error(Kind kind, std::string message, ContentTag tag = {}) {
    return tl::unexpected(DirectoryError{{std::move(message)}, kind, std::move(tag)});
}

/// Returns the error of an operation on the file `name`; `what` is its verb ("written").
tl::unexpected<DirectoryError> folder_error(int error, const char* what, const std::string& name) {
    if (error == ELOOP || error == ENOTDIR)
        return make_error(
            Kind::name,
            fmt::format("'{}' is a link, or its path contains one: links are not followed", name));
    const bool is_absent = error == ENOENT;
    const bool is_full = error == ENOSPC || error == EDQUOT || error == EFBIG;
    const Kind kind = is_absent ? Kind::absent : is_full ? Kind::no_space : Kind::other;
    return make_error(kind, fmt::format("'{}' cannot be {}: {}", name, what, system_message(error)));
}

ContentTag tag_from_status(const struct stat& status) {
    return fmt::format("{:x}-{:x}-{:x}{:09d}", status.st_ino, status.st_size, status.st_mtim.tv_sec,
                       status.st_mtim.tv_nsec);
}

/// Returns a folder along the path, or errno.
tl::expected<Descriptor, int> open_folder(int above, const char* name) {
    Descriptor folder(::openat(above, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (folder.number() < 0) return tl::unexpected(errno);
    return folder;
}

enum class MissingFolders { fail, make };

/// The folder that contains the last part of the name, and that part.
struct ResolvedPath {
    Descriptor folder;
    std::string file;
};

tl::expected<ResolvedPath, DirectoryError> open_parent(int root, const std::string& name,
                                                       MissingFolders missing, const char* what) {
    auto parts = safe_name_parts(name);
    if (!parts) return make_error(Kind::name, parts.error().message);
    std::optional<Descriptor> folder;
    for (std::size_t i = 0; i < parts->size(); ++i) {
        const int above = folder ? folder->number() : root;
        const char* const part = i == 0 ? "." : (*parts)[i - 1].c_str();
        if (missing == MissingFolders::make && i > 0) ::mkdirat(above, part, 0777);  // if it does not exist
        auto next = open_folder(above, part);
        if (!next) return folder_error(next.error(), what, name);
        folder.emplace(*std::move(next));
    }
    return ResolvedPath{*std::move(folder), std::move(parts->back())};
}

/// Returns a regular file, or errno. Does not block on a pipe of that name.
tl::expected<Descriptor, int> open_regular(const ResolvedPath& resolved_path, struct stat& status) {
    Descriptor file(::openat(resolved_path.folder.number(), resolved_path.file.c_str(),
                             O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file.number() < 0) return tl::unexpected(errno);
    if (::fstat(file.number(), &status) != 0) return tl::unexpected(errno);
    if (!S_ISREG(status.st_mode)) return tl::unexpected(S_ISDIR(status.st_mode) ? EISDIR : EINVAL);
    return file;
}

bool write_all(int file, std::string_view chunk) {
    while (!chunk.empty()) {
        const ssize_t written = ::write(file, chunk.data(), chunk.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        chunk.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// A temporary file next to the file that is written. It is removed unless it gets the final name.
class TemporaryFile {
  public:
    static tl::expected<TemporaryFile, int> make(int folder, const std::string& file) {
        for (int i = 0; i < kMaxTemporaryNames; ++i) {
            std::string name = fmt::format(".{}.{}-{}.tmp", file.substr(0, 200), ::getpid(), i);
            Descriptor new_file(
                ::openat(folder, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
            if (new_file.number() >= 0) return TemporaryFile(folder, std::move(name), std::move(new_file));
            if (errno != EEXIST) return tl::unexpected(errno);
        }
        return tl::unexpected(EEXIST);
    }
    TemporaryFile(TemporaryFile&& other) noexcept
        : folder_(other.folder_), name_(std::exchange(other.name_, {})), file_(std::move(other.file_)) {}
    TemporaryFile& operator=(TemporaryFile&&) = delete;
    ~TemporaryFile() {
        if (!name_.empty()) ::unlinkat(folder_, name_.c_str(), 0);
    }

    int number() const { return file_.number(); }
    const std::string& name() const { return name_; }
    /// Keeps the file, which has its final name.
    void release() { name_.clear(); }

  private:
    TemporaryFile(int folder, std::string name, Descriptor file)
        : folder_(folder), name_(std::move(name)), file_(std::move(file)) {}

    int folder_;
    std::string name_;
    Descriptor file_;
};

std::optional<ContentTag> current_tag(const ResolvedPath& resolved_path) {
    struct stat status {};
    if (!open_regular(resolved_path, status)) return std::nullopt;
    return tag_from_status(status);
}

tl::unexpected<DirectoryError> conflict(const ResolvedPath& resolved_path, const std::string& name) {
    const auto existing_tag = current_tag(resolved_path);
    return make_error(Kind::conflict,
                      existing_tag ? fmt::format("'{}' has been changed by another program", name)
                                   : fmt::format("'{}' has been removed by another program", name),
                      existing_tag.value_or(""));
}

/// Gives the new file its name. `error` is that of renaming it to a name that must not exist; if the file
/// system cannot do that, a link is made.
tl::expected<void, DirectoryError> claim_new_name(const ResolvedPath& resolved_path,
                                                  TemporaryFile& temporary_file, const std::string& name,
                                                  int error) {
    const int folder = resolved_path.folder.number();
    if (error == EINVAL || error == ENOSYS)
        error = ::linkat(folder, temporary_file.name().c_str(), folder, resolved_path.file.c_str(), 0) == 0
                    ? -1
                    : errno;
    if (error == EEXIST) return conflict(resolved_path, name);
    if (error > 0) return folder_error(error, "written", name);
    if (error == 0) temporary_file.release();  // a link leaves the temporary name to be removed
    return {};
}

/// Gives the new file the name, if the existing file is the expected one. Content that another program wrote
/// at the last instant is put back.
tl::expected<void, DirectoryError> replace(const ResolvedPath& resolved_path, TemporaryFile& temporary_file,
                                           const std::string& name, const ContentTag& before) {
    const int folder = resolved_path.folder.number();
    const auto rename_with = [&](unsigned flags) {
        if (::renameat2(folder, temporary_file.name().c_str(), folder, resolved_path.file.c_str(), flags) ==
            0)
            return 0;
        return errno;
    };
    if (before.empty())
        return claim_new_name(resolved_path, temporary_file, name, rename_with(RENAME_NOREPLACE));
    const auto exchange = [&] { return rename_with(RENAME_EXCHANGE); };
    if (const int error = exchange(); error != 0) {
        if (error == ENOENT) return conflict(resolved_path, name);
        // A network file system may not support the exchange; a change in between is lost there.
        if (error != EINVAL && error != ENOSYS) return folder_error(error, "written", name);
        if (current_tag(resolved_path) != before) return conflict(resolved_path, name);
        if (const int plain = rename_with(0); plain != 0) return folder_error(plain, "written", name);
        temporary_file.release();
        return {};
    }
    struct stat replaced {};
    const bool is_expected =
        ::fstatat(folder, temporary_file.name().c_str(), &replaced, AT_SYMLINK_NOFOLLOW) == 0 &&
        S_ISREG(replaced.st_mode) && tag_from_status(replaced) == before;
    if (is_expected) return {};  // the temporary file is the old content now; it is removed
    if (exchange() != 0) {
        temporary_file.release();  // its content belongs to another program
        return make_error(Kind::other, fmt::format("'{}' was changed by another program in the meantime; the "
                                                   "content of that program is now in '{}'",
                                                   name, temporary_file.name()));
    }
    return conflict(resolved_path, name);
}

/// An entry of a folder, and its kind as the folder reports it: DT_REG, DT_DIR, or neither.
struct Entry {
    std::string name;
    unsigned char kind;
};

/// Returns the entries with a permitted name, sorted by name.
std::vector<Entry> list_entries(int folder) {
    std::vector<Entry> found;
    const int copy = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* const entries = copy < 0 ? nullptr : ::fdopendir(copy);
    if (entries == nullptr) {
        if (copy >= 0) ::close(copy);
        return found;
    }
    while (const dirent* entry = ::readdir(entries)) {
        const bool may_be_file =
            entry->d_type == DT_REG || entry->d_type == DT_DIR || entry->d_type == DT_UNKNOWN;
        if (may_be_file && safe_name_parts(entry->d_name)) found.push_back({entry->d_name, entry->d_type});
    }
    ::closedir(entries);
    std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
    return found;
}

/// Walk through the folders below a folder, level by level, until a limit is reached.
class DirectoryWalk {
  public:
    DirectoryWalk(int root, std::size_t max) : root_(root), max_files_(max) {}

    void scan() {
        std::vector<std::string> level{""};
        for (int depth = 0; !level.empty() && !is_truncated_; ++depth) {
            is_truncated_ = depth > kMaxDepth;
            next_level_.clear();
            for (auto each = level.begin(); each != level.end() && !is_truncated_; ++each) scan_folder(*each);
            level.swap(next_level_);
        }
    }
    bool is_truncated() const { return is_truncated_; }
    std::vector<FileEntry> release_files() { return std::move(found_); }

  private:
    /// Reads one folder; `prefix` precedes the names of its entries.
    void scan_folder(const std::string& prefix) {
        is_truncated_ = ++folders_ > max_files_;
        const auto resolved_path = open_parent(root_, prefix + "-", MissingFolders::fail, "read");
        if (is_truncated_ || !resolved_path) return;
        for (const Entry& entry : list_entries(resolved_path->folder.number())) {
            add(resolved_path->folder.number(), prefix, entry);
            if (is_truncated_) return;
        }
    }
    void add(int folder, const std::string& prefix, const Entry& entry) {
        struct stat status {};
        if (entry.kind != DT_DIR && ::fstatat(folder, entry.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
            return;
        const std::string name = prefix + entry.name;
        if (entry.kind == DT_DIR || S_ISDIR(status.st_mode)) {
            if (next_level_.size() < max_files_) next_level_.push_back(name + "/");
        } else if (S_ISREG(status.st_mode)) {
            is_truncated_ = found_.size() == max_files_;
            if (!is_truncated_)
                found_.push_back({name, static_cast<std::uint64_t>(status.st_size), tag_from_status(status)});
        }
    }

    int root_;
    std::size_t max_files_;
    std::size_t folders_ = 0;
    bool is_truncated_ = false;
    std::vector<std::string> next_level_;  // prefixes of the folders of the next depth
    std::vector<FileEntry> found_;
};

}  // namespace

Result<RootedDirectory> RootedDirectory::open(const fs::path& folder) {
    Descriptor root(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (root.number() < 0)
        return Unexpected(
            fmt::format("'{}' cannot be opened as a folder: {}", folder.string(), system_message(errno)));
    std::error_code error;
    fs::path canonical_path = fs::canonical(folder, error);
    if (error) return Unexpected(fmt::format("'{}' cannot be found: {}", folder.string(), error.message()));
    return RootedDirectory(std::make_shared<const Descriptor>(std::move(root)),
                           std::make_shared<const fs::path>(std::move(canonical_path)));
}

std::vector<FileEntry> RootedDirectory::list(std::size_t max, bool& cut) const {
    DirectoryWalk walk(root_->number(), max);
    walk.scan();
    cut = walk.is_truncated();
    std::vector<FileEntry> found = walk.release_files();
    std::sort(found.begin(), found.end(),
              [](const FileEntry& a, const FileEntry& b) { return a.name < b.name; });
    return found;
}

tl::expected<std::string, DirectoryError> RootedDirectory::read(const std::string& name,
                                                                std::size_t max_bytes,
                                                                ContentTag* tag) const {
    auto resolved_path = open_parent(root_->number(), name, MissingFolders::fail, "read");
    if (!resolved_path) return tl::unexpected(resolved_path.error());
    struct stat status {};
    const auto file = open_regular(*resolved_path, status);
    if (!file) return folder_error(file.error(), "read", name);
    std::string bytes;
    for (;;) {
        const std::size_t before = bytes.size();
        bytes.resize(before + kChunkBytes);
        const ssize_t bytes_read = ::read(file->number(), bytes.data() + before, kChunkBytes);
        if (bytes_read < 0 && errno != EINTR) return folder_error(errno, "read", name);
        bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(bytes_read, 0)));
        if (bytes_read == 0) break;
        if (bytes.size() > max_bytes)
            return make_error(Kind::other, fmt::format("'{}' is larger than {} MiB", name, max_bytes >> 20U));
    }
    if (tag != nullptr) *tag = tag_from_status(status);
    return bytes;
}

std::optional<ContentTag> RootedDirectory::content_tag(const std::string& name) const {
    const auto resolved_path = open_parent(root_->number(), name, MissingFolders::fail, "read");
    return resolved_path ? current_tag(*resolved_path) : std::nullopt;
}

tl::expected<ContentTag, DirectoryError> RootedDirectory::write(
    const std::string& name, const ContentTag& before,
    const std::function<bool(const WriteChunk&)>& fill) const {
    const auto resolved_path = open_parent(
        root_->number(), name, before.empty() ? MissingFolders::make : MissingFolders::fail, "written");
    if (!resolved_path) return tl::unexpected(resolved_path.error());
    struct stat old {};
    const auto existing_tag = open_regular(*resolved_path, old);
    if (!existing_tag && existing_tag.error() != ENOENT)
        return folder_error(existing_tag.error(), "written", name);
    if (existing_tag.has_value() == before.empty()) return conflict(*resolved_path, name);
    if (existing_tag && tag_from_status(old) != before) return conflict(*resolved_path, name);
    auto temporary_file = TemporaryFile::make(resolved_path->folder.number(), resolved_path->file);
    if (!temporary_file) return folder_error(temporary_file.error(), "written", name);
    int error = 0;
    const bool is_complete = fill([&](std::string_view chunk) {
        if (error == 0 && !write_all(temporary_file->number(), chunk)) error = errno;
        return error == 0;
    });
    if (error != 0) return folder_error(error, "written", name);
    if (!is_complete)
        return make_error(Kind::other, fmt::format("'{}' was not written: its content is incomplete", name));
    if (!before.empty()) ::fchmod(temporary_file->number(), old.st_mode & 07777U);
    struct stat new_file {};
    if (::fsync(temporary_file->number()) != 0 || ::fstat(temporary_file->number(), &new_file) != 0)
        return folder_error(errno, "written", name);
    if (auto done = replace(*resolved_path, *temporary_file, name, before); !done)
        return tl::unexpected(done.error());
    ::fsync(resolved_path->folder.number());
    return tag_from_status(new_file);
}

}  // namespace gsim::os
