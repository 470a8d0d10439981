#include "lexer/source.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/os/memory_file.h"

namespace gsim::lexer {

std::string file_error(const std::string& path, int error_number) {
    return fmt::format("{}: {}", path, std::strerror(error_number));
}

tl::expected<Source, std::string> Source::open(const std::string& path, os::NameSource name_source) {
    Source source;
    source.name_ = path;
    auto file = os::open_input(path, name_source);
    if (!file) return tl::unexpected(fmt::format("{}: {}", path, file.error().message));
    source.file_ = *std::move(file);
    struct stat info {};
    if (::fstat(::fileno(source.file_.get()), &info) != 0) return tl::unexpected(file_error(path, errno));
    if (!S_ISREG(info.st_mode)) return spool(source.file_.get(), path);
    source.size_ = static_cast<std::uint64_t>(info.st_size);
    return source;
}

tl::expected<Source, std::string> Source::open(const os::Files& files, const std::string& path,
                                               os::NameSource name_source) {
    if (files.are_system_files()) return open(path, name_source);
    auto text = files.read(path, name_source, std::numeric_limits<std::size_t>::max());
    if (!text) return tl::unexpected(std::move(text.error().message));
    return from_text(*std::move(text), path);
}

tl::expected<Source, std::string> Source::spool(std::FILE* stream, std::string name) {
    Source source;
    source.name_ = std::move(name);
    source.file_.reset(std::tmpfile());
    // A confined program may have no access to a folder for temporary files.
    if (!source.file_) source.file_ = os::open_memory_file("spool");
    if (!source.file_)
        return tl::unexpected("cannot create a temporary file for " + source.name_ + ": " +
                              std::strerror(errno));
    std::array<char, 65536> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stream)) {
        if (std::fwrite(buffer.data(), 1, count, source.file_.get()) != count) {
            return tl::unexpected("temporary file: " + std::string(std::strerror(errno)));
        }
        source.size_ += count;
    }
    if (std::ferror(stream) != 0) return tl::unexpected(file_error(source.name_, errno));
    if (std::fflush(source.file_.get()) != 0) {
        return tl::unexpected("temporary file: " + std::string(std::strerror(errno)));
    }
    return source;
}

Source Source::from_text(std::string text, std::string name) {
    Source source;
    source.name_ = std::move(name);
    source.text_ = std::move(text);
    source.size_ = source.text_.size();
    return source;
}

std::size_t Source::read_at(std::uint64_t offset, char* buffer, std::size_t capacity) const {
    if (!file_) {
        const std::size_t count =
            std::min<std::size_t>(capacity, offset < text_.size() ? text_.size() - offset : 0);
        if (count > 0) std::memcpy(buffer, text_.data() + offset, count);
        return count;
    }
    ssize_t count = 0;
    do {
        count = ::pread(::fileno(file_.get()), buffer, capacity, static_cast<off_t>(offset));
    } while (count < 0 && errno == EINTR);
    if (count < 0 && error_ == 0) error_ = errno;
    return count < 0 ? 0 : static_cast<std::size_t>(count);
}

std::size_t Source::read(char* buffer, std::size_t capacity) {
    ended_early_ = ended_early_ || (ends_ && ends_());
    if (ended_early_ || at_end_) return 0;
    const std::size_t count = read_at(position_, buffer, capacity);
    at_end_ = count == 0;
    position_ += count;
    return count;
}

std::optional<std::string> Source::error_message() const {
    if (error_ == 0) return std::nullopt;
    return fmt::format("{}: cannot be read to its end: {}", name_, std::strerror(error_));
}

void Source::rewind() {
    position_ = 0;
    at_end_ = false;
}

std::string Source::line_at(std::uint64_t line_begin, std::size_t max_bytes) const {
    std::string line;
    std::array<char, 512> buffer;
    while (line.size() < max_bytes) {
        const std::size_t requested = std::min(buffer.size(), max_bytes - line.size());
        const std::size_t count = read_at(line_begin + line.size(), buffer.data(), requested);
        const std::string_view part(buffer.data(), count);
        const std::size_t end = part.find('\n');
        line.append(part.substr(0, end));
        if (count == 0 || end != std::string_view::npos) break;
    }
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
}

}  // namespace gsim::lexer
