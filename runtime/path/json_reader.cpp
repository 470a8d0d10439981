#include "runtime/path/json_reader.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "runtime/path/json_handler.h"
#include "runtime/path/validate.h"

namespace gsim::path {

tl::expected<PathFile, std::string> read_json(std::function<std::size_t(char*, std::size_t)> read,
                                              std::string file_name) {
    // Not on the stack: it holds a large buffer.
    const auto bytes = std::make_unique<JsonBytes>(std::move(read));
    JsonHandler handler(*bytes, std::move(file_name));
    if (!nlohmann::json::sax_parse(JsonBytes::Iterator(*bytes), JsonBytes::Iterator(), &handler)) {
        return tl::unexpected(handler.error());
    }
    tl::expected<PathFile, std::string> file = handler.finish();
    if (!file) return file;
    if (const auto fault = validate(file->program)) {
        return tl::unexpected(file->located(fault->where, fault->sentence));
    }
    return file;
}

tl::expected<PathFile, std::string> read_json(std::string_view text, std::string file_name) {
    const auto read = [&text](char* buffer, std::size_t size) {
        const std::size_t count = text.copy(buffer, size);
        text.remove_prefix(count);
        return count;
    };
    return read_json(read, std::move(file_name));
}

tl::expected<PathFile, std::string> load_json(const std::filesystem::path& path) {
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    const auto cannot_read = [&path](int error) {
        return tl::unexpected(
            fmt::format("cannot read '{}': {}", path.string(), std::generic_category().message(error)));
    };
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) return cannot_read(errno);
    auto read = [&file](char* buffer, std::size_t size) { return std::fread(buffer, 1, size, file.get()); };
    tl::expected<PathFile, std::string> result = read_json(read, path.string());
    if (std::ferror(file.get()) != 0) return cannot_read(errno);
    return result;
}

}  // namespace gsim::path
