#include "cam/drawing/drawing_file.h"

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "cam/drawing/dxf_reader.h"
#include "cam/drawing/svg_reader.h"

namespace gsim::drawing {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

}  // namespace

Result<Drawing> read_drawing(const std::filesystem::path& path, const ReadOptions& options,
                             os::NameSource name_source, const os::Files& files) {
    const std::string extension = text::lower(path.extension().string());
    if (extension != ".dxf" && extension != ".svg") {
        return Unexpected(fmt::format("'{}' is neither a .dxf nor an .svg file", path.string()));
    }
    const Result<std::string> text = files.read(path, name_source, kMaxBytes);
    if (!text) return tl::unexpected(text.error());
    auto drawing = extension == ".dxf" ? read_dxf(*text, options) : read_svg(*text, options);
    if (!drawing) return Unexpected(fmt::format("{}: {}", path.string(), drawing.error().message));
    return drawing;
}

}  // namespace gsim::drawing
