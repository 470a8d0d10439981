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

struct CreatedFile {
    int descriptor = -1;  // -1: errno says why
    TemporaryName name;
};

// Creates a new file next to `path`, for writing.
CreatedFile create_temporary(const fs::path& path) {
    const SignalBlocker blocked_signals;
    for (int i = 0; i < kMaxTries; ++i) {
        fs::path name = path;
        name += fmt::format(".{}-{}.tmp", ::getpid(), i);
        auto temporary_path = TemporaryName::temporary_path(name);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0) return {descriptor, TemporaryName(std::move(temporary_path))};
        if (errno != EEXIST) break;
    }
    return {};
}

// Anything but a disk file (a pipe, a terminal) has nothing to wait for.
int sync_to_disk(int descriptor) {
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
}

// A name is on the disk when its folder is. A folder that may not be read is left to the system.
int sync_folder(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return descriptor.number() < 0 ? 0 : sync_to_disk(descriptor.number());
}

}  // namespace

Result<OutputFile> OutputFile::open(const fs::path& path, ExistingFilePolicy existing) {
    OutputFile file;
    file.existing_policy_ = existing;
    file.path_ = path;
    file.display_name_ = fmt::format("'{}'", path.string());
    if (path == kStandardStream) {
        if (auto opened = file.open_standard_output(); !opened)
            return tl::unexpected(std::move(opened.error()));
        return file;
    }
    std::error_code error;
    const bool direct = fs::exists(path, error) && !fs::is_regular_file(path, error);
    if (!direct) {
        file.path_ = fs::weakly_canonical(path, error);
        if (error) return file.write_error(error.value());
    }
    auto opened = direct ? file.open_directly() : file.open_temporary();
    if (!opened) return tl::unexpected(std::move(opened.error()));
    return file;
}

Result<void> OutputFile::check(const fs::path& path) {
    std::error_code error;
    if (path == kStandardStream || (fs::exists(path, error) && !fs::is_regular_file(path, error))) {
        if (!fs::is_directory(path, error)) return {};
    }
    return open(path).map([](const OutputFile&) {});
}

Result<void> OutputFile::open_directly() {
    stream_.reset(std::fopen(path_.c_str(), "we"));
    if (!stream_) return write_error(errno);
    return {};
}

// A separate stream is used, so that closing it reports every error and leaves standard output open.
Result<void> OutputFile::open_standard_output() {
    display_name_ = "standard output";
    const int descriptor = ::dup(STDOUT_FILENO);
    if (descriptor >= 0) stream_.reset(::fdopen(descriptor, "w"));
    if (!stream_) return write_error(errno);
    return {};
}

Result<void> OutputFile::open_temporary() {
    struct stat existing {};
    const bool exists = ::stat(path_.c_str(), &existing) == 0;
    if (!exists && errno != ENOENT) return write_error(errno);
    // A rename would replace a file that is write-protected.
    if (exists && ::access(path_.c_str(), W_OK) != 0) return write_error(errno);
    CreatedFile created = create_temporary(path_);
    if (created.descriptor < 0) return write_error(errno);
    temporary_.adopt(std::move(created.name));
    if (exists && ::fchmod(created.descriptor, existing.st_mode & 07777U) != 0) {
        const int error = errno;
        ::close(created.descriptor);
        return write_error(error);
    }
    stream_.reset(::fdopen(created.descriptor, "w"));
    if (stream_) return {};
    const int error = errno;
    ::close(created.descriptor);
    return write_error(error);
}

bool OutputFile::write(std::string_view text) {
    if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size()) error_ = errno;
    return error_ == 0;
}

// Returns the first error of all writes, as errno.
int OutputFile::close(Durability reach) {
    if (error_ == 0 && std::ferror(stream_.get()) != 0) error_ = EIO;
    if (error_ == 0 && std::fflush(stream_.get()) != 0) error_ = errno;
    if (error_ == 0 && reach == Durability::disk) error_ = sync_to_disk(::fileno(stream_.get()));
    if (std::fclose(stream_.release()) != 0 && error_ == 0) error_ = errno;
    return error_;
}

Result<void> OutputFile::prepare_commit(Durability reach) {
    if (!stream_) return {};
    if (const int error = close(reach); error != 0) return write_error(error);
    return {};
}

// Returns the error as errno.
int OutputFile::rename() const {
    const char* from = temporary_.name().c_str();
    if (existing_policy_ == ExistingFilePolicy::keep) {
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

Result<void> OutputFile::commit(Durability reach) {
    if (auto prepared = prepare_commit(reach); !prepared || temporary_.empty()) return prepared;
    if (const int error = rename(); error != 0) return write_error(error);
    temporary_.release();
    const int error = reach == Durability::disk ? sync_folder(path_) : 0;
    if (error != 0) return write_error(error);
    return {};
}

Unexpected OutputFile::write_error(int error) const {
    return Unexpected(
        fmt::format("cannot write {}: {}", display_name_, std::generic_category().message(error)));
}

Result<void> write_file(const fs::path& path, std::string_view contents, Durability reach) {
    Result<OutputFile> file = OutputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    file->write(contents);
    return file->commit(reach);
}

}  // namespace gsim::os
