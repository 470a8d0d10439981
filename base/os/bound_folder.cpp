#include "base/os/bound_folder.h"

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

#include "base/os/bound_name.h"

namespace gsim::os {

namespace fs = std::filesystem;

namespace {

using Kind = FolderFault::Kind;

constexpr int kDeepest = 32;
constexpr int kMaxTemporaryNames = 1000;  // names of temporary files
constexpr std::size_t kPiece = std::size_t{1} << 20U;

std::string sentence_of(int error) {
    return std::generic_category().message(error);
}

tl::unexpected<FolderFault> fault(Kind kind, std::string sentence, ContentTag tag = {}) {
    return tl::unexpected(FolderFault{kind, std::move(sentence), std::move(tag)});
}

/// Returns the error of an operation on the file `name`; `what` is its verb ("written").
tl::unexpected<FolderFault> fault_of(int error, const char* what, const std::string& name) {
    if (error == ELOOP || error == ENOTDIR)
        return fault(Kind::name,
                     fmt::format("'{}' is a link, or leads over one: links are not followed", name));
    const bool is_absent = error == ENOENT;
    const bool is_full = error == ENOSPC || error == EDQUOT || error == EFBIG;
    const Kind kind = is_absent ? Kind::absent : is_full ? Kind::no_space : Kind::other;
    return fault(kind, fmt::format("'{}' cannot be {}: {}", name, what, sentence_of(error)));
}

ContentTag tag_of_status(const struct stat& status) {
    return fmt::format("{:x}-{:x}-{:x}{:09d}", status.st_ino, status.st_size, status.st_mtim.tv_sec,
                       status.st_mtim.tv_nsec);
}

/// Returns a folder along the path, or errno.
tl::expected<Descriptor, int> open_folder(int above, const char* name) {
    Descriptor folder(::openat(above, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (folder.number() < 0) return tl::unexpected(errno);
    return folder;
}

enum class Missing { refuse, make };

/// The folder that contains the last part of the name, and that part.
struct Place {
    Descriptor folder;
    std::string file;
};

tl::expected<Place, FolderFault> place_of(int root, const std::string& name, Missing missing,
                                          const char* what) {
    auto parts = parts_of_bound_name(name);
    if (!parts) return fault(Kind::name, parts.error());
    std::optional<Descriptor> folder;
    for (std::size_t i = 0; i < parts->size(); ++i) {
        const int above = folder ? folder->number() : root;
        const char* const part = i == 0 ? "." : (*parts)[i - 1].c_str();
        if (missing == Missing::make && i > 0) ::mkdirat(above, part, 0777);  // if it does not exist
        auto next = open_folder(above, part);
        if (!next) return fault_of(next.error(), what, name);
        folder.emplace(*std::move(next));
    }
    return Place{*std::move(folder), std::move(parts->back())};
}

/// Returns a regular file, or errno. Does not block on a pipe of that name.
tl::expected<Descriptor, int> open_regular(const Place& place, struct stat& status) {
    Descriptor file(
        ::openat(place.folder.number(), place.file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file.number() < 0) return tl::unexpected(errno);
    if (::fstat(file.number(), &status) != 0) return tl::unexpected(errno);
    if (!S_ISREG(status.st_mode)) return tl::unexpected(S_ISDIR(status.st_mode) ? EISDIR : EINVAL);
    return file;
}

bool write_all(int file, std::string_view piece) {
    while (!piece.empty()) {
        const ssize_t written = ::write(file, piece.data(), piece.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        piece.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// A temporary file next to the file that is written. It is removed unless it gets the final name.
class FileBeside {
  public:
    static tl::expected<FileBeside, int> make(int folder, const std::string& file) {
        for (int i = 0; i < kMaxTemporaryNames; ++i) {
            std::string name = fmt::format(".{}.{}-{}.tmp", file.substr(0, 200), ::getpid(), i);
            Descriptor made(
                ::openat(folder, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
            if (made.number() >= 0) return FileBeside(folder, std::move(name), std::move(made));
            if (errno != EEXIST) return tl::unexpected(errno);
        }
        return tl::unexpected(EEXIST);
    }
    FileBeside(FileBeside&& other) noexcept
        : folder_(other.folder_), name_(std::exchange(other.name_, {})), file_(std::move(other.file_)) {}
    FileBeside& operator=(FileBeside&&) = delete;
    ~FileBeside() {
        if (!name_.empty()) ::unlinkat(folder_, name_.c_str(), 0);
    }

    int number() const { return file_.number(); }
    const std::string& name() const { return name_; }
    /// Keeps the file, which has its final name.
    void release() { name_.clear(); }

  private:
    FileBeside(int folder, std::string name, Descriptor file)
        : folder_(folder), name_(std::move(name)), file_(std::move(file)) {}

    int folder_;
    std::string name_;
    Descriptor file_;
};

std::optional<ContentTag> tag_at(const Place& place) {
    struct stat status {};
    if (!open_regular(place, status)) return std::nullopt;
    return tag_of_status(status);
}

tl::unexpected<FolderFault> conflict(const Place& place, const std::string& name) {
    const auto there = tag_at(place);
    return fault(Kind::conflict,
                 there ? fmt::format("'{}' has been changed by another program", name)
                       : fmt::format("'{}' has been removed by another program", name),
                 there.value_or(""));
}

/// Gives the new file its name. `error` is that of renaming it to a name that must not exist; if the file
/// system cannot do that, a link is made.
tl::expected<void, FolderFault> take_new_name(const Place& place, FileBeside& beside, const std::string& name,
                                              int error) {
    const int folder = place.folder.number();
    if (error == EINVAL || error == ENOSYS)
        error = ::linkat(folder, beside.name().c_str(), folder, place.file.c_str(), 0) == 0 ? -1 : errno;
    if (error == EEXIST) return conflict(place, name);
    if (error > 0) return fault_of(error, "written", name);
    if (error == 0) beside.release();  // a link leaves the temporary name to be removed
    return {};
}

/// Gives the new file the name, if the existing file is the expected one. Content that another program wrote
/// at the last instant is put back.
tl::expected<void, FolderFault> replace(const Place& place, FileBeside& beside, const std::string& name,
                                        const ContentTag& before) {
    const int folder = place.folder.number();
    const auto rename_with = [&](unsigned flags) {
        if (::renameat2(folder, beside.name().c_str(), folder, place.file.c_str(), flags) == 0) return 0;
        return errno;
    };
    if (before.empty()) return take_new_name(place, beside, name, rename_with(RENAME_NOREPLACE));
    const auto exchange = [&] { return rename_with(RENAME_EXCHANGE); };
    if (const int error = exchange(); error != 0) {
        if (error == ENOENT) return conflict(place, name);
        // A network file system may not support the exchange; a change in between is lost there.
        if (error != EINVAL && error != ENOSYS) return fault_of(error, "written", name);
        if (tag_at(place) != before) return conflict(place, name);
        if (const int plain = rename_with(0); plain != 0) return fault_of(plain, "written", name);
        beside.release();
        return {};
    }
    struct stat replaced {};
    const bool is_meant = ::fstatat(folder, beside.name().c_str(), &replaced, AT_SYMLINK_NOFOLLOW) == 0 &&
                          S_ISREG(replaced.st_mode) && tag_of_status(replaced) == before;
    if (is_meant) return {};  // the temporary file is the old content now; it is removed
    if (exchange() != 0) {
        beside.release();  // its content belongs to another program
        return fault(Kind::other,
                     fmt::format("'{}' was changed meanwhile by another program, whose content is "
                                 "now in '{}'",
                                 name, beside.name()));
    }
    return conflict(place, name);
}

/// An entry of a folder, and its kind as the folder reports it: DT_REG, DT_DIR, or neither.
struct Entry {
    std::string name;
    unsigned char kind;
};

/// Returns the entries with a permitted name, sorted by name.
std::vector<Entry> entries_of(int folder) {
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
        if (may_be_file && parts_of_bound_name(entry->d_name))
            found.push_back({entry->d_name, entry->d_type});
    }
    ::closedir(entries);
    std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
    return found;
}

/// Walk through the folders below a folder, level by level, until a limit is reached.
class Walk {
  public:
    Walk(int root, std::size_t most) : root_(root), most_(most) {}

    void go() {
        std::vector<std::string> level{""};
        for (int depth = 0; !level.empty() && !is_cut_; ++depth) {
            is_cut_ = depth > kDeepest;
            deeper_.clear();
            for (auto each = level.begin(); each != level.end() && !is_cut_; ++each) look_into(*each);
            level.swap(deeper_);
        }
    }
    bool is_cut() const { return is_cut_; }
    std::vector<FoundFile> take() { return std::move(found_); }

  private:
    /// Reads one folder; `prefix` precedes the names of its entries.
    void look_into(const std::string& prefix) {
        is_cut_ = ++folders_ > most_;
        const auto place = place_of(root_, prefix + "-", Missing::refuse, "read");
        if (is_cut_ || !place) return;
        for (const Entry& entry : entries_of(place->folder.number())) {
            add(place->folder.number(), prefix, entry);
            if (is_cut_) return;
        }
    }
    void add(int folder, const std::string& prefix, const Entry& entry) {
        struct stat status {};
        if (entry.kind != DT_DIR && ::fstatat(folder, entry.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
            return;
        const std::string name = prefix + entry.name;
        if (entry.kind == DT_DIR || S_ISDIR(status.st_mode)) {
            if (deeper_.size() < most_) deeper_.push_back(name + "/");
        } else if (S_ISREG(status.st_mode)) {
            is_cut_ = found_.size() == most_;
            if (!is_cut_)
                found_.push_back({name, static_cast<std::uint64_t>(status.st_size), tag_of_status(status)});
        }
    }

    int root_;
    std::size_t most_;
    std::size_t folders_ = 0;
    bool is_cut_ = false;
    std::vector<std::string> deeper_;  // prefixes of the folders of the next depth
    std::vector<FoundFile> found_;
};

}  // namespace

tl::expected<BoundFolder, std::string> BoundFolder::open(const fs::path& folder) {
    Descriptor root(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (root.number() < 0)
        return tl::unexpected(
            fmt::format("'{}' cannot be opened as a folder: {}", folder.string(), sentence_of(errno)));
    std::error_code error;
    fs::path own = fs::canonical(folder, error);
    if (error)
        return tl::unexpected(fmt::format("'{}' cannot be found: {}", folder.string(), error.message()));
    return BoundFolder(std::make_shared<const Descriptor>(std::move(root)),
                       std::make_shared<const fs::path>(std::move(own)));
}

std::vector<FoundFile> BoundFolder::list(std::size_t most, bool& cut) const {
    Walk walk(root_->number(), most);
    walk.go();
    cut = walk.is_cut();
    std::vector<FoundFile> found = walk.take();
    std::sort(found.begin(), found.end(),
              [](const FoundFile& a, const FoundFile& b) { return a.name < b.name; });
    return found;
}

tl::expected<std::string, FolderFault> BoundFolder::read(const std::string& name, std::size_t max_bytes,
                                                         ContentTag* tag) const {
    auto place = place_of(root_->number(), name, Missing::refuse, "read");
    if (!place) return tl::unexpected(place.error());
    struct stat status {};
    const auto file = open_regular(*place, status);
    if (!file) return fault_of(file.error(), "read", name);
    std::string bytes;
    for (;;) {
        const std::size_t before = bytes.size();
        bytes.resize(before + kPiece);
        const ssize_t got = ::read(file->number(), bytes.data() + before, kPiece);
        if (got < 0 && errno != EINTR) return fault_of(errno, "read", name);
        bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        if (got == 0) break;
        if (bytes.size() > max_bytes)
            return fault(Kind::other, fmt::format("'{}' is larger than {} MiB", name, max_bytes >> 20U));
    }
    if (tag != nullptr) *tag = tag_of_status(status);
    return bytes;
}

std::optional<ContentTag> BoundFolder::tag_of(const std::string& name) const {
    const auto place = place_of(root_->number(), name, Missing::refuse, "read");
    return place ? tag_at(*place) : std::nullopt;
}

tl::expected<ContentTag, FolderFault> BoundFolder::write(
    const std::string& name, const ContentTag& before,
    const std::function<bool(const WritePiece&)>& fill) const {
    const auto place =
        place_of(root_->number(), name, before.empty() ? Missing::make : Missing::refuse, "written");
    if (!place) return tl::unexpected(place.error());
    struct stat old {};
    const auto there = open_regular(*place, old);
    if (!there && there.error() != ENOENT) return fault_of(there.error(), "written", name);
    if (there.has_value() == before.empty()) return conflict(*place, name);
    if (there && tag_of_status(old) != before) return conflict(*place, name);
    auto beside = FileBeside::make(place->folder.number(), place->file);
    if (!beside) return fault_of(beside.error(), "written", name);
    int error = 0;
    const bool whole = fill([&](std::string_view piece) {
        if (error == 0 && !write_all(beside->number(), piece)) error = errno;
        return error == 0;
    });
    if (error != 0) return fault_of(error, "written", name);
    if (!whole)
        return fault(Kind::other, fmt::format("'{}' is not written: its content ended too soon", name));
    if (!before.empty()) ::fchmod(beside->number(), old.st_mode & 07777U);
    struct stat made {};
    if (::fsync(beside->number()) != 0 || ::fstat(beside->number(), &made) != 0)
        return fault_of(errno, "written", name);
    if (auto done = replace(*place, *beside, name, before); !done) return tl::unexpected(done.error());
    ::fsync(place->folder.number());
    return tag_of_status(made);
}

}  // namespace gsim::os
