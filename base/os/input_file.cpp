#include "base/os/input_file.h"

#include <array>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/os/descriptor.h"

namespace gsim::os {

namespace {

constexpr std::size_t kInputChunk = std::size_t{1} << 16U;
constexpr unsigned kMiBShift = 20;

std::string reason(int error) {
    return std::generic_category().message(error);
}

const char* file_type_text(mode_t mode) {
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

// Returns the error of an open file.
std::optional<Error> find_error(int descriptor, NameSource name_source) {
    struct stat info {};
    if (::fstat(descriptor, &info) != 0) return reason(errno);
    if (S_ISDIR(info.st_mode)) return reason(EISDIR);
    if (S_ISREG(info.st_mode) || name_source == NameSource::command_line) return {};
    return std::string("it is ") + file_type_text(info.st_mode) +
           "; a file or script may name only regular files, the command line any file";
}

std::string input_error(const std::filesystem::path& path, const std::string& cause) {
    return "cannot read '" + path.string() + "': " + cause;
}

}  // namespace

Result<InputFile> open_input(const std::filesystem::path& path, NameSource name_source) {
    // The file is opened without waiting to find out its type; a pipe of the command line is waited for
    // instead.
    const int waiting = name_source == NameSource::command_line ? 0 : O_NONBLOCK;
    const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | waiting);
    if (number < 0) return tl::unexpected(reason(errno));
    Descriptor descriptor(number);
    if (auto error = find_error(number, name_source)) return tl::unexpected(*std::move(error));
    if (waiting != 0 && ::fcntl(number, F_SETFL, 0) != 0) return tl::unexpected(reason(errno));
    InputFile file(::fdopen(number, "rb"));
    if (!file) return tl::unexpected(reason(errno));
    descriptor.release();
    return file;
}

Result<std::string> read_input(const std::filesystem::path& path, NameSource name_source,
                               std::size_t max_bytes) {
    const auto file = open_input(path, name_source);
    if (!file) return tl::unexpected(input_error(path, file.error().message));
    std::string text;
    std::array<char, kInputChunk> chunk;
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file->get())) {
        if (std::ferror(file->get()) != 0) break;
        text.append(chunk.data(), count);
        if (text.size() > max_bytes) {
            return tl::unexpected(too_large(path, max_bytes));
        }
    }
    if (std::ferror(file->get()) != 0) return tl::unexpected(input_error(path, reason(errno)));
    return text;
}

std::string too_large(const std::filesystem::path& path, std::size_t max_bytes) {
    return "'" + path.string() + "' is larger than " + std::to_string(max_bytes >> kMiBShift) + " MiB";
}

Result<std::string> read_text_file(const std::filesystem::path& path, NameSource name_source) {
    return read_input(path, name_source, kMaxTextFileBytes);
}

}  // namespace gsim::os
