#include "runtime/machine/text_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{4} << 20;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

tl::unexpected<std::string> cannot_read(const std::filesystem::path& path, int error) {
    return tl::unexpected(
        fmt::format("cannot read '{}': {}", path.string(), std::generic_category().message(error)));
}

}  // namespace

tl::expected<std::string, std::string> read_text_file(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) return cannot_read(path, errno);
    std::string text;
    char chunk[1 << 14];
    while (const std::size_t count = std::fread(chunk, 1, sizeof chunk, file.get())) {
        text.append(chunk, count);
        if (text.size() > kMaxBytes) {
            return tl::unexpected(
                fmt::format("'{}' is larger than 4 MiB, which no such file is", path.string()));
        }
    }
    if (std::ferror(file.get()) != 0) return cannot_read(path, errno);
    return text;
}

}  // namespace gsim::machine
