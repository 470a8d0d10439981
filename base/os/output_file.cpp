#include "base/os/output_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/os/descriptor.h"

namespace gsim::os {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxTries = 1000;  // names of temporary files

struct Created {
    int descriptor = -1;  // -1: errno says why
    TemporaryName name;
};

// Creates a new file next to `path`, for writing.
Created create_beside(const fs::path& path) {
    const SignalsHeld held;
    for (int i = 0; i < kMaxTries; ++i) {
        fs::path name = path;
        name += fmt::format(".{}-{}.tmp", ::getpid(), i);
        auto kept = TemporaryName::kept(name);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) return {descriptor, TemporaryName(std::move(kept))};
        if (errno != EEXIST) break;
    }
    return {};
}

// Anything but a disk file (a pipe, a terminal) has nothing to wait for.
int reach_disk(int descriptor) {
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
}

// A name is on the disk when its folder is. A folder that may not be read is left to the system.
int reach_disk_of_folder(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return descriptor.number() < 0 ? 0 : reach_disk(descriptor.number());
}

}  // namespace

tl::expected<OutputFile, std::string> OutputFile::open(const fs::path& path, Existing existing) {
    OutputFile file;
    file.existing_ = existing;
    file.path_ = path;
    file.shown_name_ = fmt::format("'{}'", path.string());
    if (path == kStandardStream) {
        if (auto opened = file.open_standard_output(); !opened)
            return tl::unexpected(std::move(opened.error()));
        return file;
    }
    std::error_code error;
    const bool direct = fs::exists(path, error) && !fs::is_regular_file(path, error);
    if (!direct) {
        file.path_ = fs::weakly_canonical(path, error);
        if (error) return file.cannot_write(error.value());
    }
    auto opened = direct ? file.open_directly() : file.open_beside();
    if (!opened) return tl::unexpected(std::move(opened.error()));
    return file;
}

tl::expected<void, std::string> OutputFile::check(const fs::path& path) {
    std::error_code error;
    if (path == kStandardStream || (fs::exists(path, error) && !fs::is_regular_file(path, error))) {
        if (!fs::is_directory(path, error)) return {};
    }
    return open(path).map([](const OutputFile&) {});
}

tl::expected<void, std::string> OutputFile::open_directly() {
    stream_.reset(std::fopen(path_.c_str(), "we"));
    if (!stream_) return cannot_write(errno);
    return {};
}

// A separate stream is used, so that closing it reports every error and leaves standard output open.
tl::expected<void, std::string> OutputFile::open_standard_output() {
    shown_name_ = "standard output";
    const int descriptor = ::dup(STDOUT_FILENO);
    if (descriptor >= 0) stream_.reset(::fdopen(descriptor, "w"));
    if (!stream_) return cannot_write(errno);
    return {};
}

tl::expected<void, std::string> OutputFile::open_beside() {
    struct stat existing {};
    const bool exists = ::stat(path_.c_str(), &existing) == 0;
    if (!exists && errno != ENOENT) return cannot_write(errno);
    // A rename would replace a file that is write-protected.
    if (exists && ::access(path_.c_str(), W_OK) != 0) return cannot_write(errno);
    Created created = create_beside(path_);
    if (created.descriptor < 0) return cannot_write(errno);
    temporary_.take(std::move(created.name));
    if (exists && ::fchmod(created.descriptor, existing.st_mode & 07777U) != 0) {
        const int error = errno;
        ::close(created.descriptor);
        return cannot_write(error);
    }
    stream_.reset(::fdopen(created.descriptor, "w"));
    if (stream_) return {};
    const int error = errno;
    ::close(created.descriptor);
    return cannot_write(error);
}

bool OutputFile::write(std::string_view text) {
    if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size()) error_ = errno;
    return error_ == 0;
}

// Returns the first error of all writes, as errno.
int OutputFile::close(Reach reach) {
    if (error_ == 0 && std::ferror(stream_.get()) != 0) error_ = EIO;
    if (error_ == 0 && std::fflush(stream_.get()) != 0) error_ = errno;
    if (error_ == 0 && reach == Reach::disk) error_ = reach_disk(::fileno(stream_.get()));
    if (std::fclose(stream_.release()) != 0 && error_ == 0) error_ = errno;
    return error_;
}

tl::expected<void, std::string> OutputFile::settle(Reach reach) {
    if (!stream_) return {};
    if (const int error = close(reach); error != 0) return cannot_write(error);
    return {};
}

// Returns the error as errno.
int OutputFile::rename() const {
    const char* from = temporary_.name().c_str();
    if (existing_ == Existing::keep) {
#ifdef RENAME_NOREPLACE  // of Linux
        if (::renameat2(AT_FDCWD, from, AT_FDCWD, path_.c_str(), RENAME_NOREPLACE) == 0) return 0;
#else
        errno = ENOSYS;
#endif
        if (errno != EINVAL && errno != ENOSYS) return errno;  // some file systems cannot
        if (::access(path_.c_str(), F_OK) == 0) return EEXIST;
    }
    return ::rename(from, path_.c_str()) == 0 ? 0 : errno;
}

tl::expected<void, std::string> OutputFile::commit(Reach reach) {
    if (auto settled = settle(reach); !settled || temporary_.empty()) return settled;
    if (const int error = rename(); error != 0) return cannot_write(error);
    temporary_.release();
    const int error = reach == Reach::disk ? reach_disk_of_folder(path_) : 0;
    if (error != 0) return cannot_write(error);
    return {};
}

tl::unexpected<std::string> OutputFile::cannot_write(int error) const {
    return tl::unexpected(
        fmt::format("cannot write {}: {}", shown_name_, std::generic_category().message(error)));
}

tl::expected<void, std::string> write_file(const fs::path& path, std::string_view contents, Reach reach) {
    tl::expected<OutputFile, std::string> file = OutputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    file->write(contents);
    return file->commit(reach);
}

}  // namespace gsim::os
