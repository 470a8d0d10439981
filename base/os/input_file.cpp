#include "base/os/input_file.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/os/descriptor.h"

namespace gsim::os {

namespace {

constexpr std::size_t kInputChunk = std::size_t{1} << 16U;
constexpr unsigned kBitsOfMiB = 20;

std::string reason(int error) {
    return std::generic_category().message(error);
}

const char* kind_of(mode_t mode) {
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

// Returns the error of an open file; empty if it has none.
std::string find_fault(int descriptor, NamedBy named_by) {
    struct stat info {};
    if (::fstat(descriptor, &info) != 0) return reason(errno);
    if (S_ISDIR(info.st_mode)) return reason(EISDIR);
    if (S_ISREG(info.st_mode) || named_by == NamedBy::command_line) return {};
    return std::string("it is ") + kind_of(info.st_mode) +
           "; a file or script may name regular files only, the command line anything";
}

std::string cannot_read_input(const std::filesystem::path& path, const std::string& why) {
    return "cannot read '" + path.string() + "': " + why;
}

}  // namespace

tl::expected<InputFile, std::string> open_input(const std::filesystem::path& path, NamedBy named_by) {
    // The file is opened without waiting to find out its type; a pipe of the command line is waited for
    // instead.
    const int waiting = named_by == NamedBy::command_line ? 0 : O_NONBLOCK;
    const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | waiting);
    if (number < 0) return tl::unexpected(reason(errno));
    Descriptor descriptor(number);
    if (std::string fault = find_fault(number, named_by); !fault.empty()) return tl::unexpected(fault);
    if (waiting != 0 && ::fcntl(number, F_SETFL, 0) != 0) return tl::unexpected(reason(errno));
    InputFile file(::fdopen(number, "rb"));
    if (!file) return tl::unexpected(reason(errno));
    descriptor.release();
    return file;
}

tl::expected<std::string, std::string> read_input(const std::filesystem::path& path, NamedBy named_by,
                                                  std::size_t max_bytes) {
    const auto file = open_input(path, named_by);
    if (!file) return tl::unexpected(cannot_read_input(path, file.error()));
    std::string text;
    std::array<char, kInputChunk> chunk;
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file->get())) {
        if (std::ferror(file->get()) != 0) break;
        text.append(chunk.data(), count);
        if (text.size() > max_bytes) {
            return tl::unexpected(too_large(path, max_bytes));
        }
    }
    if (std::ferror(file->get()) != 0) return tl::unexpected(cannot_read_input(path, reason(errno)));
    return text;
}

std::string too_large(const std::filesystem::path& path, std::size_t max_bytes) {
    return "'" + path.string() + "' is larger than " + std::to_string(max_bytes >> kBitsOfMiB) + " MiB";
}

tl::expected<std::string, std::string> read_text_file(const std::filesystem::path& path, NamedBy named_by) {
    return read_input(path, named_by, kMaxTextFileBytes);
}

}  // namespace gsim::os
