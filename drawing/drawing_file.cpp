#include "drawing/drawing_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "drawing/dxf_reader.h"
#include "drawing/svg_reader.h"
#include "text/letter_case.h"

namespace gsim::drawing {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

tl::unexpected<std::string> cannot_read(const std::filesystem::path& path, int error) {
    return tl::unexpected(
        fmt::format("cannot read '{}': {}", path.string(), std::generic_category().message(error)));
}

tl::expected<std::string, std::string> read_bytes(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) return cannot_read(path, errno);
    std::string text;
    char chunk[1 << 16];
    while (const std::size_t count = std::fread(chunk, 1, sizeof chunk, file.get())) {
        text.append(chunk, count);
        if (text.size() > kMaxBytes) {
            return tl::unexpected(fmt::format("'{}' is larger than {} MiB", path.string(), kMaxBytes >> 20));
        }
    }
    if (std::ferror(file.get()) != 0) return cannot_read(path, errno);
    return text;
}

}  // namespace

tl::expected<Drawing, std::string> read_drawing(const std::filesystem::path& path,
                                                const ReadOptions& options) {
    const std::string ending = text::lower(path.extension().string());
    if (ending != ".dxf" && ending != ".svg") {
        return tl::unexpected(fmt::format("'{}' is neither a .dxf nor an .svg file", path.string()));
    }
    const tl::expected<std::string, std::string> text = read_bytes(path);
    if (!text) return tl::unexpected(text.error());
    auto drawing = ending == ".dxf" ? read_dxf(*text, options) : read_svg(*text, options);
    if (!drawing) return tl::unexpected(fmt::format("{}: {}", path.string(), drawing.error()));
    return drawing;
}

}  // namespace gsim::drawing
