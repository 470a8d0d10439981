#include "runtime/simulation/plot.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "runtime/simulation/child_process.h"
#include "runtime/simulation/output_file.h"
#include "runtime/simulation/plot_script.h"

namespace gsim::simulation {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::optional<PictureFormat> format_of(const std::filesystem::path& path) {
    if (path.extension() == ".svg") return PictureFormat::svg;
    if (path.extension() == ".png") return PictureFormat::png;
    return std::nullopt;
}

// A nameless file that holds `text`, to be read from its beginning; null with errno where that fails.
File temporary_file(const std::string& text) {
    File file(std::tmpfile());
    if (!file) return nullptr;
    const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
    if (!written || std::fflush(file.get()) != 0) return nullptr;
    std::rewind(file.get());
    return file;
}

}  // namespace

tl::expected<void, std::string> make_plot(const PlotData& data, const std::filesystem::path& path,
                                          std::string_view title) {
    const auto format = format_of(path);
    if (!format) {
        return tl::unexpected(
            fmt::format("cannot draw '{}': a picture's name ends in .svg or .png", path.string()));
    }
    auto picture = OutputFile::open(path);
    if (!picture) return tl::unexpected(picture.error());
    const File script = temporary_file(plot_script(data, *format, title));
    if (!script) {
        return tl::unexpected(
            fmt::format("cannot make a temporary file: {}", std::generic_category().message(errno)));
    }
    // -d keeps the user's settings out.
    const auto drawn = run_child({"gnuplot", "-d"}, script.get(), picture->stream());
    if (!drawn) return tl::unexpected(fmt::format("cannot draw '{}': {}", path.string(), drawn.error()));
    return picture->commit();
}

}  // namespace gsim::simulation
