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

// Returns a file in memory that holds `text`, to be read from its beginning; null with errno if that fails.
FileHandle temporary_file(const std::string& text) {
    FileHandle file = os::open_memory_file("plot");
    if (!file) return nullptr;
    const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
    if (!written || std::fflush(file.get()) != 0) return nullptr;
    std::rewind(file.get());
    return file;
}

std::string read_file_text(std::FILE* file) {
    std::rewind(file);
    std::string text;
    std::array<char, 1U << 16U> bytes;
    while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file))
        text.append(bytes.data(), count);
    return text;
}

std::string drawing_error(const std::filesystem::path& path, const std::string& reason) {
    return fmt::format("cannot draw '{}': {}", path.string(), reason);
}

}  // namespace

// Without this check a run would end before it writes its output.
Result<void> find_gnuplot() {
    const FileHandle input(std::fopen("/dev/null", "re"));
    const FileHandle output(std::fopen("/dev/null", "we"));
    if (!input || !output) return {};
    return os::run_child({"gnuplot", "--version"}, input.get(), output.get());
}

Result<std::string> draw_picture(const std::string& script) {
    const FileHandle input = temporary_file(script);
    const FileHandle output = os::open_memory_file("picture");  // gnuplot does not report a full disk
    if (!input || !output) {
        return Unexpected(
            fmt::format("cannot create a file in memory: {}", std::generic_category().message(errno)));
    }
    // -d ignores the user's settings.
    if (auto done = os::run_child({"gnuplot", "-d"}, input.get(), output.get()); !done)
        return tl::unexpected(done.error());
    std::string picture = read_file_text(output.get());
    if (picture.empty()) return Unexpected("gnuplot created no picture");
    return picture;
}

Result<Picture> Picture::picture_for_file(const std::filesystem::path& path) {
    const bool bitmap = path.extension() == ".png";
    if (!bitmap && path.extension() != ".svg")
        return tl::unexpected(drawing_error(path, "the name of a picture must end in .svg or .png"));
    if (auto writable = OutputFile::check(path); !writable) return tl::unexpected(writable.error());
    if (auto found = find_gnuplot(); !found)
        return tl::unexpected(drawing_error(path, found.error().message));
    return Picture(path, bitmap);
}

Result<void> Picture::draw(const std::string& text) const {
    auto picture = OutputFile::open(path_);
    if (!picture) return tl::unexpected(picture.error());
    const auto drawn_picture = draw_picture(text);
    if (!drawn_picture) return tl::unexpected(drawing_error(path_, drawn_picture.error().message));
    picture->write(*drawn_picture);
    return picture->commit();
}

}  // namespace gsim::engine
