#include "engine/system/picture.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "base/os/child_process.h"
#include "base/os/file_handle.h"
#include "base/os/memory_file.h"
#include "base/os/output_file.h"

namespace gsim::engine {

namespace {

using os::FileHandle;
using os::OutputFile;

// A file in memory that holds `text`, to be read from its beginning; null with errno where that fails.
FileHandle temporary_file(const std::string& text) {
    FileHandle file = os::file_in_memory("plot");
    if (!file) return nullptr;
    const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
    if (!written || std::fflush(file.get()) != 0) return nullptr;
    std::rewind(file.get());
    return file;
}

// Writes all of it; false where there is nothing.
bool copy(std::FILE* drawn, OutputFile& picture) {
    std::rewind(drawn);
    std::array<char, 1U << 16U> bytes;
    std::size_t copied = 0;
    while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), drawn)) {
        picture.write({bytes.data(), count});
        copied += count;
    }
    return copied != 0;
}

// Without it a run would end before what it was made for.
tl::expected<void, std::string> find_gnuplot() {
    const FileHandle input(std::fopen("/dev/null", "re"));
    const FileHandle output(std::fopen("/dev/null", "we"));
    if (!input || !output) return {};
    return os::run_child({"gnuplot", "--version"}, input.get(), output.get());
}

std::string cannot_draw(const std::filesystem::path& path, const std::string& why) {
    return fmt::format("cannot draw '{}': {}", path.string(), why);
}

}  // namespace

tl::expected<Picture, std::string> Picture::named(const std::filesystem::path& path) {
    const bool bitmap = path.extension() == ".png";
    if (!bitmap && path.extension() != ".svg")
        return tl::unexpected(cannot_draw(path, "a picture's name ends in .svg or .png"));
    if (auto writable = OutputFile::check(path); !writable) return tl::unexpected(writable.error());
    if (auto found = find_gnuplot(); !found) return tl::unexpected(cannot_draw(path, found.error()));
    return Picture(path, bitmap);
}

tl::expected<void, std::string> Picture::draw(const std::string& text) const {
    auto picture = OutputFile::open(path_);
    if (!picture) return tl::unexpected(picture.error());
    const FileHandle script = temporary_file(text);
    const FileHandle drawing = os::file_in_memory("picture");  // gnuplot says nothing of a full disk
    if (!script || !drawing) {
        return tl::unexpected(
            fmt::format("cannot make a file in memory: {}", std::generic_category().message(errno)));
    }
    // -d keeps the user's settings out.
    const auto drawn = os::run_child({"gnuplot", "-d"}, script.get(), drawing.get());
    if (!drawn) return tl::unexpected(cannot_draw(path_, drawn.error()));
    if (!copy(drawing.get(), *picture))
        return tl::unexpected(cannot_draw(path_, "gnuplot has drawn nothing"));
    return picture->commit();
}

}  // namespace gsim::engine
