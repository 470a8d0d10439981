#include "runtime/simulation/output_file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gsim::simulation {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxTries = 1000;  // names of temporary files

// Opens a new file beside `path` for writing; returns its descriptor and name, or -1 with errno.
int create_beside(const fs::path& path, fs::path& name) {
    for (int i = 0; i < kMaxTries; ++i) {
        name = path;
        name += fmt::format(".{}-{}.tmp", ::getpid(), i);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return descriptor;
    }
    return -1;
}

}  // namespace

tl::expected<OutputFile, std::string> OutputFile::open(const fs::path& path) {
    OutputFile file;
    file.shown_path_ = file.path_ = path;
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

OutputFile::~OutputFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

tl::expected<void, std::string> OutputFile::open_directly() {
    stream_.reset(std::fopen(path_.c_str(), "we"));
    if (!stream_) return cannot_write(errno);
    return {};
}

// A stream of its own, so that closing it tells of every error and leaves standard output open.
tl::expected<void, std::string> OutputFile::open_standard_output() {
    shown_path_ = "standard output";
    const int descriptor = ::dup(STDOUT_FILENO);
    if (descriptor >= 0) stream_.reset(::fdopen(descriptor, "w"));
    if (!stream_) return cannot_write(errno);
    return {};
}

tl::expected<void, std::string> OutputFile::open_beside() {
    struct stat existing {};
    const bool exists = ::stat(path_.c_str(), &existing) == 0;
    // A rename would replace a file that is write-protected.
    if (exists && ::access(path_.c_str(), W_OK) != 0) return cannot_write(errno);
    fs::path name;
    const int descriptor = create_beside(path_, name);
    if (descriptor < 0) return cannot_write(errno);
    temporary_ = name;
    if (exists && ::fchmod(descriptor, existing.st_mode & 07777U) != 0) {
        const int error = errno;
        ::close(descriptor);
        return cannot_write(error);
    }
    stream_.reset(::fdopen(descriptor, "w"));
    if (stream_) return {};
    const int error = errno;
    ::close(descriptor);
    return cannot_write(error);
}

tl::expected<void, std::string> OutputFile::commit() {
    const bool failed_before = std::ferror(stream_.get()) != 0;
    errno = 0;
    if (std::fclose(stream_.release()) != 0 || failed_before) return cannot_write(errno != 0 ? errno : EIO);
    if (temporary_.empty()) return {};
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) return cannot_write(errno);
    temporary_.clear();
    return {};
}

tl::unexpected<std::string> OutputFile::cannot_write(int error) const {
    return tl::unexpected(
        fmt::format("cannot write '{}': {}", shown_path_.string(), std::generic_category().message(error)));
}

tl::expected<void, std::string> write_file(const fs::path& path, std::string_view contents) {
    tl::expected<OutputFile, std::string> file = OutputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    std::fwrite(contents.data(), 1, contents.size(), file->stream());
    return file->commit();
}

}  // namespace gsim::simulation
